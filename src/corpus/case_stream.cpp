#include "corpus/case_stream.hpp"

#include <iterator>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/streams.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

/// Writes answers, and errors in the place of those that are missing.
class AnswerWriter {
 public:
  explicit AnswerWriter(const AnswerCase& answer) : answer_(answer) {}

  /// The answer to the case that `read` gives.
  template <class Read>
  void write(std::size_t line_number, Read read) {
    line_.clear();
    ++lines_;
    try {
      answer_(read(), lines_ - 1, line_);
    } catch (const UserError& error) {
      if (bad_++ == 0) {
        first_bad_line_ = line_number;
        first_error_ = error.what();
      }
      line_ = "{\"error\": ";
      append_string(line_, error.what());
      fmt::format_to(std::back_inserter(line_), ", \"line\": {}}}", line_number);
    }
    out_.write(line_ += '\n');
  }

  void flush() { out_.flush(); }

  /// To be called once, at the end; `numbered` where the line helps to find the error.
  void finish(const std::string& file_name, bool numbered) {
    flush();
    if (lines_ == 0) throw UserError(file_name + ": is empty; one case a line is expected");
    if (bad_ == 0) return;
    const std::string line = numbered ? fmt::format(":{}", first_bad_line_) : "";
    const std::string count = numbered ? fmt::format(" ({} bad of {})", bad_, lines_) : "";
    throw UserError(fmt::format("{}{}: {}{}", file_name, line, first_error_, count));
  }

 private:
  const AnswerCase& answer_;
  Output out_;
  std::string line_;
  std::size_t lines_ = 0;
  std::size_t bad_ = 0;
  std::size_t first_bad_line_ = 0;
  std::string first_error_;
};

}  // namespace

void answer_each(const std::string& path, const AnswerCase& answer) {
  InputFile file(path);
  AnswerWriter answers(answer);
  const bool is_one_case = path.ends_with(".json");
  if (is_one_case) {
    const std::string text = file.read_all();
    answers.write(1, [&] { return parse_case(text, FormatKey::required).pair; });
  } else {
    LineReader lines(file, [&] { answers.flush(); });
    while (const auto line = lines.next()) {
      if (!line->is_blank()) answers.write(line->number, [&] { return parse_line(*line).pair; });
    }
  }
  answers.finish(file.name(), !is_one_case);
}

}  // namespace manifuzz
