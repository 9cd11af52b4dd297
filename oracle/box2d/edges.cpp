#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "oracle/box2d/deviations.hpp"
#include "oracle/box2d/edge_clips.hpp"

// Box2D 2.4 on circles and edges, in world directions seen from A's position.

namespace manifuzz {

using namespace ledger_of;

namespace {

using exact::RoughPair;

constexpr float kEpsilonOfBox2d = std::numeric_limits<float>::epsilon();  // b2_epsilon

/// How much farther the polygon's best face is than b2CollideEdgeAndPolygon asks of it to be taken.
double lead_over_hysteresis(const exact::Truth& truth, const EdgeAndPolygon& sides) {
  const double radius = total_radius(truth.pair());
  return truth.separation(sides.polygon) - radius -
         (0.98 * (truth.separation(sides.edge) - radius) + 0.001);
}

/// A circle whose centre lies on a corner of the other core, as Box2D's floats have it.
struct CentreOnCorner {
  Side circle = Side::a;
  Vector2<float> from_corner;  ///< to the centre: in the world of an edge's end, of a polygon's
                               ///< corner in the polygon's frame
};

/// The corners within `bound`, a world length, of a circle's centre.
std::vector<CentreOnCorner> centres_on_corners(const PairCase& pair, double bound) {
  std::vector<CentreOnCorner> found;
  const RoughPair placed = exact::place_roughly(pair);
  for (const Side side : {Side::a, Side::b}) {
    const Body& other_body = pair[other(side)];
    if (pair[side].polygon.count != 1) continue;
    const Vector2<float> centre = transform(pair[side].pose, pair[side].polygon.vertices[0]);
    for (int i = 0; i < other_body.polygon.count; ++i) {
      const Vector2<double> apart = placed[side].vertices[0] - placed[other(side)].vertices[i];
      if (apart.norm() > bound) continue;
      const Vector2<float>& corner = other_body.polygon.vertices[i];
      if (other_body.polygon.count < kMinVertices) {
        found.push_back({side, centre - transform(other_body.pose, corner)});
      } else {
        const Vector2<float> local =
            rotate_back<float>(other_body.pose.rotation, centre - other_body.pose.position);
        found.push_back({side, local - corner});
      }
    }
  }
  return found;
}

/// The answer's normal in the world, unit, from the other shape to the circle.
Vector2<double> towards_circle(const Deviation& d, Side circle) {
  const Vector2<double> normal =
      rotate<double>(d.right.pair().a.pose.rotation.cast<double>(), d.got.normal).normalized();
  return circle == Side::b ? normal : Vector2<double>(-normal);
}

/// Whether the depth is that of two points so far apart along the normal: both radii, less that.
bool is_as_deep_as_radii(const Deviation& d, double apart = 0) {
  return std::abs(d.got.points[0].depth - (total_radius(d.right.pair()) - apart)) <=
         4 * d.right.bounds.separation;
}

/// Whether it is no polygon's corner: an edge's end, or the other circle's centre.
bool is_no_polygons_corner(const PairCase& pair, const CentreOnCorner& found) {
  return pair[other(found.circle)].polygon.count < kMinVertices;
}

/// Whether Box2D leaves the direction between both points as short as it is, or sets an axis
/// instead: b2Vec2::Normalize below epsilon, b2WorldManifold up to it.
bool is_too_short(const PairCase& pair, const CentreOnCorner& found) {
  const Vector2<float>& apart = found.from_corner;
  return is_no_polygons_corner(pair, found) ? apart.dot(apart) <= kEpsilonOfBox2d * kEpsilonOfBox2d
                                            : apart.norm() < kEpsilonOfBox2d;
}

/// Whether the normal is the direction between both points, in floats.
bool is_along_roundings(const Deviation& d, const CentreOnCorner& found) {
  const PairCase& pair = d.right.pair();
  Vector2<double> direction = found.from_corner.cast<double>();
  if (is_too_short(pair, found)) return false;
  if (!is_no_polygons_corner(pair, found)) {
    direction = rotate<double>(pair[other(found.circle)].pose.rotation.cast<double>(), direction);
  }
  return (towards_circle(d, found.circle) - direction.normalized()).norm() <=
         2 * d.right.bounds.normal;
}

}  // namespace

bool edge_slab_not_widened(const Deviation& d) {
  const auto sides = edge_and_polygon(d.right.pair());
  if (!sides) return false;
  const exact::Truth& truth = *d.right.truth;
  const double bound = d.right.bounds.separation;
  const double lead = lead_over_hysteresis(truth, *sides);
  const auto is_cut = [](const BetweenEnds& clip) { return clip.is_cut; };
  return (lead <= 2 * bound && any_clip_from(d, sides->edge, is_cut)) ||
         (lead >= -2 * bound && any_clip_from(d, sides->polygon, is_cut));
}

bool edge_face_kept_by_hysteresis(const Deviation& d) {
  const auto sides = edge_and_polygon(d.right.pair());
  if (!sides) return false;
  const exact::Truth& truth = *d.right.truth;
  const double bound = d.right.bounds.separation;
  if (truth.separation(sides->polygon) <= truth.separation(sides->edge) + bound) return false;
  return lead_over_hysteresis(truth, *sides) <= 2 * bound &&
         any_clip_from(d, sides->edge, [](const BetweenEnds&) { return true; });
}

bool edge_clips_tied_incident(const Deviation& d) {
  const auto sides = edge_and_polygon(d.right.pair());
  if (!sides) return false;
  const double bound = d.right.bounds.separation;
  const double deepest = d.right.truth->separation(sides->edge);
  // What the clip lacks of the depth is wrong from the bound of one separation on.
  return lead_over_hysteresis(*d.right.truth, *sides) <= 2 * bound &&
         any_clip_from(d, sides->edge,
                       [&](const BetweenEnds& clip) { return clip.nearest > deepest + bound; });
}

bool axis_for_coincident_points(const Deviation& d) {
  const auto is_axis = [&](const CentreOnCorner& found) {
    const auto along = static_cast<double>(found.from_corner.x());
    const Vector2<double> off = towards_circle(d, found.circle) - Vector2<double>(1, 0);
    return is_no_polygons_corner(d.right.pair(), found) && is_too_short(d.right.pair(), found) &&
           is_as_deep_as_radii(d, along) && off.norm() <= 2 * d.right.bounds.normal;
  };
  const double bound = d.right.bounds.separation + kEpsilonOfBox2d;
  return d.got.count == 1 &&
         std::ranges::any_of(centres_on_corners(d.right.pair(), bound), is_axis);
}

bool direction_of_roundings(const Deviation& d) {
  return d.got.count == 1 && is_as_deep_as_radii(d) &&
         std::ranges::any_of(
             centres_on_corners(d.right.pair(), d.right.bounds.separation),
             [&](const CentreOnCorner& found) { return is_along_roundings(d, found); });
}

bool corner_direction_not_normalised(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  return d.got.count == 1 && d.got.normal.norm() <= 2.0 * kEpsilonOfBox2d &&
         (d.got.points[0].depth <= d.right.bounds.separation || is_as_deep_as_radii(d)) &&
         std::ranges::any_of(
             centres_on_corners(pair, d.right.bounds.separation), [&](const CentreOnCorner& found) {
               return !is_no_polygons_corner(pair, found) && is_too_short(pair, found);
             });
}

}  // namespace manifuzz
