#include "campaign/known.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/result.hpp"

namespace manifuzz {
namespace {

/// The bucket, with the names of those at fault.
std::string key_of(std::string_view bucket, std::string_view subject, std::string_view oracle) {
  const std::string_view fault = bucket.substr(0, bucket.find('/'));
  return fmt::format("{}|{}|{}", bucket,
                     fault == "subject" || fault == "both" ? subject : std::string_view(),
                     fault == "oracle" || fault == "both" ? oracle : std::string_view());
}

/// Adds to what is accepted of a kind what a file accepts of one of its buckets.
void widen(Acceptance& of_kind, const Acceptance& of_bucket) {
  const bool ends_first =
      of_kind.until.empty() || (!of_bucket.until.empty() && of_bucket.until < of_kind.until);
  if (ends_first) of_kind.until = of_bucket.until;
  if (of_bucket.up_to) of_kind.up_to = std::max(of_kind.up_to.value_or(0), *of_bucket.up_to);
  if (of_bucket.errors_up_to) {
    if (!of_kind.errors_up_to) of_kind.errors_up_to.emplace();
    widen(*of_kind.errors_up_to, *of_bucket.errors_up_to);
  }
  for (const auto& [regime, rate] : of_bucket.per_million) of_kind.per_million[regime] += rate;
}

/// The keys of what a file shows: one, or, of an older file that names no class, one for each.
std::vector<std::string> keys_of(const CorpusCase& known) {
  const Expectation& expect = *known.expect;
  if (!known.property.empty()) return {finding_key(known.property, expect.subject)};
  std::vector<std::string> keys{finding_key(expect)};
  const auto bucket = find_bucket(expect.bucket);
  if (!bucket || bucket->error_class != ErrorClass::none) return keys;
  Expectation of_class = expect;
  for (const ErrorClass each : {ErrorClass::rounding, ErrorClass::fine, ErrorClass::gross}) {
    of_class.bucket = fmt::format("{}/{}", expect.bucket, name_of(each, kErrorClassNames));
    keys.push_back(finding_key(of_class));
  }
  return keys;
}

/// Whether it accepts more: it holds today, and then it is the one up to the greater magnitude.
bool is_wider(const Acceptance& one, const Acceptance& other, const std::string& today) {
  const auto width = [&today](const Acceptance& acceptance) {
    const bool holds = acceptance.until.empty() || acceptance.until >= today;
    if (!acceptance.errors_up_to) {
      return std::pair(holds, acceptance.up_to.value_or(std::numeric_limits<double>::infinity()));
    }
    return std::pair(holds, std::ranges::max(acceptance.errors_up_to->all()));
  };
  return width(one) > width(other);
}

/// The greatest of what a file tells of.
WorstError worst_of(const CorpusCase& known) {
  WorstError worst{known.expect->magnitude.value_or(0), known.expect->errors.value_or(Errors{})};
  if (known.found && known.found->seen) {
    const Seen& seen = *known.found->seen;
    widen(worst, {seen.magnitude, seen.errors.value_or(Errors{})});
  }
  return worst;
}

/// The first error that is worse than is accepted and than any file tells of, if one is.
std::optional<Excess> beyond_known(std::span<const Excess> beyond, const WorstError& worst) {
  const auto found = std::ranges::find_if(beyond, [&](const Excess& excess) {
    return excess.got > (excess.component ? worst.errors[*excess.component] : worst.magnitude);
  });
  return found == beyond.end() ? std::optional<Excess>{} : *found;
}

/// Why the acceptance does not hold; empty where it does.
std::string objection(const Acceptance& acceptance, std::span<const Excess> beyond,
                      const std::string& today) {
  if (!acceptance.until.empty() && acceptance.until < today) {
    return fmt::format("accepted until {}, and that is past", acceptance.until);
  }
  return beyond.empty() ? "" : "worse than is accepted: " + in_words(beyond.front());
}

/// That it was met more often than is accepted in some regimes; empty where in none.
std::string objection_to_frequency(const Acceptance& acceptance, const BucketTally& met,
                                   const Tally& tally, const Plan& plan) {
  std::vector<std::string_view> regimes;
  for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
    const auto budget = acceptance.per_million.find(std::string(plan.regimes[r]->name));
    if (budget == acceptance.per_million.end()) continue;
    if (is_over_budget(budget->second, budget->first, met.regimes[r], tally.regimes[r].cases)) {
      regimes.push_back(plan.regimes[r]->name);
    }
  }
  if (regimes.empty()) return "";
  return fmt::format("more frequent than is accepted in {}", fmt::join(regimes, ", "));
}

/// A bucket's key where the colliders are a plan's.
std::string key_in_plan(const Bucket& bucket, const Plan& plan) {
  return key_of(to_string(bucket), plan.subject.declaration.name, plan.oracle.declaration.name);
}

std::string kind_key(const Bucket& bucket, const Plan& plan) {
  return manifuzz::kind_key(bucket, plan.subject.declaration.name, plan.oracle.declaration.name);
}

/// What is accepted of a bucket that no file shows, since all of its kind may come.
const Acceptance* acceptance_of_kind(const Bucket& bucket, const KnownAs& as, const Plan& plan,
                                     const Known& known) {
  if (!as.file.empty()) return nullptr;
  const auto of_kind = known.kinds.find(kind_key(bucket, plan));
  return of_kind == known.kinds.end() ? nullptr : &of_kind->second;
}

/// How often all buckets of its kind were met together.
BucketTally all_of_kind(const Bucket& bucket, const Tally& tally, const Plan& plan) {
  BucketTally sum;
  for (const auto& [other, met] : tally.buckets.all()) {
    if (kind_key(other, plan) != kind_key(bucket, plan)) continue;
    for (std::size_t r = 0; r < plan.regimes.size(); ++r) sum.regimes[r] += met->regimes[r];
  }
  return sum;
}

}  // namespace

std::string finding_key(const Expectation& expect) {
  return key_of(expect.bucket, expect.subject, expect.oracle);
}

std::string kind_key(const Bucket& bucket, std::string_view subject, std::string_view oracle) {
  const bool is_of_oracle = bucket.fault == Fault::oracle;
  // Where both are wrong it is the subject's mistake.
  const Verdict verdict =
      bucket.verdict == Verdict::both_wrong ? Verdict::subject_wrong : bucket.verdict;
  return key_of(fmt::format("{}/{}/{}", is_of_oracle ? "oracle" : "subject", to_string(verdict),
                            name_of(bucket.kind, kKindNames)),
                subject, oracle);
}

std::string finding_key(std::string_view property, std::string_view subject) {
  return fmt::format("property {}|{}", property, subject);
}

Known known_of(std::span<const CorpusCase> corpus, const std::string& today) {
  Known known;
  known.today = today;
  for (const CorpusCase& one : corpus) {
    if (!one.expect) continue;
    for (const std::string& key : keys_of(one)) {
      known.files.emplace(key, one.path);
      widen(known.worst[key], worst_of(one));
      if (!one.accepted) continue;
      const auto bucket = find_bucket(one.expect->bucket);
      if (one.accepted->is_of_kind && bucket && key == keys_of(one).front()) {
        widen(known.kinds[kind_key(*bucket, one.expect->subject, one.expect->oracle)],
              *one.accepted);
      }
      const auto [of_key, is_first] =
          known.accepted.try_emplace(key, Accepted{*one.accepted, one.path});
      if (!is_first && is_wider(*one.accepted, of_key->second.acceptance, today)) {
        of_key->second = {*one.accepted, one.path};
      }
    }
  }
  return known;
}

void add_baseline(const CampaignResult& baseline, const Plan& plan, Known& known) {
  const std::string& subject = plan.subject.declaration.name;
  const std::string& oracle = plan.oracle.declaration.name;
  if (!is_of(baseline.settings, subject, oracle)) return;
  for (const BucketResult& found : baseline.buckets) {
    known.baseline.insert(key_of(found.bucket, subject, oracle));
  }
}

KnownAs known_as(const std::string& key, const WorstError& error, const Known& known) {
  KnownAs as;
  const auto shown = known.files.find(key);
  if (shown != known.files.end()) as.file = shown->second;
  as.is_in_baseline = known.baseline.contains(key);
  const auto accepted = known.accepted.find(key);
  if (accepted == known.accepted.end()) return as;
  as.acceptance = &accepted->second.acceptance;
  const std::vector<Excess> beyond = beyond_accepted(*as.acceptance, error);
  as.objection = objection(*as.acceptance, beyond, known.today);
  const std::optional<Excess> worst = beyond_known(beyond, known.worst.at(key));
  as.is_worst = worst.has_value();
  if (worst) as.worst_in = worst->component;
  return as;
}

bool is_bucket(const std::string& got, const std::string& recorded) {
  return recorded.empty() || got == recorded || got.starts_with(recorded + '/');
}

std::string objection(const Acceptance& acceptance, const WorstError& error,
                      const std::string& today) {
  return objection(acceptance, beyond_accepted(acceptance, error), today);
}

bool is_stale(const CorpusCase& known, const std::string& got, const Collider& subject,
              const Collider& oracle) {
  if (!known.accepted || !known.expect || !known.property.empty()) return false;
  Expectation now = *known.expect;
  now.subject = subject.declaration.name;
  now.oracle = oracle.declaration.name;
  const bool is_of_these = finding_key(now) == finding_key(*known.expect);
  return is_of_these && !is_bucket(got, known.expect->bucket);
}

std::vector<Finding> findings(const Tally& tally, const Plan& plan, const Known& known) {
  std::vector<Finding> found;
  for (const auto& [bucket, met] : tally.buckets.all()) {
    const KnownAs as = known_as(key_in_plan(bucket, plan), met->error, known);
    Finding finding{bucket, *met, false, as.file};
    const bool is_unknown = finding.file.empty() && !as.is_in_baseline &&
                            (plan.has_ties || bucket.verdict != Verdict::tie);
    // Worse than all that was seen: a case to look at, and to accept or not.
    finding.is_new = is_unknown || as.is_worst;
    if (as.worst_in) {
      finding.tally.worst = met->worst_of[static_cast<std::size_t>(*as.worst_in)];
    }
    if (as.acceptance != nullptr) {
      finding.objection = as.objection.empty()
                              ? objection_to_frequency(*as.acceptance, *met, tally, plan)
                              : as.objection;
      finding.is_accepted = finding.objection.empty();
    } else if (const Acceptance* const of_kind = acceptance_of_kind(bucket, as, plan, known)) {
      finding.objection = objection(*of_kind, met->error, known.today);
      if (finding.objection.empty()) {
        finding.objection =
            objection_to_frequency(*of_kind, all_of_kind(bucket, tally, plan), tally, plan);
      }
      finding.is_accepted = finding.objection.empty();
      finding.is_new = !finding.is_accepted;
    }
    found.push_back(finding);
  }
  std::ranges::stable_sort(
      found, {}, [](const Finding& one) { return place_of(one.bucket, one.tally.count); });
  return found;
}

bool has_new(std::span<const Finding> found) {
  return std::ranges::any_of(found, &Finding::is_new);
}

bool is_new_and_wrong(const Judgement& judgement, const Plan& plan, const Known& known) {
  const Bucket& bucket = judgement.bucket;
  const bool is_wanted =
      is_unexplained(bucket.verdict) || (plan.has_ties && bucket.verdict == Verdict::tie);
  if (!is_wanted) return false;
  const KnownAs as = known_as(key_in_plan(bucket, plan), worst_error(judgement), known);
  if (as.acceptance != nullptr) return !as.is_accepted();
  if (const Acceptance* const of_kind = acceptance_of_kind(bucket, as, plan, known)) {
    return !objection(*of_kind, worst_error(judgement), known.today).empty();
  }
  return as.file.empty() && !as.is_in_baseline;
}

Seen seen_of(const Finding& finding, const Tally& tally, const Plan& plan) {
  Seen seen{.cases = tally.regimes[0].cases,
            .magnitude = finding.tally.error.magnitude,
            .regimes = {},
            .errors = finding.tally.error.errors};
  for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
    seen.cases = std::min(seen.cases, tally.regimes[r].cases);
    seen.regimes[std::string(plan.regimes[r]->name)] = finding.tally.regimes[r];
  }
  return seen;
}

}  // namespace manifuzz
