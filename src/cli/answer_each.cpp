#include "cli/answer_each.hpp"

#include <iterator>

#include <fmt/format.h>

#include "cases/corpus.hpp"
#include "cases/file.hpp"
#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "cli/output.hpp"

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
      answer_(read(), line_);
    } catch (const UserError& error) {
      if (bad_++ == 0) first_error_ = fmt::format("{}: {}", line_number, error.what());
      line_ = "{\"error\": ";
      append_string(line_, error.what());
      fmt::format_to(std::back_inserter(line_), ", \"line\": {}}}", line_number);
    }
    out_.write(line_ += '\n');
  }

  void flush() { out_.flush(); }

  /// To be called once, at the end.
  void finish(const std::string& file_name) {
    flush();
    if (lines_ == 0) throw UserError(file_name + ": is empty; one case a line is expected");
    if (bad_ == 0) return;
    throw UserError(
        fmt::format("{}:{} ({} of {} cases bad)", file_name, first_error_, bad_, lines_));
  }

 private:
  const AnswerCase& answer_;
  Output out_;
  std::string line_;
  std::size_t lines_ = 0;
  std::size_t bad_ = 0;
  std::string first_error_;
};

}  // namespace

void answer_each(const std::string& path, const AnswerCase& answer) {
  InputFile file(path);
  AnswerWriter answers(answer);
  if (path.ends_with(".json")) {
    const std::string text = file.read_all();
    answers.write(1, [&] { return parse_case(text, FormatKey::required).pair; });
  } else {
    LineReader lines(file, [&] { answers.flush(); });
    while (const auto line = lines.next()) {
      if (!line->is_blank()) answers.write(line->number, [&] { return parse_line(*line).pair; });
    }
  }
  answers.finish(file.name());
}

}  // namespace manifuzz
