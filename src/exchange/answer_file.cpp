#include "exchange/answer_file.hpp"

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/user_error.hpp"
#include "exchange/json.hpp"

namespace manifuzz {

Answer AnswerFile::at(std::size_t index, const PairCase& pair) {
  while (read_ < index) next_line();
  const Line line = next_line();
  try {
    if (line.too_long) throw UserError("longer than 1 MiB");
    const JsonTree tree = parse_json(line.text);
    return read_reported_answer(JsonView(tree), pair);
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}:{}: {}", file_.name(), line.number, error.what()));
  }
}

void AnswerFile::expect_end() {
  const auto line = next_filled();
  if (!line) return;
  throw UserError(fmt::format("{}:{}: an answer more than there are cases; one a case is expected",
                              file_.name(), line->number));
}

std::optional<Line> AnswerFile::next_filled() {
  auto line = lines_.next();
  while (line && line->is_blank()) line = lines_.next();
  return line;
}

Line AnswerFile::next_line() {
  const auto line = next_filled();
  ++read_;
  if (line) return *line;
  throw UserError(file_.name() + ": ends before the cases do; an answer a case is expected");
}

}  // namespace manifuzz
