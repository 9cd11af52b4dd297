#include "measure/stress/plan.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/names.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"

namespace manifuzz {

void choose_sweeps(const std::vector<std::string>& names, std::string_view option,
                   StressPlan& plan) {
  struct Choice {
    std::string_view name;
    const Sweep* sweep;
    const Walk* walk;
  };
  std::vector<Choice> all;
  for (const Sweep& sweep : sweeps()) all.push_back({sweep.name, &sweep, nullptr});
  for (const Walk& walk : walks()) all.push_back({walk.name, nullptr, &walk});
  for (const Choice* const one : chosen_by_name(all, names, "sweep", option)) {
    if (one->sweep != nullptr) plan.sweeps.push_back(one->sweep);
    if (one->walk != nullptr) plan.walks.push_back(one->walk);
  }
}

std::vector<StressSubject> with_variants(const std::vector<StressSubject>& chosen) {
  std::vector<StressSubject> subjects{ideal_subject()};
  const auto add = [&subjects](StressSubject subject) {
    if (std::ranges::find(subjects, subject.name, &StressSubject::name) != subjects.end()) {
      throw UserError(
          fmt::format("--collider: there is more than one '{}'", printable(subject.name)));
    }
    subjects.push_back(std::move(subject));
  };
  for (const StressSubject& subject : chosen) {
    add(subject);
    if (!subject.collider.with_tie_bias) continue;
    add({subject.name + " with a bias", subject.collider.with_tie_bias(kWalkBias), true,
         subject.is_ours});
  }
  if (subjects.size() > kSubjectsMax) throw UserError("--collider: that is too many at once");
  return subjects;
}

}  // namespace manifuzz
