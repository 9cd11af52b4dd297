#include "campaign/gather.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "campaign/findings.hpp"
#include "cases/regime.hpp"
#include "cases/simplicity.hpp"

namespace manifuzz {
namespace {

constexpr std::string_view kWorst = ".worst.json";

/// The file without its ending: the same for a case and for what it was shrunk from.
std::string stem_of(const std::string& path) {
  const std::string_view ending = path.ends_with(kWorst) ? kWorst : ".json";
  return path.ends_with(ending) ? path.substr(0, path.size() - ending.size()) : path;
}

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

template <class Order>
const CorpusCase& least(const Members& members, const Order& order) {
  return **std::ranges::min_element(members, {}, [&](const auto* known) { return order(*known); });
}

Gathered gathered_of(const Members& members) {
  std::set<std::string> shrunk_from;  // stems of which the worst is there
  for (const CorpusCase* known : members) {
    if (known->path.ends_with(kWorst)) shrunk_from.insert(stem_of(known->path));
  }
  Members as_seen;
  for (const CorpusCase* known : members) {
    const bool is_shrunk =
        !known->path.ends_with(kWorst) && shrunk_from.contains(stem_of(known->path));
    if (!is_shrunk) as_seen.push_back(known);
  }
  Gathered kept{least(members, size_of), {}};
  const CorpusCase& worst = least(as_seen, badness);
  if (worst.pair != kept.smallest.pair) kept.worst = worst;
  return kept;
}

}  // namespace

std::vector<Gathered> gathered(const std::vector<CorpusCase>& cases) {
  std::map<std::string, Members> groups;
  for (const CorpusCase& known : cases) groups[key_of(known)].push_back(&known);
  std::vector<Gathered> all;
  for (const auto& [key, members] : groups) all.push_back(gathered_of(members));
  return all;
}

}  // namespace manifuzz
