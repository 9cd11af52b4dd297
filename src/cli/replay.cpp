#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/corpus.hpp"
#include "cases/file.hpp"
#include "cases/user_error.hpp"
#include "cli/ci_output.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/parties.hpp"
#include "cli/replay_run.hpp"
#include "report/provenance.hpp"

namespace manifuzz {
namespace {

struct Options {
  std::vector<std::string> paths;
  Parties parties;
  std::string json;
  CiOutput ci;
};

nlohmann::ordered_json json_of(const ReplayRun& run, const Collider& subject,
                               const Collider& oracle) {
  const std::array declarations{subject.declaration, oracle.declaration};
  nlohmann::ordered_json json = provenance(0, declarations);
  json["cases"] = run.tests.size();
  json["passed"] = run.passed();
  json["failed"] = run.failures.size();
  json["seconds"] = run.seconds;
  json["failures"] = nlohmann::ordered_json::array();
  for (const FailedReplay& failure : run.failures) {
    json["failures"].push_back({{"file", failure.recorded->path},
                                {"expected", failure.replayed.expected},
                                {"got", failure.replayed.got}});
  }
  return json;
}

int replay(const Options& options) {
  std::vector<std::filesystem::path> paths(options.paths.begin(), options.paths.end());
  if (paths.empty()) paths.emplace_back("corpus");
  const Collider subject = find_subject(options.parties);
  const Collider oracle = find_oracle(options.parties);
  const Corpus corpus = read_corpus(paths);
  for (const std::string& error : corpus.errors) {
    write_complaint(error);
  }

  Interruption interruption;
  const ReplayRun run = replay_cases(corpus.cases, subject, oracle, interruption);
  if (run.left_out > 0) throw UserError("replay: interrupted");
  const std::string json = json_of(run, subject, oracle).dump(2) + '\n';
  const TestSuite suite = replay_suite(run, subject, oracle, options_again(options.parties),
                                       shows_pictures(options.ci), interruption);
  Outputs outputs;
  outputs.write(true, [&] {
    write_to_reader(options.json == "-" ? json : replay_text(run, subject, oracle));
  });
  outputs.write(!options.json.empty() && options.json != "-",
                [&] { write_file(options.json, json); });
  write_ci({options.ci.junit, options.json == "-"}, {&suite, 1}, outputs);
  if (!corpus.errors.empty()) {
    throw UserError(fmt::format("replay: {} of the files could not be read; the rest was replayed",
                                corpus.errors.size()));
  }
  if (run.tests.empty())
    throw UserError("replay: there is no case; name files or folders of cases");
  if (!outputs.are_written()) return 2;
  return run.failures.empty() ? 0 : 1;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("paths", options->paths, "files and folders of cases; corpus if not given")
      ->type_name("PATH");
  add_parties(app, options->parties);
  add_junit(app, options->ci);
  app.add_option("--json", options->json, "the summary as JSON, to a file or - for stdout")
      ->type_name("FILE");
  return [options] { return replay(*options); };
}

}  // namespace

extern const Command kReplay;
const Command kReplay{"replay", "Every corpus case again: the subject must be right.",
                      "manifuzz replay corpus --subject clip --oracle box2d", define};

}  // namespace manifuzz
