#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/pairs/pair_trial.hpp"
#include "campaign/shrink_saved.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
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

/// Shrinks a folder's findings that there was no time for when they were saved.
int shrink_folder(const ShrinkArguments& options) {
  const std::filesystem::path folder = options.given.name;
  if (options.output != "-") {
    throw UserError("--output: the cases of a folder are shrunk in place; omit the option");
  }
  const Corpus corpus = taken_by(options.colliders.subject, read_corpus_folder(folder));
  SubjectAndOracle asked = options.colliders;
  asked.external.named = read_subjects({options.subjects, {folder}});
  const TrialOf trial_of = trials_of(asked);
  const std::vector<CorpusCase> cases = corpus.all();
  Interruption interruption;
  const ShrunkInPlace shrunk = shrink_in_place(
      cases, trial_of, interruption, [](const std::string& file) { write_output(file + '\n'); });
  write_complaints(shrunk.errors);
  if (interruption.state() != Interruption::State::running) {
    write_complaint("shrink: interrupted; the other cases are unchanged");
  }
  write_remark(fmt::format("{}: {} of {} shrunk", printable(folder.string(), 200),
                           shrunk.files.size(), counted(cases.size(), "case")));
  return shrunk.errors.empty() ? 0 : 2;
}

/// By those that were asked for, or else the usual ones; of other kinds the one that it names.
std::shared_ptr<const Trial> trial_of(const CorpusCase& given, SubjectAndOracle asked) {
  if (const OtherKind* const kind = kind_for(given.any)) {
    expect_none_of(*kind, {{"--oracle", !asked.oracle.name.empty()},
                           {"--oracle-command", !asked.oracle.command.empty()}});
    return kind->trial(given, asked.subject, asked.external);
  }
  if (!asked.subject.is_given()) asked.subject.name = "clip";
  if (!asked.oracle.is_given()) asked.oracle.name = usual_oracle_name();
  return trial_of_pairs(find_collider(asked.subject, asked.external),
                        find_collider(asked.oracle, asked.external));
}

int shrink_file(const ShrinkArguments& options) {
  std::error_code unknown;
  if (std::filesystem::is_directory(options.given.name, unknown)) return shrink_folder(options);
  const std::string file = case_file(options.given);
  check_outputs({{{"--output", options.output}}, {file}});
  const CorpusCase given = read_case_file(file, kind_to_read(options.colliders.subject));
  SubjectAndOracle asked = options.colliders;
  if (kind_for(given.any) != nullptr) {  // a pair case is asked of those that are chosen
    asked.external.named = read_subjects({options.subjects, options.given.folders.all()});
  }
  const auto trial = trial_of(given, asked);
  Interruption interruption;
  const std::string text = format_case(shrunk_case(given, *trial, interruption));
  options.output == "-" ? write_output(text) : write_file(options.output, text);
  if (interruption.state() != Interruption::State::running) {
    write_complaint("shrink: interrupted; this is the smallest case until then");
  }
  return 0;
}

void add_shrink_arguments(CLI::App& app, ShrinkArguments& options) {
  add_case_argument(app, options.given,
                    "; or a folder of findings, whose cases are shrunk in place");
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

Run define_shrink(CLI::App& app) {
  return define<ShrinkArguments, add_shrink_arguments, shrink_file>(app);
}

}  // namespace manifuzz
