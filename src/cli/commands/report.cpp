#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/result.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "report/outputs.hpp"
#include "report/page/page.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kMapsMax = 1000;

struct ReportArguments {
  std::vector<std::string> paths;
  SubjectAndOracle colliders{{"subject", "", ""}, {"oracle", "", ""}, {}};
  std::string output = "report.html";
  std::optional<std::uint64_t> maps;
};

std::string repeating_command(const std::vector<std::filesystem::path>& paths,
                              const ReportArguments& options) {
  std::string command = this_program() + " report";
  for (const auto& path : paths) command += ' ' + quoted_for_shell(path.string());
  if (options.maps) command += fmt::format(" --maps {}", *options.maps);
  const auto output = kept_path(options.output);
  return command + " --output " + quoted_for_shell(output.string());
}

PageColliders page_colliders(const SubjectAndOracle& asked) {
  const bool is_of_pairs = kind_for(asked.subject) == nullptr;
  return {
      {find_installed, is_of_pairs ? given_collider(asked.subject, asked.external) : std::nullopt,
       given_collider(asked.oracle, asked.external)},
      trials_of_others(asked.subject, asked.external)};
}

int report(const ReportArguments& options) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& path : options.paths) paths.push_back(kept_path(path));
  if (paths.empty()) paths = CorpusFolders().all();
  check_outputs({{{"--output", options.output}}, paths});
  const RunFiles files = read_run_files(paths);
  write_complaints(files.corpus.errors);
  const std::size_t count = files.corpus.all().size();
  if (count == 0 && files.results.empty()) {
    throw UserError(
        "report: there is nothing to report; name folders of cases and files written by --json");
  }
  const PageColliders colliders = page_colliders(options.colliders);
  const std::string html = page_of(files, colliders, options.maps.value_or(kMapsUsual),
                                   {this_program(), repeating_command(paths, options)});
  write_data(options.output, html);
  if (options.output != "-") {
    write_remark(fmt::format("{}: {}, {}", printable(options.output, 200), counted(count, "case"),
                             counted(files.results.size(), "result")));
  }
  if (files.corpus.errors.empty()) return 0;
  throw UserError(
      fmt::format("report: {} of the files could not be read; the page shows the others",
                  files.corpus.errors.size()));
}

void add_report_arguments(CLI::App& app, ReportArguments& options) {
  add_text(
      app, "paths", options.paths, "PATH",
      "folders and files of cases, and files written by --json; default: corpus and the folder of "
      "findings");
  add_text(app, "--output", options.output, "FILE.html", "file for the page; - is stdout")
      ->capture_default_str();
  add_whole_number(
      app, "--maps", options.maps,
      "number of buckets for which the neighbourhood of the case is drawn; default: 12", 0,
      kMapsMax);
  add_collider(app, options.colliders.subject, "collider for cases that name none; default: clip");
  add_collider(app, options.colliders.oracle,
               fmt::format("oracle for cases that name none; default: {}", usual_oracle_name()));
  add_external_options(app, options.colliders.external);
}

}  // namespace

Run define_report(CLI::App& app) {
  return define<ReportArguments, add_report_arguments, report>(app);
}

}  // namespace manifuzz
