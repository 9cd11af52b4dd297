#include "cli/starting/first_corpus.hpp"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/accept.hpp"
#include "campaign/in_child.hpp"
#include "campaign/replay.hpp"
#include "campaign/run.hpp"
#include "corpus/corpus.hpp"
#include "engines/provenance.hpp"
#include "judging/bucket.hpp"
#include "report/campaign_text.hpp"
#include "report/outputs.hpp"
#include "report/overview.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kSeedsOfEachRegime = 3;
constexpr CaseNumber kCasesToAnswer = 3;  ///< one of the first so many
constexpr std::uint64_t kPropertyCasesMax = 1000;
constexpr std::uint64_t kCasesOfOneProperty = 20;  ///< one of a property in so many of the campaign
/// What README.md of src/external/ gives --up-to: no limit, for errors that have none.
constexpr double kHoweverBad = 1e6;

void expect_going_on(Interruption& all) {
  if (all.is_stopped()) throw UserError("init: interrupted before it was done; nothing is written");
}

Plan plan_of(const FirstCorpusPlan& first) {
  Plan plan;
  plan.subject = first.subject;
  plan.oracle = first.oracle;
  plan.regimes = regimes_for({plan.subject, plan.oracle}, {});
  std::erase_if(plan.regimes, [](const Regime* regime) { return regime->name == "corpus"; });
  narrow_to_colliders(plan);
  plan.seed = kSeed;
  plan.cases = first.cases;
  plan.judge_every = usual_judge_every(plan.subject, plan.oracle);
  plan.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return plan;
}

/// A program that does not even start would be started again and again by a campaign.
void expect_answers(const Plan& plan, Interruption& all) {
  for (CaseNumber number = 0; number < kCasesToAnswer; ++number) {
    const Answer answer = ask_in_child(plan.subject, plan.pair(number), all);
    const Lost* const lost = std::get_if<Lost>(&answer);
    if (lost == nullptr) return;
    if (number + 1 < kCasesToAnswer) continue;
    throw UserError(fmt::format("init: {} gives no answers: {}", plan.subject.declaration.name,
                                printable(lost->why, 200)));
  }
}

Campaign run_first_campaign(const fs::path& folder, const Plan& plan) {
  const ProgressLine line;
  const Origin origin{"", provenance(plan.seed, asked_by(plan))};
  Campaign campaign =
      run_campaign(plan, {}, {.folder = folder.string()}, origin,
                   [&](const Progress& progress) { line.show(progress_line(plan, progress)); });
  if (campaign.run.given_up != Fault::none) {
    throw UserError(fmt::format("init: {} gives no answers: {}", plan.subject.declaration.name,
                                printable(campaign.run.why_given_up, 200)));
  }
  const std::string unwritten = unwritten_in_words(campaign.saving);
  if (!unwritten.empty()) throw UserError(unwritten);
  return campaign;
}

void check_first_properties(const fs::path& folder, const Plan& plan) {
  const ProgressLine line;
  const auto cases =
      std::clamp<std::uint64_t>(*plan.cases / kCasesOfOneProperty, 1, kPropertyCasesMax);
  const auto all = chosen_by_name(properties(), {}, "property", "property");
  PropertyPlan each;
  each.seed = kSeed;
  each.cases = static_cast<int>(cases);
  const auto checked = check_properties(all, plan.subject, each, {}, {}, folder.string(),
                                        [&](const CheckedProperty& one) {
                                          line.show(fmt::format("property {}", one.property->name));
                                        });
  for (const CheckedProperty& one : checked) {
    if (!one.why_unsaved.empty()) throw UserError(one.why_unsaved);
  }
}

bool is_right(const Judgement& judgement) {
  return judgement.bucket.verdict == Verdict::agree || judgement.bucket.verdict == Verdict::tie;
}

/// A few cases of each regime, a line each; how many there are.
std::size_t write_seeds(const fs::path& folder, const Plan& plan, Interruption& all) {
  std::map<std::string, std::string> versions;
  for (const Declaration& one : asked_by(plan)) versions[one.name] = one.version;
  std::string lines;
  std::size_t count = 0;
  for (CaseNumber number = 0; number < kSeedsOfEachRegime * plan.regimes.size(); ++number) {
    expect_going_on(all);
    const PairCase pair = plan.pair(number);
    if (!is_right(judge_in_child(pair, plan.subject, plan.oracle, all))) continue;
    const std::string regime(plan.regimes[plan.regime_of(number)]->name);
    append_found_case_line(lines, pair, {kSeed, regime, plan.index_of(number), versions});
    lines += '\n';
    ++count;
  }
  write_file(folder / "seeds" / "regimes.jsonl", lines);
  return count;
}

bool is_of_subject(const CorpusCase& known) {
  if (!known.property.empty()) return true;
  const auto bucket = find_bucket(known.expect ? known.expect->bucket : "");
  return bucket && is_unexplained(bucket->verdict) && bucket->fault != Fault::oracle;
}

/// Accepts what the subject is guilty of; how many findings that is.
std::size_t accept_findings(const fs::path& folder, const Declaration& subject) {
  const Acceptance asked{
      .because = fmt::format("found in {} {} when CI began", subject.name, subject.version),
      .up_to = kHoweverBad,
      .is_of_kind = true};
  std::size_t count = 0;
  for (const CorpusCase& known : read_corpus_folder(folder).all()) {
    if (is_worst(known.path) || !is_of_subject(known)) continue;
    CorpusCase accepted = accepted_case(known.path, asked);
    accept_in(folder, accepted);
    ++count;
  }
  return count;
}

}  // namespace

FirstCorpus write_first_corpus(const fs::path& folder, const FirstCorpusPlan& first,
                               Interruption& all) {
  const Plan plan = plan_of(first);
  FirstCorpus corpus;
  expect_answers(plan, all);
  const Campaign campaign = run_first_campaign(folder, plan);
  expect_going_on(all);
  corpus.verdicts = overview_of(campaign.result).subject;
  for (const Hint& hint : campaign.result.hints) corpus.hints.push_back(hint.text);
  check_first_properties(folder, plan);
  expect_going_on(all);
  corpus.accepted = accept_findings(folder, plan.subject.declaration);
  corpus.seeds = write_seeds(folder, plan, all);
  return corpus;
}

}  // namespace manifuzz
