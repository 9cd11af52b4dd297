#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "engines/provenance.hpp"
#include "report/ci/ci_output.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct ReplayArguments {
  std::vector<std::string> paths;
  SubjectAndOracle colliders{{"subject", "", ""}, {"oracle", "", ""}, {}};
  std::string subjects;
  std::string today;
  std::string json;
  CiOutput ci;
};

/// The folders of known cases that are read, or that files may lie in.
std::vector<std::filesystem::path> corpora_of(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::filesystem::path> corpora = paths;
  std::ranges::copy(CorpusFolders().all(), std::back_inserter(corpora));
  return corpora;
}

int replay(ReplayArguments& options) {
  std::vector<std::filesystem::path> paths(options.paths.begin(), options.paths.end());
  if (paths.empty()) paths = CorpusFolders().all();
  check_outputs({{{"--json", options.json}}, paths}, options.ci);
  SubjectAndOracle& asked = options.colliders;
  asked.external.named = read_subjects({options.subjects, corpora_of(paths)});
  const TrialOf trial_of = trials_of(asked);
  const Corpus corpus = taken_by(asked.subject, read_corpus(paths));
  const std::size_t unread = corpus.errors.size();
  write_complaints(corpus.errors);
  if (corpus.all().empty() && unread == 0) {
    throw UserError("replay: no cases were found; name files or folders of cases");
  }

  Interruption interruption(kUntilSignal);
  ReplayRun run;
  for (const std::vector<CorpusCase>* const like : {&corpus.cases, &corpus.others}) {
    run.add(replay_cases(*like, trial_of, known_of(*like, options.today), interruption));
  }
  Outputs outputs;
  if (run.left_out > 0) outputs.add_interruption("replay: interrupted before it was done");
  outputs.write(!options.ci.stdout_is_data, [&] { write_to_reader(replay_text(run)); });
  outputs.write(!options.json.empty(), [&] {
    auto json = provenance(0, run.declarations());
    append_replay_json(json, run, unread);
    write_data(options.json, json_text(json));
  });
  if (is_wanted(options.ci)) {
    TestSuite suite = replay_suite(run, {this_program(), options_again(asked)}, interruption);
    suite.errors.insert(suite.errors.begin(), corpus.errors.begin(), corpus.errors.end());
    write_ci(options.ci, {suite}, outputs);
  }
  if (unread > 0) {
    write_complaint(
        fmt::format("replay: {} of the files could not be read; the others were replayed", unread));
  }
  if (!outputs.are_written() || unread > 0 || !run.unasked.empty()) return 2;
  return run.failed() == 0 ? 0 : 1;
}

void add_replay_arguments(CLI::App& app, ReplayArguments& options) {
  add_text(app, "paths", options.paths, "PATH",
           "files and folders of cases; default: corpus and the folder of findings");
  add_collider(app, options.colliders.subject,
               "collider under test; default: the one that each case names, or clip");
  add_collider(
      app, options.colliders.oracle,
      fmt::format(
          "collider to compare the subject with; default: the one that each case names, or {}",
          usual_oracle_name()));
  add_sequences(app, options.colliders.subject);
  add_external_options(app, options.colliders.external);
  add_subjects(app, options.subjects);
  add_today(app, options.today);
  add_junit(app, options.ci.junit);
  add_json(app, options.json, "the summary");
}

}  // namespace

Run define_replay(CLI::App& app) {
  return define<ReplayArguments, add_replay_arguments, replay>(app);
}

}  // namespace manifuzz
