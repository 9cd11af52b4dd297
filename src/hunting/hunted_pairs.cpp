#include "hunting/hunted_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "hunting/breeding.hpp"
#include "hunting/moves.hpp"

namespace manifuzz {
namespace {

/// A generation is a share of the cases before it: short ones learn faster, and each has a start to
/// pay for, which grows with the archive.
constexpr CaseNumber kShortestGeneration = 512;
constexpr CaseNumber kShareOfCases = 64;

/// Parents are the newest of so many.
constexpr std::size_t kNewest = 2000;

/// How much a generation weighs beside the next one.
constexpr double kFading = 0.8;

/// Every number of a case that the tally tells of.
std::set<CaseNumber> numbers_in(const Tally& tally) {
  std::set<CaseNumber> numbers;
  for (const BucketTallies::Met& met : tally.buckets.all()) {
    numbers.insert({met.tally->first, met.tally->worst});
    numbers.insert(met.tally->worst_of.begin(), met.tally->worst_of.end());
  }
  for (const LeastCases& least : tally.first_wrong) {
    numbers.insert(least.all().begin(), least.all().end());
  }
  return numbers;
}

}  // namespace

HuntedPairs::HuntedPairs(Breed breed, const Plan& plan)
    : ObservedPairs(kLongestGeneration + breed.founders.size(), breed.aim, breed.on_judged),
      breed_(std::move(breed)),
      seed_(plan.seed),
      first_(plan.first),
      context_(plan.context),
      elite_(breed_.aim) {
  for (const ArchivedCase& one : breed_.earlier) add_to(archive(), elite_, one, aim());
}

std::string HuntedPairs::options_again(const Plan& plan, CaseNumber number) const {
  if (!breed_.again.empty()) return breed_.again;
  return fmt::format(" --seed {} --cases {}", plan.seed, number + 1);
}

PairCase HuntedPairs::pair(const Plan&, CaseNumber number) const {
  return kept_or_born(number);
}

PairCase HuntedPairs::kept_or_born(CaseNumber number) const {
  const auto kept = kept_.find(number);
  if (kept != kept_.end()) return kept->second;
  if (number < breed_.founders.size()) return breed_.founders[number];
  return number >= cases().begin && number < cases().end ? born(number) : drawn(number);
}

PairCase HuntedPairs::drawn(CaseNumber number) const {
  const std::size_t regimes = breed_.regimes.size();
  const CaseNumber of_all = first_ + number;
  return generate(seed_, *breed_.regimes[of_all % regimes], of_all / regimes, context_);
}

PairCase HuntedPairs::born(CaseNumber number) const {
  const Birth& birth = births_[number - cases().begin];
  if (birth.source == Source::drawn) return drawn(number);
  Random random(seed_, kHunted.stream, first_ + number);
  const PairCase& parent = archive()[birth.parent].pair;
  const PairCase& mate = archive()[birth.mate].pair;
  // The worst are climbed by single numbers, mostly.
  const BreedShares shares{.of_numbers = birth.source == Source::worst ? 0.7 : 0.25,
                           .renumbered = 1};
  constexpr int attempts = 8;
  for (int i = 0; i < attempts; ++i) {
    std::optional<PairCase> child = bred(random, parent, mate, shares);
    if (!child) continue;
    // What is apart shows less than what touches.
    if (random.chance(0.75)) close_gap(random, *child);
    if (!is_in_use(*child)) continue;
    put_radius(context_, *child);
    if (is_taken(context_, *child)) return *child;
  }
  return drawn(number);
}

std::array<double, HuntedPairs::kSources> HuntedPairs::shares_of_sources() const {
  if (archive().is_empty()) return {0, 1};
  std::array<double, kSources> shares{};
  const auto at = [](Source source) { return static_cast<std::size_t>(source); };
  constexpr std::array filling{Source::drawn,     Source::pair_cell,  Source::label_cell,
                               Source::kind_cell, Source::count_cell, Source::newest};
  // Each has enough to be seen when it does better; cells of counts are few, and lead to others
  // when they no longer fill.
  const double of_greatest = elite_.is_empty() ? 0 : aim().bred_from_greatest;
  const double of_filling = 1 - of_greatest;
  for (const Source source : filling) shares[at(source)] = 0.1 * of_filling;
  shares[at(Source::count_cell)] = 0.1875 * of_filling;
  shares[at(Source::worst)] = of_greatest;
  const double rest = 1 - std::accumulate(shares.begin(), shares.end(), 0.0);
  const auto yield_of = [&](Source source) {
    const Yield& yield = yields_[at(source)];
    return (yield.cells + 1) / (yield.cases + 1);
  };
  double all = 0;
  for (const Source source : filling) all += yield_of(source);
  for (const Source source : filling) shares[at(source)] += rest * yield_of(source) / all;
  return shares;
}

EntryId HuntedPairs::in_rare_cell(Archive::Set set, Random& random) const {
  const auto any_cell = [&]() -> const Archive::Cell& {
    const auto count = static_cast<int>(archive().cell_count(set));
    return archive().cell(set, static_cast<std::size_t>(random.integer(0, count - 1)));
  };
  constexpr int candidates = 16;
  const Archive::Cell* rarest = &any_cell();
  for (int i = 1; i < candidates; ++i) {
    const Archive::Cell& cell = any_cell();
    if (cell.visits < rarest->visits) rarest = &cell;
  }
  return rarest->entry;
}

EntryId HuntedPairs::less_used(std::span<const EntryId> entries, Random& random) const {
  const auto any = [&] {
    const auto last = static_cast<int>(entries.size()) - 1;
    return entries[static_cast<std::size_t>(random.integer(0, last))];
  };
  const EntryId one = any();
  const EntryId other = any();
  return archive()[one].uses <= archive()[other].uses ? one : other;
}

EntryId HuntedPairs::parent_from(Source source, Random& random, const Eligible& eligible) const {
  switch (source) {
    case Source::label_cell:
      return in_rare_cell(Archive::Set::labels, random);
    case Source::kind_cell:
      return in_rare_cell(Archive::Set::kinds, random);
    case Source::count_cell:
      return in_rare_cell(Archive::Set::counts, random);
    case Source::newest:
      if (eligible.newest.empty()) break;
      return less_used(eligible.newest, random);
    case Source::worst: {
      const auto& greatest = eligible.greatest;
      if (greatest.empty()) break;
      const int any = random.integer(0, static_cast<int>(greatest.size()) - 1);
      return less_used(greatest[static_cast<std::size_t>(any)], random);
    }
    default:
      break;
  }
  return in_rare_cell(Archive::Set::pairs, random);
}

HuntedPairs::Birth HuntedPairs::birth_of(CaseNumber number,
                                         const std::array<double, kSources>& shares,
                                         const Eligible& eligible) {
  if (number < breed_.founders.size()) return {Source::founded};
  Random random(seed_, "birth", first_ + number);
  double place = random.unit();
  std::size_t source = 0;
  while (source + 1 < kSources && place >= shares[source]) place -= shares[source++];
  Birth birth{static_cast<Source>(source)};
  if (birth.source == Source::drawn || birth.source == Source::founded) return {Source::drawn};
  birth.parent = parent_from(birth.source, random, eligible);
  birth.mate = parent_from(Source::pair_cell, random, eligible);
  ++archive()[birth.parent].uses;
  archive().hold(birth.parent);
  archive().hold(birth.mate);
  return birth;
}

SharedQueue::Block HuntedPairs::begin_generation(CaseNumber most) {
  const CaseNumber begun = cases().end;
  const CaseNumber learnt_from = begun + (breed_.earlier.empty() ? 0 : first_);
  CaseNumber length =
      std::clamp(learnt_from / kShareOfCases, kShortestGeneration, kLongestGeneration);
  if (generations_ == 0) length += breed_.founders.size();
  const std::array<double, kSources> shares = shares_of_sources();
  const Eligible eligible{archive().newest(kNewest), elite_.by_gauge()};
  births_.clear();
  length = std::min(length, most);
  for (CaseNumber i = 0; i < length; ++i) births_.push_back(birth_of(begun + i, shares, eligible));
  ++generations_;
  begin_part({begun, begun + length});
  return cases();
}

void HuntedPairs::keep_cases_of(const Tally& tally) {
  std::set<CaseNumber> numbers = numbers_in(tally);
  for (const Worst& of_gauge : worst()) {
    if (of_gauge.value > 0) numbers.insert(of_gauge.number);
  }
  std::map<CaseNumber, PairCase> kept;
  for (const CaseNumber number : numbers) kept.emplace(number, kept_or_born(number));
  kept_ = std::move(kept);
}

void HuntedPairs::take_in(CaseNumber number, const Observation& observed,
                          const std::optional<Archive::Taken>& taken) {
  const Birth& birth = births_[number - cases().begin];
  Yield& yield = yields_[static_cast<std::size_t>(birth.source)];
  ++yield.cases;
  if (!taken) return;
  yield.cells += taken->new_cells;
  const auto entry =
      elite_.add(observed, taken->entry, archive(), [&] { return kept_or_born(number); });
  if (entry) archive()[*entry].number = first_ + number;
}

void HuntedPairs::end_generation(const Tally& tally) {
  for (Yield& yield : yields_) {
    yield.cells *= kFading;
    yield.cases *= kFading;
  }
  end_part();
  keep_cases_of(tally);
  for (const Birth& birth : births_) {
    if (birth.source == Source::drawn || birth.source == Source::founded) continue;
    archive().let_go(birth.parent);
    archive().let_go(birth.mate);
  }
}

}  // namespace manifuzz
