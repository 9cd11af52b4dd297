#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engines/engine.hpp"
#include "exact/curve.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/replayed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/p2-es/replay.hpp"

// p2 on circles: its operations are repeated, and have to give the answer.

namespace manifuzz {
namespace {

using ledger_of::ContactOfP2;
using Branch = ContactOfP2::Branch;

/// Whether the answer has this normal, of a length that is the same in both frames.
bool has_normal(const Deviation& d, const Vector2<double>& normal) {
  const Vector2<double> turn = d.right.pair().a.pose.rotation.cast<double>().normalized();
  return (rotate<double>(turn, d.got.normal) - normal).norm() <= d.right.bounds.normal;
}

bool has_depth(const Deviation& d, double depth) {
  return std::abs(d.got.points[0].depth - depth) <= d.right.bounds.separation;
}

bool has_place(const Deviation& d, const Vector2<double>& place) {
  return (to_world(d.right.pair(), d.got.points[0].position) - place).norm() <=
         d.right.bounds.position;
}

/// What it finds, if that is the answer.
std::optional<ContactOfP2> found_by_p2(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (d.got.count != 1 || !is_round(pair)) return std::nullopt;
  const auto found = ledger_of::circle_contact_of_p2(pair);
  if (!found || !has_normal(d, found->normal) || !has_depth(d, found->depth) ||
      !has_place(d, found->at)) {
    return std::nullopt;
  }
  return found;
}

/// How far the cores are apart; below 0 where they overlap.
double distance_of_cores(const Deviation& d) {
  return total_radius(d.right.pair()) - ledger_of::least_depth(d);
}

/// Whether the cores are nearest at a vertex of each, of another place than a circle's.
std::optional<int> nearest_vertex_of_other(const Deviation& d) {
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  const auto vertices = curve.nearest_vertices();
  if (!vertices) return std::nullopt;
  return d.right.pair().a.polygon.count == 1 ? (*vertices)[1] : (*vertices)[0];
}

/// As p2-es.mjs declares it.
Declaration as_declared_by_p2() {
  return {.frame = RoundingFrame::world, .takes_angles = true, .min_vertices = 1};
}

/// A normal without length, and no depth: what it is made of is (0, 0).
bool zero_normal_of_p2(const Deviation& d) {
  const auto found = found_by_p2(d);
  return found && found->normal.isZero(0);
}

/// A centre on a capsule's core, but for roundings: the sign of the normal is theirs, and the sign
/// with which the capsule's radius counts; at an end, the direction.
bool direction_of_roundings_of_p2(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (d.got.count != 1 || pair.a.polygon.count + pair.b.polygon.count != 3 ||
      std::abs(distance_of_cores(d)) > 4 * d.right.bounds.separation) {
    return false;
  }
  // At an end it is the direction of their roundings.
  const auto found = ledger_of::circle_contact_of_p2(pair);
  if (!found || found->normal.isZero(0)) return false;
  if (found->branch != Branch::beside_line) return found_by_p2(d).has_value();
  // Beside it both signs are of roundings, V8's cosine's too: the normal's, and that of the side on
  // which the capsule's radius is added, or on neither: the vector from the middle has no length.
  const Side circle = pair.a.polygon.count == 1 ? Side::a : Side::b;
  const auto of_capsule = static_cast<double>(pair[other(circle)].polygon.radius);
  const auto of_circle = static_cast<double>(pair[circle].polygon.radius);
  const Vector2<double> centre = transform<double>(
      {pair[circle].pose.position.cast<double>(), pair[circle].pose.rotation.cast<double>()},
      pair[circle].polygon.vertices[0].cast<double>());
  for (const double sign : {-1.0, 1.0}) {
    const Vector2<double> normal = sign * found->normal;
    const Vector2<double> out = circle == Side::a ? normal : Vector2<double>(-normal);
    if (!has_normal(d, normal)) continue;
    for (const double side : {-1.0, 0.0, 1.0}) {
      const double depth = std::max(of_circle - side * of_capsule, 0.0);
      if (has_depth(d, depth) && has_place(d, centre + side * of_capsule * out)) return true;
    }
  }
  return false;
}

/// A capsule's first end, where another place of its core is nearer.
bool first_end_of_p2(const Deviation& d) {
  const auto found = found_by_p2(d);
  return found && found->branch == Branch::first_end && nearest_vertex_of_other(d) != 0;
}

/// A capsule's normal is that of its ends as floats have them in the world: off by their roundings
/// over its length.
bool edge_of_rounded_ends_in_p2(const Deviation& d) {
  const auto found = found_by_p2(d);
  if (!found || found->branch != Branch::beside_line) return false;
  const auto mended =
      ledger_of::circle_contact_of_p2(d.right.pair(), ledger_of::EdgeOfP2::of_angle);
  return mended && replayed::is_right_answer(d, as_declared_by_p2(),
                                             {mended->normal, {{mended->at, mended->depth}}});
}

/// A face's contact where a vertex is the nearest, or another face.
bool face_before_vertex_of_p2(const Deviation& d) {
  const auto found = found_by_p2(d);
  return found && found->branch == Branch::face &&
         (nearest_vertex_of_other(d).has_value() ||
          std::abs(found->depth - ledger_of::least_depth(d)) > 4 * d.right.bounds.separation);
}

/// A vertex' contact, or none, where a face is the nearest: the circle's own point behind that face
/// is outside of the polygon.
bool vertex_before_face_of_p2(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const bool is_of_polygon = std::min(pair.a.polygon.count, pair.b.polygon.count) == 1 &&
                             std::max(pair.a.polygon.count, pair.b.polygon.count) >= kMinVertices;
  if (d.kind == Kind::missed_contact && is_of_polygon) {
    return !ledger_of::circle_contact_of_p2(pair) && !nearest_vertex_of_other(d);
  }
  const auto found = found_by_p2(d);
  return found && found->branch == Branch::vertex;
}

constexpr LedgerRow kP2EsRows[] = {
    {"no-contact-on-tied-features", no_contact_on_tied_features},
    {"zero-normal", zero_normal_of_p2},
    {"direction-of-roundings", direction_of_roundings_of_p2},
    {"first-end", first_end_of_p2},
    {"edge-of-rounded-ends", edge_of_rounded_ends_in_p2},
    {"face-before-vertex", face_before_vertex_of_p2},
    {"vertex-before-face", vertex_before_face_of_p2},
};

}  // namespace

Engine engine_p2_es() {
  return {.name = "p2-es", .ledger = {{"p2-es", kP2EsRows}}};
}

}  // namespace manifuzz
