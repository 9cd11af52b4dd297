#include "corpus/merge.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "campaign/merged_result.hpp"
#include "campaign/result_json.hpp"
#include "campaign/save.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/output_check.hpp"
#include "process/interruption.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> paths;
  std::string output = "merged";
  std::string json;
};

fs::path folder_of(const CorpusCase& known) {
  if (!known.property.empty()) return "regressions";
  if (!known.expect) return "seeds";
  const auto bucket = find_bucket(known.expect->bucket);
  return bucket ? corpus_folder(*bucket, known.expect->oracle) : fs::path("seeds");
}

/// The case as its file has it, every byte: answers read and written again may differ by a
/// rounding.
std::string text_of(const CorpusCase& known) {
  return known.path.ends_with(".json") ? InputFile(known.path).read_all() : format_case(known);
}

/// Writes them as a campaign would have; returns the files of the smallest by their findings' keys.
std::map<std::string, std::string> write_all(const std::vector<MergedFinding>& all,
                                             const fs::path& output, Interruption& interruption) {
  std::map<std::string, std::string> files;
  for (const MergedFinding& finding : all) {
    if (interruption.is_stopped()) throw UserError("merge: interrupted; nothing was written");
    const CorpusCase& smallest = finding.smallest;
    const fs::path file = corpus_file(output / folder_of(smallest), smallest);
    write_file(file, text_of(smallest));
    if (finding.worst) write_file(worst_beside(file), text_of(*finding.worst));
    if (smallest.expect) files[finding_key(*smallest.expect)] = file.string();
  }
  return files;
}

/// A bucket's file is the merged one.
void name_files(CampaignResult& run, const std::map<std::string, std::string>& files) {
  Expectation expect{run.settings.subject, run.settings.oracle, {}, {}, {}};
  for (BucketResult& found : run.buckets) {
    expect.bucket = found.bucket;
    const auto file = files.find(finding_key(expect));
    if (file != files.end()) found.file = file->second;
  }
}

std::string summary(const std::optional<CampaignResult>& sum) {
  std::string text;
  if (!sum) return text;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    text += fmt::format("{:<18}{:>14}\n", kVerdictNames[i], sum->verdicts[i]);
  }
  return text + fmt::format("{:<18}{:>14}\n", "cases", sum->cases());
}

/// Whatever would come to nothing, or cost what is there, is refused before anything is written.
void expect_possible(const Options& options, const RunFiles& files, const MergedResult& runs) {
  if (files.corpus.cases.empty() && !runs.sum) {
    throw UserError("merge: there is nothing to merge; name folders of cases and --json files");
  }
  if (options.json.empty()) return;
  if (!runs.sum)
    throw UserError("--json: there is no result to write; name what fuzz --json wrote");
}

/// Writes all of it or nothing; returns what there is to say.
std::string write_merged(const Options& options, const RunFiles& files, MergedResult& runs) {
  Interruption interruption(kUntilSignal);
  NewFolder folder(kept_path(options.output),
                   fmt::format("--output: {}", printable(options.output, 200)));
  const std::vector<MergedFinding> all = merged_findings(files.corpus.cases);
  const auto written = write_all(all, folder.path(), interruption);
  if (runs.sum) name_files(*runs.sum, written);
  const std::string json = runs.sum ? json_text(json_of(*runs.sum)) : "";
  const bool has_file = !options.json.empty() && options.json != "-";
  if (has_file) {
    write_file(options.json, json);
  }
  folder.keep();
  if (options.json == "-") return json;
  const std::string cases =
      all.empty() ? ""
                  : fmt::format("{}: {} findings of {} cases\n", printable(options.output, 200),
                                all.size(), files.corpus.cases.size());
  return cases + summary(runs.sum);
}

int merge(const Options& options) {
  const std::vector<fs::path> paths(options.paths.begin(), options.paths.end());
  check_outputs(
      {{{"--output", options.output, OutputPath::Kind::corpus}, {"--json", options.json}}, paths});
  const RunFiles files = read_run_files(paths);
  MergedResult runs = merged_result(files.results);
  std::vector<std::string> errors = files.corpus.errors;
  errors.insert(errors.end(), runs.errors.begin(), runs.errors.end());
  write_complaints(errors);
  expect_possible(options, files, runs);
  write_to_reader(write_merged(options, files, runs));
  if (errors.empty()) return 0;
  throw UserError(fmt::format(
      "merge: {} of the files could not be read or added; the rest is merged", errors.size()));
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("paths", options->paths, "folders of cases, and what fuzz --json wrote")
      ->type_name("DIR")
      ->required()
      ->check(not_blank);
  app.add_option("--output", options->output, "a new or empty folder for what is kept")
      ->type_name("DIR")
      ->check(not_blank)
      ->capture_default_str();
  app.add_option("--json", options->json,
                 "the results as one, as fuzz --json has them, to a file or - for stdout")
      ->type_name("FILE");
  return [options] { return merge(*options); };
}

}  // namespace

extern const Command kMerge;
const Command kMerge{"merge",
                     "Several runs as one: of each bucket the smallest and the worst case.",
                     "manifuzz fuzz --seed 1 --cases 200000 --corpus run0 --json run0.json\n"
                     "manifuzz fuzz --seed 1 --first 10000 --cases 200000 --corpus run1 --json "
                     "run1.json\n"
                     "manifuzz merge run0 run1 run0.json run1.json --output all --json all.json",
                     define};

}  // namespace manifuzz
