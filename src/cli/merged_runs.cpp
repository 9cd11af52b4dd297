#include "cli/merged_runs.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "campaign/budgets.hpp"
#include "cases/user_error.hpp"
#include "cli/fuzz_report.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;
using Count = std::uint64_t;

/// Which cases a result counts: of each regime so many from `first` on, under a seed.
Json parts_of(const Json& run) {
  if (run.contains("parts")) return run.at("parts");
  Json cases = Json::object();
  for (const Json& regime : run.at("regimes")) {
    cases[regime.at("name").get<std::string>()] = regime.at("cases").get<Count>();
  }
  return Json::array({{{"seed", run.at("seed")}, {"first", run.at("first")}, {"cases", cases}}});
}

bool overlap(const Json& part, const Json& with) {
  if (part.at("seed") != with.at("seed")) return false;
  const Count first = part.at("first").get<Count>();
  const Count with_first = with.at("first").get<Count>();
  return std::ranges::any_of(part.at("cases").items(), [&](const auto& regime) {
    if (!with.at("cases").contains(regime.key())) return false;
    const Count cases = regime.value().template get<Count>();
    const Count with_cases = with.at("cases").at(regime.key()).template get<Count>();
    return first < with_first ? with_first - first < cases : first - with_first < with_cases;
  });
}

void expect_fuzz(const Result& result) {
  if (result.kind == "fuzz") return;
  throw UserError(fmt::format("is a result of {}; those of fuzz can be added up", result.kind));
}

void expect_addable(const Json& sum, const Json& run) {
  for (const char* const key : {"subject", "oracle", "versions"}) {
    if (sum.at(key) == run.at(key)) continue;
    throw UserError(fmt::format("its {} is {}, that of the results before {}", key,
                                run.at(key).dump(), sum.at(key).dump()));
  }
  for (const Json& part : sum.at("parts")) {
    for (const Json& with : parts_of(run)) {
      if (!overlap(part, with)) continue;
      throw UserError(fmt::format("counts cases of seed {} from {} on, which are counted already",
                                  with.at("seed").dump(), with.at("first").dump()));
    }
  }
}

template <class Number>
void add_number(Json& to, const Json& from) {
  to = to.get<Number>() + from.get<Number>();
}

/// A magnitude, or infinity, for which null stands.
double magnitude_of(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

void keep_greater(Json& kept, const Json& other) {
  if (magnitude_of(other) > magnitude_of(kept)) kept = other;
}

/// The row of that name in `rows`, or nullptr.
Json* find_row(Json& rows, const char* key, const Json& name) {
  for (Json& row : rows) {
    if (row.at(key) == name) return &row;
  }
  return nullptr;
}

void add_regimes(Json& rows, const Json& others) {
  for (const Json& other : others) {
    Json* const row = find_row(rows, "name", other.at("name"));
    if (row == nullptr) {
      rows.push_back(other);
      continue;
    }
    for (const char* const key : {"cases", "touching", "near", "unexplained"}) {
      add_number<Count>(row->at(key), other.at(key));
    }
  }
}

void add_ledger(Json& rows, const Json& others) {
  for (const Json& other : others) {
    Json* const row = find_row(rows, "id", other.at("id"));
    if (row == nullptr) {
      rows.push_back(other);
      continue;
    }
    add_number<Count>(row->at("hits"), other.at("hits"));
    for (const auto& [regime, hits] : other.at("regimes").items()) {
      Json& sum = row->at("regimes")[regime];
      sum = sum.is_null() ? hits.get<Count>() : sum.get<Count>() + hits.get<Count>();
    }
  }
}

/// A case's place in the order of a campaign: its index, then its regime's turn.
std::pair<Count, std::size_t> place_of(const Json& bucket, const Json& regimes) {
  std::size_t turn = 0;
  while (turn < regimes.size() && regimes[turn].at("name") != bucket.at("regime")) ++turn;
  return {bucket.at("first_index").get<Count>(), turn};
}

void add_buckets(Json& sum, const Json& run) {
  for (const Json& other : run.at("buckets")) {
    Json* const row = find_row(sum.at("buckets"), "bucket", other.at("bucket"));
    if (row == nullptr) {
      sum.at("buckets").push_back(other);
      continue;
    }
    add_number<Count>(row->at("count"), other.at("count"));
    keep_greater(row->at("magnitude"), other.at("magnitude"));
    row->at("new") = row->at("new").get<bool>() || other.at("new").get<bool>();
    const Json& regimes = sum.at("regimes");
    const bool is_comparable = sum.at("seed") == run.at("seed");
    if (!is_comparable || place_of(*row, regimes) <= place_of(other, regimes)) continue;
    for (const char* const key : {"first_index", "regime", "command"}) row->at(key) = other.at(key);
  }
}

/// What follows from the sums.
void conclude(Json& sum) {
  const double seconds = sum.at("seconds").get<double>();
  const double cases = static_cast<double>(sum.at("cases").get<Count>());
  sum.at("cases_per_second") = seconds > 0 ? cases / seconds : 0;
  std::vector<RegimeCount> counts;
  std::map<std::string_view, Count> cases_of;
  for (const Json& regime : sum.at("regimes")) {
    const std::string_view name = regime.at("name").get_ref<const std::string&>();
    counts.push_back({name, regime.at("cases").get<Count>(), regime.at("touching").get<Count>()});
    cases_of[name] = counts.back().cases;
  }
  sum.at("vacuous") = is_vacuous(counts);
  for (Json& row : sum.at("ledger")) {
    row.at("over_budget") = Json::array();
    const auto entry =
        std::ranges::find(ledger(), row.at("id").get<std::string>(), &LedgerEntry::id);
    if (entry == ledger().end() || !sum.at("budgets_hold").get<bool>()) continue;
    for (const auto& [regime, hits] : row.at("regimes").items()) {
      if (is_over_budget(*entry, regime, hits.get<Count>(), cases_of[regime])) {
        row.at("over_budget").push_back(regime);
      }
    }
  }
  std::ranges::stable_sort(sum.at("buckets").get_ref<Json::array_t&>(), {}, [](const Json& row) {
    return index_of(find_bucket(row.at("bucket").get<std::string>()).value());
  });
}

/// The sum of no runs, with this one's terms.
Json nothing_of(const Json& run) {
  Json sum = run;
  for (const char* const key : {"cases", "touching", "near", "unexplained"}) sum.at(key) = 0;
  for (auto& count : sum.at("verdicts")) count = 0;
  for (auto& error : sum.at("worst_error")) error = {{"depth", 0.0}, {"position", 0.0}};
  sum.at("seconds") = 0.0;
  for (const char* const key : {"regimes", "ledger", "buckets"}) sum.at(key) = Json::array();
  sum["parts"] = Json::array();
  sum.erase("baseline");
  return sum;
}

void add_run(Json& sum, const Json& run) {
  expect_addable(sum, run);
  for (const char* const key : {"cases", "touching", "near", "unexplained"}) {
    add_number<Count>(sum.at(key), run.at(key));
  }
  add_number<double>(sum.at("seconds"), run.at("seconds"));
  for (const auto& [verdict, count] : run.at("verdicts").items()) {
    add_number<Count>(sum.at("verdicts").at(verdict), count);
  }
  for (const auto& [party, error] : run.at("worst_error").items()) {
    for (const char* const key : {"depth", "position"}) {
      keep_greater(sum.at("worst_error").at(party).at(key), error.at(key));
    }
  }
  sum.at("jobs") = std::max(sum.at("jobs").get<Count>(), run.at("jobs").get<Count>());
  for (const char* const key : {"interrupted", "stopped_early"}) {
    sum.at(key) = sum.at(key).get<bool>() || run.at(key).get<bool>();
  }
  sum.at("budgets_hold") = sum.at("budgets_hold").get<bool>() && run.at("budgets_hold").get<bool>();
  add_regimes(sum.at("regimes"), run.at("regimes"));
  add_ledger(sum.at("ledger"), run.at("ledger"));
  add_buckets(sum, run);
  for (const Json& part : parts_of(run)) sum.at("parts").push_back(part);
  if (sum.at("seed") != run.at("seed")) sum.at("seed") = nullptr;
  sum.at("first") = std::min(sum.at("first").get<Count>(), run.at("first").get<Count>());
  conclude(sum);
}

}  // namespace

MergedRuns merged_runs(std::span<const Result> results) {
  MergedRuns merged;
  for (const Result& result : results) {
    try {
      expect_fuzz(result);
      Json sum = merged.json.is_null() ? nothing_of(result.json) : merged.json;
      add_run(sum, result.json);
      merged.json = std::move(sum);
    } catch (const UserError& error) {
      merged.errors.push_back(fmt::format("{}: {}", result.path, error.what()));
    } catch (const std::exception&) {
      merged.errors.push_back(fmt::format("{}: what fuzz --json writes is expected", result.path));
    }
  }
  return merged;
}

}  // namespace manifuzz
