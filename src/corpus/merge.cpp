#include "corpus/merge.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "campaign/findings.hpp"
#include "corpus/simplicity.hpp"
#include "generating/regime.hpp"

namespace manifuzz {
namespace {

std::string key_of(const CorpusCase& known) {
  if (known.expect && !known.expect->bucket.empty()) return finding_key(*known.expect);
  std::string line;
  append_case_line(line, known.pair);
  return known.property + '|' + line;
}

/// The order in which witnesses are preferred, the first the best.
auto badness(const CorpusCase& witness) {
  const double magnitude = witness.expect ? witness.expect->magnitude.value_or(-1) : -1;
  const Found found = witness.found.value_or(Found{});
  const auto place = std::ranges::find(regimes(), found.regime, &Regime::name);
  return std::tuple(-magnitude, found.index, place - regimes().begin(), found.seed, witness.path);
}

auto size_of(const CorpusCase& known) {
  return std::pair(complexity(known.pair), badness(known));
}

using Members = std::vector<const CorpusCase*>;

/// The least by an order that is not cheap to tell.
template <class Order>
const CorpusCase& least(const Members& members, const Order& order) {
  const CorpusCase* best = members.front();
  auto rank = order(*best);
  for (const CorpusCase* known : std::span(members).subspan(1)) {
    auto other = order(*known);
    if (!(other < rank)) continue;
    best = known;
    rank = std::move(other);
  }
  return *best;
}

MergedFinding gathered_of(const Members& members) {
  std::set<std::string> shrunk;  // files beside which lies what they were shrunk from
  for (const CorpusCase* known : members) {
    if (is_worst(known->path)) shrunk.insert(shrunk_beside(known->path));
  }
  Members as_seen;
  for (const CorpusCase* known : members) {
    if (!shrunk.contains(known->path)) as_seen.push_back(known);
  }
  MergedFinding kept{least(members, size_of), {}};
  const CorpusCase& worst = least(as_seen, badness);
  if (worst.pair != kept.smallest.pair) kept.worst = worst;
  return kept;
}

}  // namespace

std::vector<MergedFinding> merged_findings(const std::vector<CorpusCase>& cases) {
  std::map<std::string, Members> groups;
  for (const CorpusCase& known : cases) groups[key_of(known)].push_back(&known);
  std::vector<MergedFinding> all;
  for (const auto& [key, members] : groups) all.push_back(gathered_of(members));
  return all;
}

}  // namespace manifuzz
