#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/user_error.hpp"
#include "cli/ci_output.hpp"
#include "cli/collider_options.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/replay_run.hpp"
#include "corpus/corpus.hpp"
#include "measure/provenance.hpp"

namespace manifuzz {
namespace {

struct Options {
  std::vector<std::string> paths;
  ComparedColliders parties;
  std::string json;
  CiOutput ci;
};

nlohmann::ordered_json json_of(const ReplayRun& run, std::size_t unread, const Collider& subject,
                               const Collider& oracle) {
  const std::array declarations{subject.declaration, oracle.declaration};
  nlohmann::ordered_json json = provenance(0, declarations);
  json["subject"] = declarations[0].name;
  json["oracle"] = declarations[1].name;
  json["cases"] = run.tests.size();
  json["passed"] = run.passed();
  json["failed"] = run.failures.size();
  json["left_out"] = run.left_out;
  json["unread"] = unread;
  json["seconds"] = run.seconds;
  json["failures"] = nlohmann::ordered_json::array();
  for (const FailedReplay& failure : run.failures) {
    json["failures"].push_back({{"file", failure.recorded->path},
                                {"expected", failure.replayed.expected},
                                {"got", failure.replayed.got}});
  }
  return json;
}

int replay(Options& options) {
  std::vector<std::filesystem::path> paths(options.paths.begin(), options.paths.end());
  if (paths.empty()) paths.emplace_back("corpus");
  check_outputs({{{"--json", options.json}}, paths}, options.ci);
  const Collider subject = find_subject(options.parties);
  const Collider oracle = find_oracle(options.parties);
  const Corpus corpus = read_corpus(paths);
  write_complaints(corpus.errors);
  if (corpus.cases.empty() && corpus.errors.empty()) {
    throw UserError("replay: there is no case; name files or folders of cases");
  }

  Interruption interruption(kUntilSignal);
  const ReplayRun run = replay_cases(corpus.cases, subject, oracle, interruption);
  Outputs outputs;
  outputs.write(run.left_out > 0,
                [&] { throw UserError("replay: interrupted before it was done"); });
  outputs.write(!options.ci.stdout_is_data,
                [&] { write_to_reader(replay_text(run, subject, oracle)); });
  outputs.write(!options.json.empty(), [&] {
    write_data(options.json, json_text(json_of(run, corpus.errors.size(), subject, oracle)));
  });
  if (is_wanted(options.ci)) {
    TestSuite suite =
        replay_suite(run, subject, oracle, options_again(options.parties), interruption);
    suite.errors = corpus.errors;
    write_ci(options.ci, {suite}, outputs);
  }
  if (!corpus.errors.empty()) {
    write_complaint(fmt::format("replay: {} of the files could not be read; the rest was replayed",
                                corpus.errors.size()));
  }
  if (!outputs.are_written() || !corpus.errors.empty()) return 2;
  return run.failures.empty() ? 0 : 1;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("paths", options->paths, "files and folders of cases; corpus if not given")
      ->type_name("PATH")
      ->check(not_blank);
  add_compared_colliders(app, options->parties);
  add_junit(app, options->ci);
  app.add_option("--json", options->json, "the summary as JSON, to a file or - for stdout")
      ->type_name("FILE");
  return [options] { return run_for_ci("replay", options->ci, [&] { return replay(*options); }); };
}

}  // namespace

extern const Command kReplay;
const Command kReplay{"replay", "Every corpus case again: the subject must be right.",
                      "manifuzz replay corpus --subject clip --oracle box2d", define};

}  // namespace manifuzz
