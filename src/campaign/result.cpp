#include "campaign/result.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"

namespace manifuzz {

std::uint64_t CampaignResult::unexplained() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (is_unexplained(static_cast<Verdict>(i))) sum += verdicts[i];
  }
  return sum - std::min(sum, accepted());
}

double CampaignResult::seconds() const {
  double sum = 0;
  for (const CasesRun& part : parts) sum += part.seconds;
  return sum;
}

std::optional<std::uint64_t> CampaignResult::seed() const {
  if (parts.empty() || parts.front().seed != parts.back().seed) return std::nullopt;
  return parts.front().seed;
}

std::uint64_t CampaignResult::first() const {
  const auto least = std::ranges::min_element(parts, {}, &CasesRun::first);
  return least == parts.end() ? 0 : least->first;
}

bool overlap(const CasesRun& part, const CasesRun& with) {
  if (part.seed != with.seed) return false;
  return std::ranges::any_of(part.cases, [&](const auto& regime) {
    const auto& [name, cases] = regime;
    const auto same = with.cases.find(name);
    if (same == with.cases.end()) return false;
    return part.first < with.first ? with.first - part.first < cases
                                   : part.first - with.first < same->second;
  });
}

namespace {

bool goes_on(const CasesRun& part, const CasesRun& next) {
  return part.seed == next.seed &&
         std::ranges::equal(part.cases, next.cases, [&](const auto& of_part, const auto& of_next) {
           return of_part.first == of_next.first && part.first + of_part.second == next.first;
         });
}

/// So coarse that sums of them are exact, whatever is added first.
double in_parts_of_a_second(double seconds) {
  constexpr int binary_digits = 20;
  return std::ldexp(std::round(std::ldexp(seconds, binary_digits)), -binary_digits);
}

}  // namespace

void join(std::vector<CasesRun>& parts) {
  std::ranges::sort(parts);
  std::vector<CasesRun> joined;
  for (const CasesRun& part : parts) {
    if (joined.empty() || !goes_on(joined.back(), part)) {
      joined.push_back(part);
      joined.back().seconds = in_parts_of_a_second(part.seconds);
      continue;
    }
    for (const auto& [regime, cases] : part.cases) joined.back().cases[regime] += cases;
    joined.back().seconds += in_parts_of_a_second(part.seconds);
  }
  parts = std::move(joined);
}

bool is_all_unsupported(const CampaignResult& result) {
  const std::uint64_t unsupported = result.verdicts[static_cast<std::size_t>(Verdict::unsupported)];
  return unsupported > 0 && unsupported == result.cases();
}

bool is_vacuous(const CampaignResult& result) {
  if (result.cases() == 0) return !result.interrupted;  // it says that already
  if (is_all_unsupported(result)) return true;
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;
  for (const RegimeResult& regime : result.regimes) {
    if (regime.name == "separated") continue;
    cases += regime.cases;
    touching += regime.touching;
  }
  return cases >= kVacuousCases && touching == 0;
}

std::uint64_t CampaignResult::accepted() const {
  std::uint64_t sum = 0;
  for (const BucketResult& found : buckets) sum += found.is_accepted ? found.count : 0;
  return sum;
}

bool decides_status(const BucketResult& found) {
  if (found.is_accepted || found.is_in_baseline) return false;
  const auto bucket = find_bucket(found.bucket);
  return !bucket || is_failure(*bucket) ||
         (found.is_new && bucket->verdict == Verdict::oracle_wrong);
}

std::uint64_t failures_in(const CampaignResult& result, const std::string& regime) {
  std::uint64_t sum = 0;
  for (const BucketResult& found : result.buckets) {
    const auto bucket = find_bucket(found.bucket);
    const auto count = found.regimes.find(regime);
    if (!bucket || !is_failure(*bucket) || !decides_status(found)) continue;
    if (count != found.regimes.end()) sum += count->second;
  }
  return sum;
}

bool has_failed(const CampaignResult& result) {
  return is_vacuous(result) ||
         std::ranges::any_of(result.buckets,
                             [](const BucketResult& found) { return decides_status(found); }) ||
         std::ranges::any_of(result.ledger,
                             [](const LedgerResult& entry) { return !entry.over_budget.empty(); });
}

namespace {

namespace fs = std::filesystem;

/// The largest result that is read.
constexpr std::size_t kLongestResult = std::size_t{1} << 28;

/// A key that the results of one command alone have, among those behind it in the list.
struct KindKey {
  std::string_view kind;
  std::string_view key;
};
constexpr std::array kKindKeys{KindKey{"fuzz", "buckets"}, KindKey{"replay", "failures"},
                               KindKey{"stress", "sweeps"}, KindKey{"scene", "exponents"},
                               KindKey{"bench", "rows"}};

/// What wrote it, or nullptr.
const KindKey* kind_of(const JsonView& root) {
  if (!root.is_object() || !root.find("machine")) return nullptr;
  const auto known = std::ranges::find_if(
      kKindKeys, [&](const KindKey& kind) { return root.find(kind.key).has_value(); });
  return known == kKindKeys.end() ? nullptr : &*known;
}

ResultFile result_of(const std::string& path, const JsonTree& tree, const KindKey& kind) {
  const JsonView root(tree);
  ResultFile result{path, kind.kind, {}};
  if (kind.kind == "fuzz") {
    result.campaign = read_campaign_result(root);
    result.json = json_of(*result.campaign);
  } else {
    for (const JsonView& row : root.at(kind.key).elements()) row.keys();
    result.json = *tree.root;  // where a negative whole number is a double; none is ours
  }
  return result;
}

/// Calls `use` with the file's JSON; what is wrong with either names the file.
template <class Use>
auto with_json_of(const std::string& path, const Use& use) {
  InputFile file(path);
  const std::string text = file.read_all(kLongestResult);
  try {
    if (is_blank(text)) throw UserError("is empty; a case or a result is expected");
    return use(parse_json(text));
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}: {}", file.name(), error.what()));
  }
}

void read_json_file(const std::string& path, RunFiles& files) {
  with_json_of(path, [&](const JsonTree& tree) {
    const JsonView root(tree);
    if (const KindKey* const kind = kind_of(root)) {
      files.results.push_back(result_of(path, tree, *kind));
    } else {
      CorpusCase known = read_case(root, path == "-" ? FormatKey::optional : FormatKey::required,
                                   CaseKind::either);
      known.path = path;
      files.corpus.add(std::move(known));
    }
  });
}

}  // namespace

ResultFile read_result(const std::string& path) {
  return with_json_of(path, [&](const JsonTree& tree) {
    const KindKey* const kind = kind_of(JsonView(tree));
    if (kind == nullptr) throw UserError("is no result; what --json writes is expected");
    return result_of(path, tree, *kind);
  });
}

RunFiles read_run_files(std::span<const fs::path> paths) {
  RunFiles files;
  files.corpus.files = find_case_files(paths, files.corpus.errors);
  for (const auto& path : files.corpus.files) {
    if (path != "-" && path.extension() != ".json") {
      add_case_file(path, files.corpus);
      continue;
    }
    try {
      read_json_file(path.string(), files);
    } catch (const UserError& error) {
      files.corpus.errors.emplace_back(error.what());
    }
  }
  return files;
}

}  // namespace manifuzz
