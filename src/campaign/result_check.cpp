#include "campaign/result_check.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/text.hpp"

namespace manifuzz {
namespace {

using Count = std::uint64_t;

void expect_equal(const JsonView& at, Count told, Count summed, std::string_view of) {
  if (told != summed) at.fail(fmt::format("is {}, but {} add up to {}", told, of, summed));
}

void expect_at_most(const JsonView& at, Count count, Count most, std::string_view of) {
  if (count > most) at.fail(fmt::format("is {}, more than {}: {}", count, of, most));
}

template <class Row>
void expect_own_names(const JsonView& rows, const std::vector<Row>& all, std::string Row::*name) {
  std::set<std::string_view> seen;
  for (const Row& row : all) {
    if (!seen.insert(row.*name).second) {
      rows.fail(fmt::format("has {} twice", printable(row.*name, 100)));
    }
  }
}

void check_verdicts(const JsonView& root, const FuzzResult& result) {
  const JsonView verdicts = root.at("verdicts");
  Count all = 0;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    all += result.verdicts[i];
    if (static_cast<Verdict>(i) == Verdict::agree) continue;
    Count found = 0;
    for (const BucketResult& bucket : result.buckets) {
      if (bucket.verdict == kVerdictNames[i]) found += bucket.count;
    }
    expect_equal(verdicts.at(kVerdictNames[i]), result.verdicts[i], found, "its buckets");
  }
  expect_equal(root.at("cases"), root.at("cases").whole_number(), all, "the verdicts");
  expect_equal(root.at("unexplained"), root.at("unexplained").whole_number(), result.unexplained(),
               "those verdicts");
}

void check_buckets(const JsonView& buckets, const FuzzResult& result) {
  expect_own_names(buckets, result.buckets, &BucketResult::bucket);
  const std::vector<JsonView> rows = buckets.elements();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BucketResult& found = result.buckets[i];
    if (std::ranges::find(kVerdictNames, found.verdict) == kVerdictNames.end()) {
      rows[i].at("verdict").fail("is no verdict");
    }
    const auto bucket = find_bucket(found.bucket);
    if (bucket && to_string(bucket->verdict) != found.verdict) {
      rows[i].at("verdict").fail("is not that of the bucket's name");
    }
  }
}

void check_regimes(const JsonView& root, const FuzzResult& result) {
  const JsonView regimes = root.at("regimes");
  expect_own_names(regimes, result.regimes, &RegimeResult::name);
  for (const auto& [key, sum] : {std::pair("cases", result.cases()),
                                 {"touching", result.touching()},
                                 {"near", result.near()}}) {
    expect_equal(root.at(key), root.at(key).whole_number(), sum, "the regimes");
  }
  const std::vector<JsonView> rows = regimes.elements();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RegimeResult& regime = result.regimes[i];
    expect_at_most(rows[i].at("touching"), regime.touching + regime.near, regime.cases,
                   "with those near, the cases");
    expect_at_most(rows[i].at("unexplained"), regime.unexplained, regime.cases, "the cases");
  }
}

void check_parts(const JsonView& root, const FuzzResult& result) {
  Count all = 0;
  for (std::size_t i = 0; i < result.parts.size(); ++i) {
    for (const auto& [regime, cases] : result.parts[i].cases) all += cases;
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(result.parts[i], result.parts[j])) root.at("parts").fail("has cases twice");
    }
  }
  expect_equal(root.at("cases"), result.cases(), all, "the parts");
  for (const RegimeResult& regime : result.regimes) {
    Count ran = 0;
    for (const CasesRun& part : result.parts) {
      const auto cases_of = part.cases.find(regime.name);
      if (cases_of != part.cases.end()) ran += cases_of->second;
    }
    expect_equal(root.at("regimes"), regime.cases, ran,
                 fmt::format("{} in the parts", printable(regime.name, 100)));
  }
}

void check_ledger(const JsonView& ledger, const FuzzResult& result) {
  expect_own_names(ledger, result.ledger, &LedgerResult::id);
  const std::vector<JsonView> rows = ledger.elements();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Count hits = 0;
    for (const auto& [regime, count] : result.ledger[i].regimes) hits += count;
    expect_equal(rows[i].at("hits"), result.ledger[i].hits, hits, "the regimes");
    expect_at_most(rows[i].at("hits"), hits, result.cases(), "the cases");
  }
}

}  // namespace

void expect_consistent(const JsonView& root, const FuzzResult& result) {
  check_verdicts(root, result);
  check_buckets(root.at("buckets"), result);
  check_regimes(root, result);
  check_parts(root, result);
  if (const auto ledger = root.find("ledger")) check_ledger(*ledger, result);
  const auto failed = root.find("failed");
  if (failed && failed->boolean() != has_failed(result)) {
    failed->fail("does not follow from what is told beside it");
  }
}

}  // namespace manifuzz
