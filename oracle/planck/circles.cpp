#include "judging/faults/epsilon_deviations.hpp"
#include "oracle/planck/deviations.hpp"

namespace manifuzz {
namespace {

constexpr double kEpsilonOfPlanck = 1e-9;

}  // namespace

bool axis_within_planck_epsilon(const Deviation& d) {
  return ledger_of::is_axis_within(d, kEpsilonOfPlanck);
}

bool face_within_planck_epsilon(const Deviation& d) {
  return ledger_of::is_face_within(d, kEpsilonOfPlanck);
}

}  // namespace manifuzz
