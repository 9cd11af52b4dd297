#include "measure/stress/step_tally.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

/// The spread of what `value_of` finds in each contact.
template <class Contacts, class ValueOf>
Spread spread_of(const Contacts& contacts, const ValueOf& value_of) {
  if (contacts.empty()) return {};
  std::vector<float> values;
  values.reserve(contacts.size());
  Spread spread{.max = -1};
  for (const auto& contact : contacts) {
    const float value = value_of(contact);
    values.push_back(value);
    if (value <= spread.max) continue;
    spread.max = value;
    spread.worst = contact.index;
  }
  const auto at = [&values](double share) {
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  spread.median = at(0.5);
  spread.p999 = at(0.999);
  return spread;
}

template <class Contacts, class FiguresOf>
FigureSpreads spreads_of(const Contacts& contacts, const FiguresOf& figures_of) {
  const auto spread = [&](float FigureErrors::*figure) {
    return spread_of(contacts, [&](const auto& contact) { return figures_of(contact).*figure; });
  };
  return {spread(&FigureErrors::depth), spread(&FigureErrors::position),
          spread(&FigureErrors::normal)};
}

std::uint64_t* count_of(StepTally& tally, Assessment assessment) {
  switch (assessment) {
    case Assessment::unsupported:
      return &tally.unsupported;
    case Assessment::ill_posed:
      return &tally.ill_posed;
    case Assessment::missed:
      return &tally.missed;
    case Assessment::phantom:
      return &tally.phantom;
    case Assessment::wrong_count:
      return &tally.wrong_count;
    case Assessment::gross:
      return &tally.gross;
    case Assessment::lost:
      return &tally.lost;
    case Assessment::right:
      break;
  }
  return nullptr;
}

}  // namespace

void StepCollector::add(std::uint64_t index, const Measured& measured) {
  ++counts_.cases;
  if (std::uint64_t* const count = count_of(counts_, measured.assessment)) ++*count;
  const bool is_first = is_wrong(measured.assessment) && counts_.wrong() == 1;
  if (is_first || (is_wrong(measured.assessment) && measured.wrongness > counts_.wrongness)) {
    counts_.wrongness = measured.wrongness;
    counts_.worst_wrong = index;
  }
  if (!measured.has_errors) return;
  ++counts_.contacts;
  if (errors_ == Errors::kept)
    contacts_.push_back({index, measured.of_size, measured.of_bound, measured.of_extent});
}

StepTally StepCollector::tally() const {
  StepTally tally = counts_;
  tally.of_size = spreads_of(contacts_, [](const Contact& c) { return c.of_size; });
  tally.of_bound = spreads_of(contacts_, [](const Contact& c) { return c.of_bound; });
  tally.of_extent = spread_of(contacts_, [](const Contact& c) { return c.of_extent; });
  return tally;
}

bool is_broken(const StepTally& step) {
  if (step.wrong() > 0 && step.wrong() * kWrongEvery >= step.well_posed()) return true;
  constexpr auto gross = static_cast<float>(kGrossShare);
  return step.of_size.depth.p999 > gross || step.of_size.position.p999 > gross ||
         step.of_size.normal.p999 > gross;
}

std::optional<std::size_t> breaking_step(std::span<const StepTally> steps) {
  const auto broken = std::ranges::find_if(steps, is_broken);
  if (broken == steps.end()) return std::nullopt;
  return static_cast<std::size_t>(broken - steps.begin());
}

}  // namespace manifuzz
