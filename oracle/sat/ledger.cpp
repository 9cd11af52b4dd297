#include <cmath>
#include <limits>
#include <vector>

#include "engines/engine.hpp"
#include "geometry/vector.hpp"
#include "judging/faults/replayed.hpp"
#include "judging/faults/rounded_sum.hpp"
#include "judging/faults/shared_faults.hpp"

// SAT.js: testPolygonPolygon and testCircleCircle are repeated, of vertices in the world, and give
// the answer; with the named fault mended they give a right one.

namespace manifuzz {
namespace {

std::vector<Vector2<double>> placed_for_sat(const Body& body) {
  const Vector2<double> turn = body.pose.rotation.cast<double>();
  const Vector2<double> at = body.pose.position.cast<double>();
  std::vector<Vector2<double>> placed;
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<double> v = body.polygon.vertices[i].cast<double>();
    placed.emplace_back(ledger_of::sum_rounded_once(turn.x() * v.x(), -turn.y() * v.y(), at.x()),
                        ledger_of::sum_rounded_once(turn.y() * v.x(), turn.x() * v.y(), at.y()));
  }
  return placed;
}

/// flattenPointsOn.
struct RangeOfSat {
  double least = std::numeric_limits<double>::max();
  double most = -std::numeric_limits<double>::max();

  RangeOfSat(const std::vector<Vector2<double>>& vertices, const Vector2<double>& axis) {
    for (const Vector2<double>& v : vertices) {
      least = std::min(least, v.dot(axis));
      most = std::max(most, v.dot(axis));
    }
  }
};

/// Its Response.
struct FoundBySat {
  bool touches = true;
  Vector2<double> normal{0, 0};  ///< from A to B, in the world
  double depth = std::numeric_limits<double>::max();
};

/// isSeparatingAxis, which does not turn the axis about where the overlap is 0; mended it does
/// where B's range is below A's.
void look_along(const std::vector<Vector2<double>>& a, const std::vector<Vector2<double>>& b,
                const Vector2<double>& axis, bool is_mended, FoundBySat& found) {
  const RangeOfSat of_a(a, axis);
  const RangeOfSat of_b(b, axis);
  if (of_a.least > of_b.most || of_b.least > of_a.most) {
    found.touches = false;
    return;
  }
  const double above = of_a.most - of_b.least;
  const double below = of_b.most - of_a.least;
  const bool is_first_below = of_a.least < of_b.least;
  const bool is_contained = is_first_below ? !(of_a.most < of_b.most) : !(of_a.most > of_b.most);
  double overlap = is_first_below ? above : -below;
  if (is_contained) overlap = above < below ? above : -below;
  if (!(std::abs(overlap) < found.depth)) return;
  found.depth = std::abs(overlap);
  const bool is_below = is_mended && overlap == 0 && below <= above;
  found.normal = overlap < 0 || is_below ? Vector2<double>(-axis) : axis;
}

FoundBySat polygons_by_sat(const PairCase& pair, bool is_mended) {
  const auto a = placed_for_sat(pair.a);
  const auto b = placed_for_sat(pair.b);
  FoundBySat found;
  for (const auto* const polygon : {&a, &b}) {
    for (std::size_t i = 0; i < polygon->size() && found.touches; ++i) {
      const Vector2<double> edge = (*polygon)[(i + 1) % polygon->size()] - (*polygon)[i];
      const double length = std::sqrt(edge.y() * edge.y() + edge.x() * edge.x());
      const Vector2<double> axis(edge.y() / length, -edge.x() / length);
      look_along(a, b, axis, is_mended, found);
    }
  }
  return found;
}

/// As sat.mjs declares it.
Declaration as_declared_by_sat() {
  return {.scalar = ScalarType::float64,
          .frame = RoundingFrame::world,
          .takes_radius = false,
          .min_vertices = 1,
          .claims = Claims::separation};
}

/// The overlap of polygons that just touch is 0, and the axis is not turned about.
bool axis_of_exact_touch_in_sat(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (pair.a.polygon.count < kMinVertices || pair.b.polygon.count < kMinVertices) return false;
  const FoundBySat found = polygons_by_sat(pair, false);
  const FoundBySat mended = polygons_by_sat(pair, true);
  return found.touches && found.depth == 0 &&
         replayed::is_same_separation(d, found.normal, found.depth) &&
         replayed::is_right_separation(d, as_declared_by_sat(), mended.normal, mended.depth);
}

/// The centres of two circles are at one place, and the normal has no length.
bool no_normal_of_one_centre_in_sat(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (pair.a.polygon.count != 1 || pair.b.polygon.count != 1) return false;
  // testCircleCircle: what is left of both centres, each rounded in the world.
  const Vector2<double> between = placed_for_sat(pair.b)[0] - placed_for_sat(pair.a)[0];
  return between.isZero(0) &&
         replayed::is_same_separation(d, Vector2<double>(0, 0), total_radius(pair));
}

constexpr LedgerRow kSatRows[] = {
    {"axis-of-exact-touch", axis_of_exact_touch_in_sat},
    {"one-centre", no_normal_of_one_centre_in_sat},
};

}  // namespace

Engine engine_sat() {
  return {.name = "sat", .ledger = {{"sat", kSatRows}}};
}

}  // namespace manifuzz
