#include "report/overview.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "base/text.hpp"
#include "engines/asked_engines.hpp"

namespace manifuzz {
namespace {

/// The subject's name, or the oracle's, told apart where both have one name.
std::string collider_at_fault(Fault fault, const Settings& settings) {
  const bool is_oracle = fault == Fault::oracle;
  const std::string& name = is_oracle ? settings.oracle : settings.subject;
  if (settings.subject != settings.oracle) return name;
  return fmt::format("{} ({})", name, is_oracle ? "oracle" : "subject");
}

std::string share_in_words(std::uint64_t part, std::uint64_t whole) {
  const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (part == whole) return "100%";
  if (percent >= 99.9) return "more than 99.9%";
  if (percent >= 10) return fmt::format("{:.1f}%", percent);
  return percent < 0.01 ? "less than 0.01%" : fmt::format("{:.2g}%", percent);
}

std::string verdicts_in_words(const CampaignResult& result) {
  std::string line;
  for (const auto& [verdict, words] :
       {std::pair{Verdict::agree, "both right and the same"},
        std::pair{Verdict::tie, "both right and not the same"},
        std::pair{Verdict::ill_posed, "too near for float to tell"},
        std::pair{Verdict::unsupported, "not taken by one of both"}}) {
    const std::uint64_t count = result.verdicts[static_cast<std::size_t>(verdict)];
    if (count == 0) continue;
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", words,
                        share_in_words(count, result.cases()));
  }
  return line;
}

/// What wrong answers of one of both come to.
struct WrongAnswers {
  std::uint64_t count = 0;
  std::uint64_t explained = 0;
  std::uint64_t accepted = 0;
};

WrongAnswers wrong_answers(const CampaignResult& result, Fault of) {
  WrongAnswers wrong;
  for (const BucketResult& found : result.buckets) {
    const auto bucket = find_bucket(found.bucket);
    if (!bucket || (bucket->fault != of && bucket->fault != Fault::both)) continue;
    wrong.count += found.count;
    if (bucket->verdict == Verdict::known) wrong.explained += found.count;
    if (found.is_accepted) wrong.accepted += found.count;
  }
  return wrong;
}

std::string wrong_in_words(const CampaignResult& result, Fault of) {
  const std::string collider = collider_at_fault(of, result.settings);
  const WrongAnswers wrong = wrong_answers(result, of);
  if (wrong.count == 0) return fmt::format("{}: no wrong answer", collider);
  std::string line = fmt::format("{}: wrong in {} ({})", collider, wrong.count,
                                 share_in_words(wrong.count, result.cases()));
  const Errors& worst = of == Fault::oracle ? result.of_oracle : result.of_subject;
  const double magnitude = std::ranges::max(worst.all());
  if (magnitude > 0) line += fmt::format(", by {:.2g} of the size at worst", magnitude);
  if (wrong.explained > 0) line += fmt::format("; {} explained by the ledger", wrong.explained);
  if (wrong.accepted > 0) line += fmt::format("; {} accepted", wrong.accepted);
  const std::string& name = of == Fault::oracle ? result.settings.oracle : result.settings.subject;
  if (is_without_ledger(name)) line += "; its ledger is not in this build";
  return line;
}

std::vector<CauseMet> causes_of(const CampaignResult& result) {
  std::vector<CauseMet> causes;
  for (const LedgerResult& met : result.ledger) {
    if (met.hits == 0) continue;
    const auto entry = std::ranges::find(ledger(), met.id, &LedgerEntry::id);
    const bool is_known = entry != ledger().end();
    causes.push_back({met.hits, is_known ? std::string(entry->description) : met.id,
                      is_known ? witness_of(*entry) : ""});
  }
  std::ranges::stable_sort(causes, std::ranges::greater{}, &CauseMet::hits);
  return causes;
}

/// Buckets of one kind and of whoever is at fault: what one bug fills several of. Where both are
/// wrong it is the subject's.
struct FindingGroup {
  Fault fault = Fault::subject;
  std::string what;      ///< the kind, or what became of an answer that was lost
  bool is_lost = false;  ///< crashed, timed out or malformed
  std::uint64_t count = 0;
  double magnitude = 0;  ///< the worst of all, as a share of the size
  std::size_t new_buckets = 0;
  /// New ones first; of these the clearest: no near tie, plainly wrong, the most frequent.
  std::vector<const BucketResult*> buckets{};
};

std::string what_is_wrong(const Bucket& bucket) {
  const std::string_view name =
      bucket.kind == Kind::none ? to_string(bucket.verdict) : name_of(bucket.kind, kKindNames);
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// Less comes first.
auto place_in_group(const BucketResult* found) {
  const auto bucket = find_bucket(found->bucket);
  const bool is_near_tie = !bucket || bucket->tie_class != TieClass::none;
  const bool is_plain = bucket && bucket->error_class == ErrorClass::gross;
  return std::tuple(!found->is_new, is_near_tie, !is_plain, ~found->count);
}

auto place_of_group(const FindingGroup& group) {
  return std::tuple(group.fault == Fault::oracle, !group.is_lost, -group.magnitude, ~group.count);
}

FindingGroup& group_of(std::vector<FindingGroup>& groups, const Bucket& bucket) {
  const Fault fault = bucket.fault == Fault::oracle ? Fault::oracle : Fault::subject;
  const std::string what = what_is_wrong(bucket);
  const auto same = std::ranges::find_if(groups, [&](const FindingGroup& group) {
    return group.fault == fault && group.what == what;
  });
  if (same != groups.end()) return *same;
  return groups.emplace_back(
      FindingGroup{.fault = fault, .what = what, .is_lost = is_of_lost(bucket)});
}

/// Groups the buckets that decide the status, most serious first: the subject's before the
/// oracle's, lost answers before wrong ones, then by magnitude.
std::vector<FindingGroup> finding_groups(const CampaignResult& result) {
  std::vector<FindingGroup> groups;
  for (const BucketResult& found : result.buckets) {
    if (!decides_status(found)) continue;
    const Bucket bucket = find_bucket(found.bucket).value_or(Bucket{.fault = Fault::subject});
    FindingGroup& group = group_of(groups, bucket);
    group.count += found.count;
    group.magnitude = std::max(group.magnitude, found.error.magnitude);
    group.new_buckets += found.is_new ? 1 : 0;
    group.buckets.push_back(&found);
  }
  for (FindingGroup& group : groups) {
    std::ranges::stable_sort(group.buckets, {}, place_in_group);
  }
  std::ranges::stable_sort(groups, {}, place_of_group);
  return groups;
}

std::string how_often_and_bad(const FindingGroup& group) {
  std::string how = times_in_words(group.count);
  if (group.buckets.size() > 1) how += fmt::format(" in {} buckets", group.buckets.size());
  if (group.new_buckets > 0 && group.new_buckets < group.buckets.size()) {
    how += fmt::format(" ({} new)", group.new_buckets);
  }
  if (group.magnitude > 0) how += fmt::format(", by {:.2g} of the size at worst", group.magnitude);
  const auto objection = std::ranges::find_if(
      group.buckets, [](const BucketResult* found) { return !found->objection.empty(); });
  return objection == group.buckets.end() ? how : how + "; " + (*objection)->objection;
}

}  // namespace

CampaignOverview overview_of(const CampaignResult& result) {
  CampaignOverview overview{.verdicts = verdicts_in_words(result),
                            .subject = wrong_in_words(result, Fault::subject),
                            .oracle = "",
                            .causes = {},
                            .findings = {}};
  for (const FindingGroup& group : finding_groups(result)) {
    const BucketResult& clearest = *group.buckets.front();
    const std::string collider = collider_at_fault(group.fault, result.settings);
    overview.findings.push_back({group.new_buckets > 0, fmt::format("{}: {}", collider, group.what),
                                 how_often_and_bad(group), clearest.file, clearest.command});
  }
  if (result.settings.oracle == kJudgeName) return overview;
  overview.oracle = wrong_in_words(result, Fault::oracle);
  overview.causes = causes_of(result);
  return overview;
}

}  // namespace manifuzz
