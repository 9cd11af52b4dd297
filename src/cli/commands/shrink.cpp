#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/sequences/save_sequence.hpp"
#include "campaign/shrink_saved.hpp"
#include "cli/collider_choice.hpp"
#include "cli/options.hpp"
#include "cli/sequences/keepers.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct ShrinkArguments {
  CaseArgument given;
  SubjectAndOracle colliders{{"subject", "", ""}, {"oracle", "", ""}, {}};
  std::string subjects;
  std::string output = "-";
};

/// Those of a folder's findings that there was no time for when they were saved.
int shrink_folder(const ShrinkArguments& options) {
  const std::filesystem::path folder = options.given.name;
  if (options.output != "-") {
    throw UserError("--output: the cases of a folder are shrunk in place; omit the option");
  }
  const ColliderChoice& asked = options.colliders.subject;
  const Corpus corpus = taken_by(asked, read_corpus_folder(folder));
  NamedColliders colliders(
      find_installed_or_named({options.subjects, {folder}}),
      keeps_points(asked) ? std::nullopt : given_collider(asked, options.colliders.external),
      given_collider(options.colliders.oracle, options.colliders.external));
  Interruption interruption;
  const auto is_stopped = [&] { return interruption.state() != Interruption::State::running; };
  const auto tell = [](const std::string& file) { write_output(file + '\n'); };
  const ShrunkInPlace of_pairs = shrink_in_place(
      corpus.cases,
      [&](const CorpusCase& known) { return shrunk_by_names(known, colliders, interruption); },
      is_stopped, tell);
  const ShrunkInPlace of_sequences = shrink_in_place(
      corpus.sequences,
      [&](const CorpusCase& known) {
        return shrunk_sequence(known, keeper_for(known, asked, options.colliders.external),
                               interruption);
      },
      is_stopped, tell);
  write_complaints(of_pairs.errors);
  write_complaints(of_sequences.errors);
  if (is_stopped()) write_complaint("shrink: interrupted; the other cases are unchanged");
  write_remark(fmt::format("{}: {} of {} cases shrunk", printable(folder.string(), 200),
                           of_pairs.files.size() + of_sequences.files.size(), corpus.all().size()));
  return of_pairs.errors.empty() && of_sequences.errors.empty() ? 0 : 2;
}

void tell_if_cut_short(Interruption& interruption) {
  if (interruption.state() == Interruption::State::running) return;
  write_complaint("shrink: interrupted; this is the smallest case until then");
}

int shrink_file(const ShrinkArguments& options) {
  std::error_code unknown;
  if (std::filesystem::is_directory(options.given.name, unknown)) return shrink_folder(options);
  const std::string file = case_file(options.given);
  check_outputs({{{"--output", options.output}}, {file}});
  const CorpusCase given = read_case_file(
      file, keeps_points(options.colliders.subject) ? CaseKind::sequence : CaseKind::either);
  if (given.is_sequence()) {
    Interruption interruption;
    write_data(options.output,
               format_case(shrunk_sequence(
                   given, keeper_for(given, options.colliders.subject, options.colliders.external),
                   interruption)));
    tell_if_cut_short(interruption);
    return 0;
  }
  SubjectAndOracle asked = options.colliders;
  if (!asked.subject.is_given()) asked.subject.name = "clip";
  if (!asked.oracle.is_given()) asked.oracle.name = usual_oracle_name();
  const Collider subject = find_collider(asked.subject, asked.external);
  const Collider oracle = find_collider(asked.oracle, asked.external);
  Interruption interruption;
  const std::string text = format_case(shrunk_case(given, subject, oracle, interruption));
  options.output == "-" ? write_output(text) : write_file(options.output, text);
  tell_if_cut_short(interruption);
  return 0;
}

void add_shrink_arguments(CLI::App& app, ShrinkArguments& options) {
  add_case_argument(app, options.given);
  add_collider(app, options.colliders.subject,
               "collider under test; default: clip, or for a folder the one that each case names");
  add_collider(app, options.colliders.oracle,
               fmt::format("collider to compare the subject with; default: {}, or for a folder the "
                           "one that each case names",
                           usual_oracle_name()));
  add_external_options(app, options.colliders.external);
  add_sequences(app, options.colliders.subject);
  add_subjects(app, options.subjects);
  app.add_option("--output", options.output, "file for the smallest case; - is stdout")
      ->type_name("FILE")
      ->capture_default_str();
}

}  // namespace

const Command kShrink{
    "shrink", "Shrink a case to the smallest with the same verdict and bucket and a similar error.",
    "manifuzz generate --seed 2 --regime tie_bias --cases 1 | manifuzz shrink - --output "
    "smallest.json",
    define<ShrinkArguments, add_shrink_arguments, shrink_file>};

}  // namespace manifuzz
