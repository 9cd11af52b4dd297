#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/result.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "hunting/archive_files.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct MergeArguments {
  std::vector<std::string> paths;
  std::string output = "merged";
  std::string json;
  std::string archives;
};

void expect_something(const MergeArguments& options, const MergedRuns& runs) {
  if (runs.findings.empty() && !runs.result) {
    throw UserError(
        "merge: there is nothing to merge; name folders of cases and files written by fuzz --json");
  }
  if (!options.json.empty() && !runs.result) {
    throw UserError("--json: there is no result to write; name files written by fuzz --json");
  }
  if (!options.archives.empty() &&
      (!runs.result || !runs.result->hunt || runs.result->hunt->rounds == 0)) {
    throw UserError(
        "--archives: there is no result of a hunt in rounds; name files written by hunt --json");
  }
}

/// Each share's own cells are in its result; how many they are together is in the archives.
void count_cells(CampaignResult& sum, const std::string& archives) {
  const Rounds rounds{sum.hunt->cases_dealt, sum.hunt->rounds, sum.hunt->shares};
  if (rounds.cases == 0) {
    throw UserError(
        "--archives: the results are of an older version, which does not say how many cases all "
        "shares have; merge them without it, or hunt again");
  }
  if (sum.cases() != rounds.cases) {
    throw UserError(
        fmt::format("--archives: the results are of {} of the hunt's {}; name those of every share "
                    "of every round",
                    sum.cases(), counted(rounds.cases, "case")));
  }
  sum.hunt->cells = cells_of_all({archives, sum.settings.hunt, rounds, {}});
}

/// All of it or nothing.
void write_merged(const MergeArguments& options, MergedRuns& runs) {
  Interruption interruption(kUntilSignal);
  NewFolder folder(kept_path(options.output),
                   fmt::format("--output: {}", printable(options.output, 200)));
  write_findings(runs, folder.path(), interruption);
  const bool has_file = !options.json.empty() && options.json != "-";
  if (has_file) write_file(options.json, json_text(json_of(*runs.result)));
  folder.keep();
}

int merge(const MergeArguments& options) {
  const std::vector<std::filesystem::path> paths(options.paths.begin(), options.paths.end());
  check_outputs(
      {{{"--output", options.output, OutputPath::Kind::corpus}, {"--json", options.json}}, paths});
  const RunFiles files = read_run_files(paths);
  MergedRuns runs = merged_runs(files);
  write_complaints(runs.errors);
  expect_something(options, runs);
  if (!options.archives.empty()) count_cells(*runs.result, options.archives);
  write_merged(options, runs);
  write_to_reader(options.json == "-"
                      ? json_text(json_of(*runs.result))
                      : merged_text(runs, files.corpus.all().size(), options.output));
  if (runs.errors.empty()) return 0;
  throw UserError(
      fmt::format("merge: {} of the files could not be read or added; the others are merged",
                  runs.errors.size()));
}

void add_merge_arguments(CLI::App& app, MergeArguments& options) {
  add_text(app, "paths", options.paths, "DIR",
           "folders of cases, and files written by fuzz --json or hunt --json")
      ->required();
  add_text(app, "--output", options.output, "DIR", "new or empty folder for the merged cases")
      ->capture_default_str();
  add_json(app, options.json, "the merged summary");
  add_text(app, "--archives", options.archives, "DIR",
           "folder of the archives of a hunt in rounds, of which the cells are counted");
}

}  // namespace

Run define_merge(CLI::App& app) {
  return define<MergeArguments, add_merge_arguments, merge>(app);
}

}  // namespace manifuzz
