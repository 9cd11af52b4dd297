#include <cmath>

#include "judging/ledger/differences.hpp"
#include "judging/ledger/separating_axes/axes_deviations.hpp"
#include "judging/ledger/separating_axes/godot_solver.hpp"

// Godot 3.2.3: its operations are repeated, and again with faults mended.

namespace manifuzz {
namespace {

constexpr unsigned kFaultsOfGodot = 31;

constexpr bool has(unsigned faults, FaultOfGodot fault) {
  return (faults & static_cast<unsigned>(fault)) != 0;
}

/// As relay.py declares it.
Declaration as_declared_by_godot() {
  Declaration declaration;
  declaration.frame = RoundingFrame::world;
  declaration.min_vertices = 1;
  declaration.takes_radius = false;
  declaration.second_point = {0.99998};  // _SEGMENT_IS_VALID_SUPPORT_THRESHOLD
  declaration.clips = false;
  declaration.points = PointsAt::surface_a;
  declaration.shares_depth = true;
  declaration.one_point_enough = true;
  declaration.least_depth = as_godot::kCmpEpsilon;
  return declaration;
}

replayed::Contact answer_of_godot(const Deviation& d, unsigned mended) {
  const as_godot::Mends mends{.is_segment_unit = has(mended, FaultOfGodot::segment_length),
                              .is_edge_farthest = has(mended, FaultOfGodot::first_edge),
                              .is_along_edges = has(mended, FaultOfGodot::first_ends)};
  as_godot::GodotAnswer answer = as_godot::by_godot(d.right.pair(), mends);
  if (has(mended, FaultOfGodot::tested_axis)) {
    const Vector2<double> least = replayed::least_normal_near(d, answer.axis);
    answer = as_godot::by_godot(d.right.pair(), mends, least);
    answer.axis = least;
    answer.depth = ledger_of::least_depth(d);
  }
  if (has(mended, FaultOfGodot::short_difference)) {
    answer.contact.normal = answer.axis;
    for (replayed::Contact::Point& point : answer.contact.points) point.depth = answer.depth;
  }
  return answer.contact;
}

/// Whether no axis has less overlap than the one that was kept, but for rounding.
bool is_axis_of_least_overlap(const Deviation& d) {
  return as_godot::by_godot(d.right.pair(), {}).depth - ledger_of::least_depth(d) <=
         4 * d.right.bounds.separation;
}

}  // namespace

template <FaultOfGodot kFault>
bool fault_of_godot(const Deviation& d) {
  if (kFault == FaultOfGodot::tested_axis && !is_axis_of_least_overlap(d)) return false;
  if (!replayed::is_same_answer(d, answer_of_godot(d, 0))) return false;
  return replayed::is_needed(static_cast<unsigned>(kFault), kFaultsOfGodot, [&](unsigned mended) {
    return replayed::is_right_answer(d, as_declared_by_godot(), answer_of_godot(d, mended));
  });
}

template bool fault_of_godot<FaultOfGodot::short_difference>(const Deviation&);
template bool fault_of_godot<FaultOfGodot::first_ends>(const Deviation&);
template bool fault_of_godot<FaultOfGodot::first_edge>(const Deviation&);
template bool fault_of_godot<FaultOfGodot::segment_length>(const Deviation&);
template bool fault_of_godot<FaultOfGodot::tested_axis>(const Deviation&);

}  // namespace manifuzz
