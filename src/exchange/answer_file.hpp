#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/file.hpp"
#include "collider/collider.hpp"

namespace manifuzz {

/// A collider's answers in a file: a line a case, in order, as programs answer them; blank lines
/// are skipped. What is wrong is a UserError that names the file and the line.
class AnswerFile {
 public:
  explicit AnswerFile(const std::string& path) : file_(path), lines_(file_) {}

  /// Answer number `index`, from 0 and never backwards, to this case.
  Answer at(std::size_t index, const PairCase& pair);

  /// Throws where there are more answers.
  void expect_end();

 private:
  std::optional<Line> next_filled();
  Line next_line();

  InputFile file_;
  LineReader lines_;
  std::size_t read_ = 0;
};

}  // namespace manifuzz
