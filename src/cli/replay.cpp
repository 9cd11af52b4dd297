#include "campaign/replay.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/corpus.hpp"
#include "cases/file.hpp"
#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/parties.hpp"
#include "report/junit.hpp"
#include "report/provenance.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  std::vector<std::string> paths;
  Parties parties;
  std::string junit;
  std::string json;
};

struct Failure {
  std::string file;
  Replayed replayed;
};

struct ReplayRun {
  std::size_t cases = 0;
  double seconds = 0;
  std::vector<Failure> failures;
  std::vector<JUnitTest> tests;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

nlohmann::ordered_json json_of(const ReplayRun& run, const Collider& subject,
                               const Collider& oracle) {
  const std::array declarations{subject.declaration, oracle.declaration};
  nlohmann::ordered_json json = provenance(0, declarations);
  json["cases"] = run.cases;
  json["passed"] = run.cases - run.failures.size();
  json["failed"] = run.failures.size();
  json["seconds"] = run.seconds;
  json["failures"] = nlohmann::ordered_json::array();
  for (const Failure& failure : run.failures) {
    json["failures"].push_back({{"file", failure.file},
                                {"expected", failure.replayed.expected},
                                {"got", failure.replayed.got}});
  }
  return json;
}

ReplayRun run_all(const std::vector<CorpusCase>& cases, const Collider& subject,
                  const Collider& oracle) {
  ReplayRun run;
  const auto start = Clock::now();
  Interruption interruption;
  for (const CorpusCase& recorded : cases) {
    if (interruption.requested()) throw UserError("replay: interrupted");
    const auto case_start = Clock::now();
    const Replayed replayed = replay_case(recorded, subject, oracle, interruption);
    ++run.cases;
    JUnitTest test{recorded.path, {}, seconds_since(case_start)};
    if (!replayed.passed) {
      test.failure = fmt::format("expected {}, got {}", replayed.expected, replayed.got);
      run.failures.push_back({recorded.path, replayed});
    }
    run.tests.push_back(test);
  }
  run.seconds = seconds_since(start);
  return run;
}

std::string failures(const ReplayRun& run) {
  std::string text;
  for (const JUnitTest& test : run.tests) {
    if (test.failure.empty()) continue;
    text += fmt::format("{} {}: {}\n", bad("FAIL"), printable(test.name, 200), test.failure);
  }
  return text;
}

std::string summary(const ReplayRun& run, const Collider& subject, const Collider& oracle) {
  if (is_quiet()) return failures(run);
  return failures(run) + fmt::format("{} against {}: {} cases, {} passed, {} failed, in {:.2f} s\n",
                                     subject.declaration.name, oracle.declaration.name, run.cases,
                                     run.cases - run.failures.size(), run.failures.size(),
                                     run.seconds);
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

  const ReplayRun run = run_all(corpus.cases, subject, oracle);
  const std::string json = json_of(run, subject, oracle).dump(2) + '\n';
  write_to_reader(options.json == "-" ? json : summary(run, subject, oracle));
  if (!options.json.empty() && options.json != "-") write_file(options.json, json);
  if (!options.junit.empty()) write_file(options.junit, junit_xml("manifuzz replay", run.tests));
  if (!corpus.errors.empty()) {
    throw UserError(fmt::format("replay: {} of the files could not be read; the rest was replayed",
                                corpus.errors.size()));
  }
  if (run.cases == 0) throw UserError("replay: there is no case; name files or folders of cases");
  return run.failures.empty() ? 0 : 1;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("paths", options->paths, "files and folders of cases; corpus if not given")
      ->type_name("PATH");
  add_parties(app, options->parties);
  app.add_option("--junit", options->junit, "a JUnit XML report")->type_name("FILE");
  app.add_option("--json", options->json, "the summary as JSON, to a file or - for stdout")
      ->type_name("FILE");
  return [options] { return replay(*options); };
}

}  // namespace

extern const Command kReplay;
const Command kReplay{"replay", "Every corpus case again: the subject must be right.",
                      "manifuzz replay corpus --subject clip --oracle box2d", define};

}  // namespace manifuzz
