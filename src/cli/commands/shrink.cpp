#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/save.hpp"
#include "cli/colliders.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

struct ShrinkArguments {
  CaseArgument given;
  SubjectAndOracle colliders;
  std::string output = "-";
};

int shrink_file(const ShrinkArguments& options) {
  const SubjectAndOracle& asked = options.colliders;
  const Collider subject = find_collider(asked.subject, asked.external);
  const Collider oracle = find_collider(asked.oracle, asked.external);
  const std::string file = case_file(options.given);
  check_outputs({{{"--output", options.output}}, {file}});
  const CorpusCase given = read_case_file(file);
  Interruption interruption(kUntilSignal);
  const Judgement root = judge_in_child(given.pair, subject, oracle, interruption);
  if (root.bucket.verdict == Verdict::agree) {
    throw UserError(
        fmt::format("{}: {} and {} agree on it; a case on which they differ is expected", file,
                    subject.declaration.name, oracle.declaration.name));
  }
  const PairCase smallest = shrink_finding(given.pair, subject, oracle, interruption).pair;
  const Judgement judgement = judge_in_child(smallest, subject, oracle, interruption);
  CorpusCase shrunk = recorded_case(smallest, judgement, subject, oracle, interruption);
  shrunk.found = given.found;
  const std::string text = format_case(shrunk);
  options.output == "-" ? write_output(text) : write_file(options.output, text);
  return 0;
}

void add_shrink_arguments(CLI::App& app, ShrinkArguments& options) {
  add_case_argument(app, options.given);
  add_subject_and_oracle(app, options.colliders);
  app.add_option("--output", options.output, "where the smallest case goes, - for stdout")
      ->type_name("FILE")
      ->capture_default_str();
}

}  // namespace

const Command kShrink{
    "shrink", "The smallest case with the same verdict, bucket and about the magnitude.",
    "manifuzz generate --seed 2 --regime tie_bias --cases 1 | manifuzz shrink - --output "
    "smallest.json",
    define<ShrinkArguments, add_shrink_arguments, shrink_file>};

}  // namespace manifuzz
