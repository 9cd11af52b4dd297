#include "judging/judge.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json_tree.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "cli/answer_each.hpp"
#include "cli/collider_options.hpp"
#include "cli/commands.hpp"
#include "exchange/json.hpp"
#include "judging/completed.hpp"

namespace manifuzz {
namespace {

struct Options {
  ComparedColliders parties;
  std::string manifolds;
  std::string file = "-";
};

/// The subject's answers, from a file instead of the subject: a line a case, in order.
class AnswerFile {
 public:
  explicit AnswerFile(const std::string& path) : file_(path), lines_(file_) {}

  /// Answer number `index`, from 0 and never backwards; what it leaves out is as `right` has it.
  Answer at(std::size_t index, const Admissible& right) {
    while (read_ < index) next_line();
    const Line line = next_line();
    try {
      if (line.too_long) throw UserError("longer than 1 MiB");
      const JsonTree tree = parse_json(line.text);
      return completed(read_reported_answer(JsonView(tree), right.pair()), right);
    } catch (const UserError& error) {
      throw UserError(fmt::format("{}:{}: {}", file_.name(), line.number, error.what()));
    }
  }

  void expect_end() {
    const auto line = next_filled();
    if (!line) return;
    throw UserError(
        fmt::format("{}:{}: an answer more than there are cases; one a case is expected",
                    file_.name(), line->number));
  }

 private:
  std::optional<Line> next_filled() {
    auto line = lines_.next();
    while (line && line->is_blank()) line = lines_.next();
    return line;
  }
  Line next_line() {
    const auto line = next_filled();
    ++read_;
    if (line) return *line;
    throw UserError(file_.name() + ": ends before the cases do; an answer a case is expected");
  }

  InputFile file_;
  LineReader lines_;
  std::size_t read_ = 0;
};

/// The largest bound of the points of the first right manifold; `least` where there are none.
template <class Bound>
double widest(const Admissible& right, double least, const Bound& bound) {
  if (right.candidates.empty()) return least;
  const exact::Clip& first = *right.candidates.front();
  double most = least;
  for (int i = 0; i < first.count; ++i) most = std::max(most, bound(right, first, first.points[i]));
  return most;
}

void append_key(std::string& line, std::string_view key, double value) {
  line += key;
  if (std::isfinite(value)) {
    append_number(line, value);
  } else {
    line += "null";
  }
}

void append_admissible(std::string& line, const Admissible& right) {
  line += ", \"admissible\": [";
  std::string_view separator;
  for (const Manifold<double>& manifold : right_manifolds(right)) {
    line += separator;
    append_manifold_object(line, right.pair(), manifold);
    separator = ", ";
  }
  line += ']';
}

void append_judgement(std::string& line, const Admissible& right, const Judgement& judgement) {
  const exact::Truth& truth = *right.truth;
  const double condition = right.candidates.empty() ? NAN : 1 / right.candidates.front()->cosine;
  append_key(line, "{\"separation\": ", leading(truth.fine_separation(truth.greatest())));
  line += ", \"touching\": ";
  line += standing(truth).touching ? "true" : "false";
  append_admissible(line, right);
  append_key(line, ", \"condition\": ", condition);
  append_key(line, ", \"bound\": {\"separation\": ", right.bounds.separation);
  append_key(line, ", \"position\": ", widest(right, right.bounds.position, position_bound));
  append_key(line, ", \"depth\": ", widest(right, right.bounds.separation, depth_bound));
  append_key(line, ", \"normal\": ", right.bounds.normal);
  line += "}, \"verdict\": ";
  append_string(line, to_string(judgement.bucket.verdict));
  line += ", \"bucket\": ";
  append_string(line, to_string(judgement.bucket));
  line += '}';
}

int judge_cases(const Options& options) {
  const Collider subject = find_subject(options.parties);
  const Collider oracle = find_oracle(options.parties);
  if (options.manifolds == "-" && options.file == "-") {
    throw UserError("--manifolds: stdin is where the cases come from; name a file for one of them");
  }
  std::optional<AnswerFile> answers;
  if (!options.manifolds.empty()) answers.emplace(options.manifolds);
  bool unexplained = false;
  answer_each(options.file, [&](const PairCase& pair, std::size_t index, std::string& line) {
    const auto truth = std::make_shared<const exact::Truth>(pair);
    const Admissible right = admissible(truth, subject.declaration);
    const Answer of_subject = answers ? answers->at(index, right) : subject.collide(pair);
    const Judgement judgement =
        judge(truth, {subject.declaration, of_subject}, {oracle.declaration, oracle.collide(pair)});
    append_judgement(line, right, judgement);
    unexplained = unexplained || is_unexplained(judgement.bucket.verdict);
  });
  if (answers) answers->expect_end();
  return unexplained ? 1 : 0;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  add_compared_colliders(app, options->parties);
  app.add_option("--manifolds", options->manifolds,
                 "the subject's answers, a line a case, in place of the subject's own")
      ->type_name("FILE");
  app.add_option("FILE", options->file,
                 "*.json: one case; else a case a line; - or nothing: stdin");
  return [options] { return judge_cases(*options); };
}

}  // namespace

extern const Command kJudge;
const Command kJudge{"judge", "Cases in, what is right and who is, a JSON object a line.",
                     "manifuzz generate --seed 1 --regime sliver --cases 10 | manifuzz judge\n"
                     "manifuzz generate --seed 1 --regime boxes --cases 10 > cases.jsonl\n"
                     "manifuzz collide --collider box2d cases.jsonl > answers.jsonl\n"
                     "manifuzz judge --subject box2d --manifolds answers.jsonl cases.jsonl",
                     define};

}  // namespace manifuzz
