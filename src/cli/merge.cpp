#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "campaign/findings.hpp"
#include "campaign/gather.hpp"
#include "cases/file.hpp"
#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/merged_runs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> paths;
  std::string output = "merged";
  std::string json;
};

/// What is there already is not mixed with what comes.
void expect_empty(const std::string& folder) {
  std::error_code unreadable;
  if (!fs::exists(folder, unreadable)) return;
  if (fs::is_directory(folder, unreadable) && fs::is_empty(folder, unreadable)) return;
  throw UserError(fmt::format("--output: {} is there already; a new or an empty folder is expected",
                              printable(folder, 200)));
}

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
std::map<std::string, std::string> write_all(const std::vector<Gathered>& all,
                                             const fs::path& output) {
  std::map<std::string, std::string> files;
  for (const Gathered& finding : all) {
    const CorpusCase& smallest = finding.smallest;
    const fs::path file = output / folder_of(smallest) / corpus_file_name(smallest);
    write_file(file, text_of(smallest));
    if (finding.worst) write_file(worst_beside(file), text_of(*finding.worst));
    if (smallest.expect) files[finding_key(*smallest.expect)] = file.string();
  }
  return files;
}

/// A bucket's file is the merged one.
void name_files(nlohmann::ordered_json& run, const std::map<std::string, std::string>& files) {
  Expectation expect{run.at("subject"), run.at("oracle"), {}, {}, {}};
  for (auto& bucket : run.at("buckets")) {
    expect.bucket = bucket.at("bucket");
    const auto file = files.find(finding_key(expect));
    if (file != files.end()) bucket["file"] = file->second;
  }
}

std::string summary(const RunFiles& files, const MergedRuns& runs, std::size_t findings,
                    const std::string& output) {
  std::string text =
      fmt::format("{}: {} cases of {} files\n", output, findings, files.corpus.cases.size());
  if (runs.json.is_null()) return text;
  for (const auto& [verdict, count] : runs.json.at("verdicts").items()) {
    text += fmt::format("{:<18}{:>14}\n", verdict, count.get<std::uint64_t>());
  }
  return text + fmt::format("{:<18}{:>14}\n", "cases", runs.json.at("cases").get<std::uint64_t>());
}

int merge(const Options& options) {
  expect_empty(options.output);
  const std::vector<fs::path> paths(options.paths.begin(), options.paths.end());
  const RunFiles files = read_run_files(paths);
  MergedRuns runs = merged_runs(files.results);
  std::vector<std::string> errors = files.corpus.errors;
  errors.insert(errors.end(), runs.errors.begin(), runs.errors.end());
  for (const std::string& error : errors) write_complaint(error);
  if (files.corpus.cases.empty() && runs.json.is_null()) {
    throw UserError("merge: there is nothing to merge; name folders of cases and --json files");
  }
  const std::vector<Gathered> all = gathered(files.corpus.cases);
  const auto written = write_all(all, fs::proximate(options.output));
  if (!runs.json.is_null()) name_files(runs.json, written);
  const std::string json = runs.json.dump(2) + '\n';
  write_to_reader(options.json == "-" ? json : summary(files, runs, all.size(), options.output));
  if (!options.json.empty() && options.json != "-") write_file(options.json, json);
  if (errors.empty()) return 0;
  throw UserError(fmt::format(
      "merge: {} of the files could not be read or added; the rest is merged", errors.size()));
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("paths", options->paths, "folders of cases, and what fuzz --json wrote")
      ->type_name("DIR")
      ->required();
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
