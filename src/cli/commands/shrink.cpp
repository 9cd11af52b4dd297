#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/known.hpp"
#include "campaign/save.hpp"
#include "cli/colliders.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct ShrinkArguments {
  CaseArgument given;
  SubjectAndOracle colliders{{"subject", "", ""}, {"oracle", "", ""}, {}};
  std::string output = "-";
};

/// The smallest case that is the same finding, as a corpus has it. Throws UserError where there is
/// none, and Interrupted.
CorpusCase shrunk(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                  Interruption& interruption) {
  const Judgement root = judge_in_child(given.pair, subject, oracle, interruption);
  if (root.bucket.verdict == Verdict::agree) {
    throw UserError(
        fmt::format("{}: {} and {} agree on it; a case on which they differ is expected",
                    given.path, subject.declaration.name, oracle.declaration.name));
  }
  const Shrunk smallest = shrink_finding(given.pair, subject, oracle, interruption);
  const Judgement judgement = judge_in_child(smallest.pair, subject, oracle, interruption);
  CorpusCase result = recorded_case(smallest.pair, judgement, subject, oracle, interruption);
  result.found = given.found;
  if (result.found) result.found->is_unshrunk = !smallest.complete;
  // What is another mistake by now is not what was accepted.
  const bool is_again = given.expect && is_bucket(result.expect->bucket, given.expect->bucket);
  if (is_again) result.accepted = given.accepted;
  return result;
}

double magnitude_of(const CorpusCase& known) {
  return known.expect ? known.expect->magnitude.value_or(0) : 0;
}

/// Puts the worst seen beside the file, unless a worse one lies there already.
void keep_worst(const std::filesystem::path& file, CorpusCase worst) {
  std::error_code unknown;
  const std::filesystem::path beside = worst_beside(file);
  const bool has_worse = std::filesystem::exists(beside, unknown) &&
                         magnitude_of(read_case_file(beside.string())) >= magnitude_of(worst);
  if (has_worse) return;
  if (worst.found) worst.found->is_unshrunk = false;
  worst.accepted.reset();  // that stands in the file of the smallest
  write_worst_case(file, worst);
}

/// Writes it in the place of the case that it was shrunk from, which is the worst seen then.
std::string replace(const CorpusCase& given, const CorpusCase& smallest) {
  const std::filesystem::path old = given.path;
  const std::filesystem::path file = write_corpus_case(old.parent_path(), smallest);
  if (file == old) {
    write_file(file, format_case(smallest));
    return file.string();
  }
  std::error_code unknown;
  const bool has_worst = std::filesystem::exists(worst_beside(old), unknown);
  keep_worst(file, has_worst ? read_case_file(worst_beside(old).string()) : given);
  // Another case may have been shrunk to the same one before.
  const bool is_to_be_accepted = smallest.accepted && !read_case_file(file.string()).accepted;
  if (is_to_be_accepted) write_acceptance(file.string(), smallest.accepted);
  std::filesystem::remove(old, unknown);
  std::filesystem::remove(worst_beside(old), unknown);
  return file.string();
}

/// Whether it is a finding's own file for which there was no time.
bool is_left_unshrunk(const CorpusCase& known) {
  return known.found && known.found->is_unshrunk && known.property.empty() &&
         known.path.ends_with(".json") && !is_worst(known.path);
}

/// Shrinks one of a folder's findings where it is. Throws UserError and Interrupted.
void shrink_in_place(const CorpusCase& known, NamedColliders& colliders,
                     Interruption& interruption) {
  const Collider* const subject = colliders.subject_of(known);
  const Collider* const oracle = colliders.oracle_of(known);
  if (subject == nullptr || oracle == nullptr) {
    throw UserError(fmt::format("{}: its subject '{}' is not at hand; name it with --subject",
                                printable(known.path, 200), printable(known.expect->subject)));
  }
  write_output(replace(known, shrunk(known, *subject, *oracle, interruption)) + '\n');
}

/// Those of a folder's findings that there was no time for when they were saved.
int shrink_folder(const ShrinkArguments& options) {
  const std::filesystem::path folder = options.given.name;
  if (options.output != "-") {
    throw UserError("--output: a folder's cases are shrunk where they are; leave it out");
  }
  const Corpus corpus = read_corpus_folder(folder);
  NamedColliders colliders(find_installed_or_named({folder}),
                           given_collider(options.colliders.subject, options.colliders.external),
                           given_collider(options.colliders.oracle, options.colliders.external));
  Interruption interruption(kUntilSignal);
  int done = 0;
  std::vector<std::string> errors;
  for (const CorpusCase& known : corpus.cases) {
    if (!is_left_unshrunk(known)) continue;
    try {
      shrink_in_place(known, colliders, interruption);
      ++done;
    } catch (const UserError& error) {
      errors.emplace_back(error.what());  // the others can be shrunk all the same
    }
  }
  write_complaints(errors);
  write_remark(fmt::format("{}: {} of {} cases shrunk", printable(folder.string(), 200), done,
                           corpus.cases.size()));
  return errors.empty() ? 0 : 2;
}

int shrink_file(const ShrinkArguments& options) {
  std::error_code unknown;
  if (std::filesystem::is_directory(options.given.name, unknown)) return shrink_folder(options);
  const std::string file = case_file(options.given);
  check_outputs({{{"--output", options.output}}, {file}});
  SubjectAndOracle asked = options.colliders;
  if (!asked.subject.is_given()) asked.subject.name = "clip";
  if (!asked.oracle.is_given()) asked.oracle.name = "box2d";
  const Collider subject = find_collider(asked.subject, asked.external);
  const Collider oracle = find_collider(asked.oracle, asked.external);
  const CorpusCase given = read_case_file(file);
  Interruption interruption(kUntilSignal);
  const std::string text = format_case(shrunk(given, subject, oracle, interruption));
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
