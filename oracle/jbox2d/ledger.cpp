#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engines/engine.hpp"
#include "judging/faults/replayed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"
#include "oracle/jbox2d/edges.hpp"
#include "oracle/jbox2d/shapes.hpp"

// jbox2d, Box2D 2.2 in Java: Collision.collidePolygons is repeated in float, and again without its
// climbing. Other faults are Box2D's own.

namespace manifuzz {
namespace {

using jbox2d::clip_to_line;
using jbox2d::Ends;
using PolygonOfJbox2d = jbox2d::Polygon;

/// EdgeResults.
struct EdgeOfJbox2d {
  int index = 0;
  float separation = -std::numeric_limits<float>::max();
};

/// edgeSeparation.
EdgeOfJbox2d edge_separation(const PolygonOfJbox2d& of, int edge, const PolygonOfJbox2d& opposing) {
  const Vector2<float> normal = of.turned(of.normal(edge));
  const Vector2<float> local = opposing.turned_back(normal);
  int deepest = 0;
  for (int i = 1; i < opposing.count(); ++i) {
    if (opposing.vertex(i).dot(local) < opposing.vertex(deepest).dot(local)) deepest = i;
  }
  const Vector2<float> between =
      opposing.placed(opposing.vertex(deepest)) - of.placed(of.vertex(edge));
  return {edge, between.dot(normal)};
}

/// findMaxSeparation; mended it looks at all edges.
EdgeOfJbox2d max_separation(const PolygonOfJbox2d& of, const PolygonOfJbox2d& opposing,
                            bool is_mended) {
  const auto at = [&](int edge) { return edge_separation(of, edge, opposing); };
  EdgeOfJbox2d best;
  if (is_mended) {
    for (int i = 0; i < of.count(); ++i) {
      if (at(i).separation > best.separation) best = at(i);
    }
    return best;
  }
  const Vector2<float> local = of.turned_back(
      Vector2<float>(opposing.placed(opposing.centroid()) - of.placed(of.centroid())));
  int start = 0;
  for (int i = 1; i < of.count(); ++i) {
    if (of.normal(i).dot(local) > of.normal(start).dot(local)) start = i;
  }
  best = at(start);
  const EdgeOfJbox2d before = at(of.previous(start));
  const EdgeOfJbox2d after = at(of.next(start));
  const bool is_back = before.separation > best.separation && before.separation > after.separation;
  if (!is_back && !(after.separation > best.separation)) return best;
  best = is_back ? before : after;
  for (;;) {
    const EdgeOfJbox2d further = at(is_back ? of.previous(best.index) : of.next(best.index));
    if (!(further.separation > best.separation)) return best;
    best = further;
  }
}

/// findIncidentEdge.
Ends incident_of_jbox2d(const PolygonOfJbox2d& of, const Vector2<float>& normal) {
  const Vector2<float> local = of.turned_back(normal);
  int most_against = 0;
  for (int i = 1; i < of.count(); ++i) {
    if (local.dot(of.normal(i)) < local.dot(of.normal(most_against))) most_against = i;
  }
  return {of.placed(of.vertex(most_against)), of.placed(of.vertex(of.next(most_against)))};
}

/// collidePolygons, of polygons without radii or with mitred ones.
replayed::Contact by_jbox2d(const PairCase& pair, bool is_mended) {
  const PolygonOfJbox2d a{pair.a};
  const PolygonOfJbox2d b{pair.b};
  const float radius = pair.a.polygon.radius + pair.b.polygon.radius;
  const EdgeOfJbox2d of_a = max_separation(a, b, is_mended);
  const EdgeOfJbox2d of_b = max_separation(b, a, is_mended);
  if (of_a.separation > radius || of_b.separation > radius) return {};
  const bool is_b = of_b.separation > 0.98F * of_a.separation + 0.001F;
  const PolygonOfJbox2d& reference = is_b ? b : a;
  const int edge = is_b ? of_b.index : of_a.index;
  Ends ends = incident_of_jbox2d(is_b ? a : b, reference.turned(reference.normal(edge)));
  const Vector2<float> from = reference.vertex(edge);
  const Vector2<float> to = reference.vertex(reference.next(edge));
  const Vector2<float> along = to - from;
  // Vec2.normalize leaves what is shorter than Settings.EPSILON as it is.
  const float length = std::sqrt(along.x() * along.x() + along.y() * along.y());
  const bool is_short = length < std::numeric_limits<float>::epsilon();
  const Vector2<float> tangent = reference.turned(along * (is_short ? 1.0F : 1.0F / length));
  const Vector2<float> normal(tangent.y(), -tangent.x());
  const Vector2<float> first = reference.placed(from);
  const Vector2<float> last = reference.placed(to);
  if (!clip_to_line(ends, -tangent, -tangent.dot(first) + radius) ||
      !clip_to_line(ends, tangent, tangent.dot(last) + radius)) {
    return {};
  }
  replayed::Contact contact{(is_b ? -normal : normal).cast<double>(), {}};
  for (const Vector2<float>& end : ends) {
    const float separation = normal.dot(end) - normal.dot(first);
    if (separation > radius) continue;
    const auto depth = static_cast<double>(std::max(radius - separation, 0.0F));
    contact.points.push_back({end.cast<double>(), depth});
  }
  return contact;
}

/// A local maximum of the separation is kept, to which the direction between the centroids has led.
bool local_maximum_in_jbox2d(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (std::min(pair.a.polygon.count, pair.b.polygon.count) < kMinVertices || is_round(pair)) {
    return false;
  }
  const Declaration declaration{.frame = RoundingFrame::world};
  return replayed::is_same_answer(d, by_jbox2d(pair, false)) &&
         replayed::is_right_answer(d, declaration, by_jbox2d(pair, true));
}

/// No contact of an edge and a polygon that are farther apart than 0.02, the radii that it takes
/// for theirs.
bool edge_radius_of_settings(const Deviation& d) {
  constexpr double kRadius = 2 * 0.01F;  // 2.0f * Settings.polygonRadius
  const PairCase& pair = d.right.pair();
  const bool has_edge = std::min(pair.a.polygon.count, pair.b.polygon.count) == 2;
  const bool has_polygon = std::max(pair.a.polygon.count, pair.b.polygon.count) >= kMinVertices;
  if (!has_edge || !has_polygon || d.got.count > 0 || total_radius(pair) <= kRadius) return false;
  const exact::Truth& truth = *d.right.truth;
  return std::max(truth.separation(Side::a), truth.separation(Side::b)) >
         kRadius - 2 * d.right.bounds.separation;
}

template <FaultOfJbox2dEdge kFault>
bool edge_at_fault(const Deviation& d) {
  return is_edge_at_fault(d, kFault);
}

constexpr LedgerRow kJbox2dRows[] = {
    {"tiny-reference-face", tiny_reference_face},
    {"no-contact-under-bias", no_contact_under_bias},
    {"no-contact-on-tied-features", no_contact_on_tied_features},
    {"edge-slab-not-widened", edge_slab_not_widened},
    {"edge-tied-incident", edge_clips_tied_incident},
    {"coincident-points", axis_for_coincident_points},
    {"direction-of-roundings", direction_of_roundings},
    {"edge-radius", edge_radius_of_settings},
    {"local-maximum", local_maximum_in_jbox2d},
    {"second-point-within-radius", edge_at_fault<FaultOfJbox2dEdge::radius>},
    {"edge-hysteresis", edge_at_fault<FaultOfJbox2dEdge::hysteresis>},
    {"huge-reference-face", huge_reference_face},
    {"crossing-underflows", crossing_underflows},
    {"corner-direction-not-normalised", corner_direction_not_normalised},
    {"edge-front", edge_at_fault<FaultOfJbox2dEdge::front>},
    {"edge-corners", edge_at_fault<FaultOfJbox2dEdge::corners>},
    {"circle-tied-faces", tied_face_of_box2d_circle},
    {"face-within-epsilon", face_within_box2d_epsilon},
};

}  // namespace

Engine engine_jbox2d() {
  return {.name = "jbox2d", .ledger = {{"jbox2d", kJbox2dRows}}};
}

}  // namespace manifuzz
