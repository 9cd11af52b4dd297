#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/sequences/keeper_trial.hpp"
#include "report/page/page.hpp"
#include "report/sequence/sequence_report.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

/// What a file records of its verdict, for want of a collider to ask.
Json recorded_json(const CorpusCase& given) {
  const Expectation expect = given.expect.value_or(Expectation{});
  return {{"subject", expect.subject}, {"oracle", kJudgeName}, {"verdict", expect.verdict},
          {"bucket", expect.bucket},   {"sentence", ""},       {"svg", ""}};
}

Json judged_json(const JudgedSequence& judged) {
  const Bucket& bucket = judged.judgement.bucket;
  return {{"subject", judged.subject.declaration.name}, {"oracle", kJudgeName},
          {"verdict", to_string(bucket.verdict)},       {"bucket", to_string(bucket)},
          {"sentence", verdict_sentence(judged)},       {"svg", filmstrip_svg(judged)}};
}

}  // namespace

Json page_sequences_json(const RunFiles& files, const TrialOf& trial_of, const std::string& program,
                         Interruption& interruption) {
  Json all = Json::array();
  for (const CorpusCase& given : files.corpus.others) {
    if (interruption.is_stopped()) throw Interrupted();
    const auto trial = std::dynamic_pointer_cast<const KeeperTrial>(trial_of(given));
    const bool is_there = trial != nullptr && trial->is_there();
    Json one = is_there ? judged_json(judged_sequence(given, trial->keeper(), interruption))
                        : recorded_json(given);
    const BucketRuns runs = runs_of(given, files.results);
    std::vector<std::string> commands{
        fmt::format("{} show {}", program, quoted_for_shell(given.path))};
    std::ranges::copy(runs.commands, std::back_inserter(commands));
    one["file"] = given.path;
    one["regime"] = given.found ? given.found->regime : "";
    one["frames"] = frames_in(given.any);
    one["note"] = given.note;
    one["count"] = runs.count ? Json(*runs.count) : Json();
    one["commands"] = commands;
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace manifuzz
