#include "judging/judge.hpp"

#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "exchange/json.hpp"
#include "judging/manifold_error.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

struct JudgeArguments {
  SubjectAndOracle colliders;
  std::string manifolds;
  std::string file = "-";
};

int judge_cases(const JudgeArguments& options) {
  const SubjectAndOracle& asked = options.colliders;
  if (const OtherKind* const kind = kind_for(asked.subject)) {
    expect_none_of(*kind, {{"--oracle", asked.oracle.is_chosen},
                           {"--oracle-command", !asked.oracle.command.empty()},
                           {"--manifolds", !options.manifolds.empty()}});
    return kind->judge(asked.subject, asked.external, options.file);
  }
  const Collider subject = find_collider(asked.subject, asked.external);
  const Collider oracle = find_collider(asked.oracle, asked.external);
  if (options.manifolds == "-" && options.file == "-") {
    throw UserError("--manifolds: the cases are read from stdin, too; name a file for one of them");
  }
  std::optional<AnswerFile> answers;
  if (!options.manifolds.empty()) {
    answers.emplace(options.manifolds, conventions_of(subject.declaration));
  }
  // A program that takes an engine's name for its own is not excused by that engine's faults.
  const bool is_named = asked.subject.command.empty() && find_entry(asked.subject.name) != nullptr;
  bool unexplained = false;
  const auto answer = [&](const AnyCase& any, std::size_t index, std::string& line) {
    const auto& pair = std::get<PairCase>(any);
    const auto truth = std::make_shared<const exact::Truth>(pair);
    const Admissible right = admissible(truth, subject.declaration);
    const Answer of_subject = answers ? whole(answers->at(index, pair), right, subject.declaration)
                                      : subject.collide(pair);
    const ColliderAnswer asked_subject{subject.declaration, of_subject};
    Judgement judgement = judge(truth, asked_subject, {oracle.declaration, oracle.collide(pair)});
    if (is_named) explain_subject(truth, asked_subject, judgement);
    append_judgement(line, right, asked_subject, judgement);
    unexplained = unexplained || is_unexplained(judgement.bucket.verdict);
  };
  answer_each(options.file, CaseKind::pair, answer);
  if (answers) answers->expect_end();
  return unexplained ? 1 : 0;
}

void add_judge_arguments(CLI::App& app, JudgeArguments& options) {
  add_subject_and_oracle(app, options.colliders);
  add_sequences(app, options.colliders.subject);
  app.add_option("--manifolds", options.manifolds,
                 "read the subject's answers from this file, one line a case, instead of asking "
                 "the subject")
      ->type_name("FILE");
  add_file_of_cases(app, options.file);
}

}  // namespace

Run define_judge(CLI::App& app) {
  return define<JudgeArguments, add_judge_arguments, judge_cases>(app);
}

}  // namespace manifuzz
