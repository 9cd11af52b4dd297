#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "engines/engine.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/godot3/solver.hpp"

// Godot 3: its operations are repeated in its own scalar and order, and give the answer; with the
// named fault mended they give a right one.

namespace manifuzz {
namespace {

using as_godot::FaultOfGodot;
using replayed::has;

constexpr unsigned kFaultsOfGodot = 2047;

/// As relay.py declares it.
Declaration as_declared_by_godot() {
  return {.frame = RoundingFrame::world,
          .takes_radius = false,
          .min_vertices = 1,
          .second_point = {0.99998},  // _SEGMENT_IS_VALID_SUPPORT_THRESHOLD
          .clips = false,
          .points = PointsAt::surface_a,
          .shares_depth = true,
          .one_point_enough = true,
          .least_depth = as_godot::kCmpEpsilon};
}

/// The square of a vector's length is beyond float's normal numbers.
bool is_square_out_of_range(const Vector2<double>& v) {
  return !v.isZero(0) && !std::isnormal(static_cast<float>(v.dot(v)));
}

/// The faults that a case has room for.
unsigned faults_in(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  unsigned faults = kFaultsOfGodot;
  const auto leave_out = [&](FaultOfGodot fault) { faults &= ~static_cast<unsigned>(fault); };
  bool is_any_segment = false, is_any_capsule = false, is_any_polygon = false;
  bool is_any_short = false, is_any_square = false;
  for (const Body* const body : {&pair.a, &pair.b}) {
    const ConvexPolygon<float>& polygon = body->polygon;
    is_any_segment = is_any_segment || (polygon.count == 2 && polygon.radius == 0);
    is_any_capsule = is_any_capsule || (polygon.count == 2 && polygon.radius > 0);
    is_any_polygon = is_any_polygon || polygon.count > 2;
    for (int i = 0; i < polygon.count; ++i) {
      const Vector2<double> edge = polygon.vertices[(i + 1) % polygon.count].cast<double>() -
                                   polygon.vertices[i].cast<double>();
      is_any_short = is_any_short || (!edge.isZero(0) && edge.dot(edge) < 1e-20);
      is_any_square = is_any_square || is_square_out_of_range(edge);
    }
  }
  if (!is_any_segment) leave_out(FaultOfGodot::segment_length);
  if (!is_any_capsule) leave_out(FaultOfGodot::flat_capsule);
  if (!is_any_polygon) leave_out(FaultOfGodot::first_edge);
  if (!is_any_square) leave_out(FaultOfGodot::squared_length);
  if (!is_any_short) leave_out(FaultOfGodot::short_edge);
  if (d.right.truth->extent() < 1e10) leave_out(FaultOfGodot::start_values);
  return faults;
}

replayed::Contact contact_of(const as_godot::GodotAnswer& answer, unsigned mended) {
  replayed::Contact contact = answer.contact;
  if (!has(mended, FaultOfGodot::short_difference)) return contact;
  contact.normal = answer.axis;
  for (replayed::Contact::Point& point : contact.points) point.depth = answer.depth;
  return contact;
}

/// With these faults mended, and along this axis where one is given: whether the edge that Godot
/// meets gives a right answer, or, where that is mended, another one within the angle or none.
bool is_right_along(const Deviation& d, unsigned mended,
                    const std::optional<Vector2<double>>& axis) {
  as_godot::Mends mends{mended};
  const auto is_right = [&](const as_godot::Mends& with) {
    as_godot::GodotAnswer answer = as_godot::by_godot(d.right.pair(), with, axis);
    if (axis) {
      answer.axis = *axis;
      answer.depth = ledger_of::least_depth(d);
    }
    return replayed::is_right_answer(d, as_declared_by_godot(), contact_of(answer, mended));
  };
  if (!has(mended, FaultOfGodot::first_edge)) return is_right(mends);
  const auto edges = as_godot::by_godot(d.right.pair(), mends, axis).edges;
  return std::ranges::any_of(edges[0], [&](int of_a) {
    return std::ranges::any_of(edges[1], [&](int of_b) {
      mends.edges = {of_a, of_b};
      return is_right(mends);
    });
  });
}

bool is_right_with(const Deviation& d, unsigned mended) {
  if (!has(mended, FaultOfGodot::tested_axis)) return is_right_along(d, mended, std::nullopt);
  if (as_godot::by_godot(d.right.pair(), {mended}).axis.isZero(0)) return false;
  const auto axes = replayed::least_normals(d);
  return std::ranges::any_of(
      axes, [&](const Vector2<double>& axis) { return is_right_along(d, mended, axis); });
}

/// Whether no axis has less overlap than the one that was kept, but for rounding.
bool is_axis_of_least_overlap(const Deviation& d) {
  return as_godot::by_godot(d.right.pair(), {}).depth - ledger_of::least_depth(d) <=
         4 * d.right.bounds.separation;
}

/// One of these.
template <FaultOfGodot kFault>
bool fault_of_godot(const Deviation& d) {
  const unsigned possible = faults_in(d);
  if (!has(possible, kFault)) return false;
  if (kFault == FaultOfGodot::tested_axis && !is_axis_of_least_overlap(d)) return false;
  if (!replayed::is_same_answer(d, as_godot::by_godot(d.right.pair(), {}).contact)) return false;
  return replayed::is_needed(static_cast<unsigned>(kFault), possible,
                             [&](unsigned mended) { return is_right_with(d, mended); });
}

/// A crash: no vertex of a polygon is farther than where the search for the farthest begins, so
/// that the count of supports is what the stack held.
bool no_support_found_by_godot(const LostAnswer& lost) {
  return lost.how == Lost::How::crashed && as_godot::by_godot(lost.pair, {}).is_without_support;
}

constexpr LedgerRow kGodot3Rows[] = {
    {"start-values", fault_of_godot<FaultOfGodot::start_values>, no_support_found_by_godot},
    {"squared-length", fault_of_godot<FaultOfGodot::squared_length>},
    {"short-edge", fault_of_godot<FaultOfGodot::short_edge>},
    {"short-difference", fault_of_godot<FaultOfGodot::short_difference>},
    {"segment-length", fault_of_godot<FaultOfGodot::segment_length>},
    {"first-edge", fault_of_godot<FaultOfGodot::first_edge>},
    {"first-ends", fault_of_godot<FaultOfGodot::first_ends>},
    {"tested-axis", fault_of_godot<FaultOfGodot::tested_axis>},
    {"rounded-ends", fault_of_godot<FaultOfGodot::rounded_ends>},
    {"uncapped-foot", fault_of_godot<FaultOfGodot::uncapped_foot>},
    {"flat-capsule", fault_of_godot<FaultOfGodot::flat_capsule>},
};

}  // namespace

Engine engine_godot3() {
  return {.name = "godot3", .ledger = {{"godot3", kGodot3Rows}}};
}

}  // namespace manifuzz
