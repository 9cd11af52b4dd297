#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/replay.hpp"
#include "report/outputs.hpp"
#include "report/rows.hpp"

namespace manifuzz {

std::string why_unasked(const CorpusCase& unasked) {
  return fmt::format(
      "{}: there is no collider {}; name one with --subject, or in a file subjects.json beside the "
      "corpus",
      printable(unasked.path, 200), printable(unasked.expect->subject));
}

std::string stale_in_words(std::span<const std::string> files) {
  return lines_of(files, [](const std::string& file) {
    return fmt::format("stale {}: what was accepted comes no more; manifuzz accept --drop {}\n",
                       printable(file, 200), quoted_for_shell(file));
  });
}

namespace {

/// What failed, a line each.
std::string replay_failures(const ReplayRun& run) {
  std::string text;
  for (const ReplayedCase& one : run.cases) {
    if (!one.result.has_failed()) continue;
    text += fmt::format("{} {}: expected {}, got {}\n", bad("FAIL"),
                        printable(one.recorded->path, 200), one.result.expected, one.result.got);
  }
  for (const CorpusCase* const unasked : run.unasked) {
    text += fmt::format("{} {}\n", bad("NOT ASKED"), why_unasked(*unasked));
  }
  return text + stale_in_words(run.stale());
}

}  // namespace

std::string replay_counts(const ReplayRun& run) {
  std::vector<std::string> counts;
  if (!run.cases.empty()) {
    const std::string against = run.oracle.empty() ? "" : " against " + run.oracle;
    counts.push_back(fmt::format("{}{}: {}, {} passed, {} failed, in {:.2f} s", run.subject,
                                 against, counted(run.cases.size(), "case"), run.passed(),
                                 run.failed(), run.seconds));
  }
  if (run.accepted() > 0) counts.push_back(fmt::format("{} of them accepted", run.accepted()));
  if (run.unsupported() > 0) {
    counts.push_back(
        fmt::format("{} unsupported, for a collider cannot take them", run.unsupported()));
  }
  if (!run.unasked.empty()) counts.push_back(fmt::format("{} not asked", run.unasked.size()));
  if (run.left_out > 0) counts.push_back(fmt::format("{} left out, for time was up", run.left_out));
  return fmt::format("{}", fmt::join(counts, "; "));
}

std::string replay_text(const ReplayRun& run) {
  const std::string counts = is_quiet() ? "" : replay_counts(run);
  return replay_failures(run) + counts + (counts.empty() ? "" : "\n");
}

void append_replay_json(nlohmann::ordered_json& json, const ReplayRun& run, std::size_t unread) {
  json["subject"] = run.subject;
  json["oracle"] = run.oracle;
  json["cases"] = run.cases.size();
  json["passed"] = run.passed();
  json["failed"] = run.failed();
  json["unsupported"] = run.unsupported();
  json["accepted"] = run.accepted();
  json["stale"] = run.stale();
  json["left_out"] = run.left_out;
  json["interrupted"] = run.left_out > 0;
  json["unread"] = unread;
  json["seconds"] = run.seconds;
  json["failures"] = nlohmann::ordered_json::array();
  for (const ReplayedCase& one : run.cases) {
    if (!one.result.has_failed()) continue;
    json["failures"].push_back(
        {{"file", one.recorded->path}, {"expected", one.result.expected}, {"got", one.result.got}});
  }
  json["unasked"] = nlohmann::ordered_json::array();
  for (const CorpusCase* const one : run.unasked) {
    json["unasked"].push_back({{"file", one->path}, {"subject", one->expect->subject}});
  }
}

}  // namespace manifuzz
