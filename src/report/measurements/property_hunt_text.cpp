#include "report/measurements/property_hunt_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.hpp"
#include "report/campaign_text.hpp"

namespace manifuzz {
namespace {

/// The property nearest to its bound of those that hold, with a separator before it; or empty.
std::string nearest_in_words(const std::vector<HuntedProperty>& hunted) {
  const HuntedProperty* nearest = nullptr;
  for (const HuntedProperty& one : hunted) {
    if (one.first || one.worst <= 0) continue;
    if (nearest == nullptr || one.worst > nearest->worst) nearest = &one;
  }
  if (nearest == nullptr) return "";
  return fmt::format("; {} takes {:.3g} of its bound", nearest->property->name, nearest->worst);
}

}  // namespace

std::string property_hunt_line(const PropertyHuntProgress& progress) {
  const auto failing = std::ranges::count_if(
      progress.hunted, [](const HuntedProperty& one) { return one.first.has_value(); });
  const double share = static_cast<double>(progress.cases) / static_cast<double>(progress.of);
  std::string line = fmt::format(
      "{} cases, {:.0f} a second; {} cells; {} of {} fail{}", progress.cases,
      per_second(progress.cases, progress.seconds), progress.cells, failing,
      counted(progress.hunted.size(), "property", "properties"), nearest_in_words(progress.hunted));
  if (share > 0) line += fmt::format("; {:.0f} s left", progress.seconds * (1 / share - 1));
  return line;
}

std::string property_hunt_row(const PropertyHunt& hunt) {
  return fmt::format("hunted {} in {}, {}{}\n", counted(hunt.cases, "case"),
                     counted(hunt.generations, "generation"), counted(hunt.cells, "cell"),
                     nearest_in_words(hunt.hunted));
}

}  // namespace manifuzz
