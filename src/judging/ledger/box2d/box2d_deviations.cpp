#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "judging/ledger/round_deviations.hpp"

// Box2D 2.4 on circles and edges, in world directions seen from A's position.

namespace manifuzz {
namespace {

using exact::FaceOf;
using exact::RoughPair;
using exact::RoughPolygon;

constexpr float kEpsilonOfBox2d = std::numeric_limits<float>::epsilon();  // b2_epsilon

/// The sides of an edge against a polygon, which are A's and B's or B's and A's.
struct EdgeAndPolygon {
  Side edge = Side::a;
  Side polygon = Side::b;
};

std::optional<EdgeAndPolygon> edge_and_polygon(const PairCase& pair) {
  for (const Side side : {Side::a, Side::b}) {
    if (pair[side].polygon.count == 2 && pair[other(side)].polygon.count >= kMinVertices) {
      return EdgeAndPolygon{side, other(side)};
    }
  }
  return std::nullopt;
}

/// How much farther the polygon's best face is than b2CollideEdgeAndPolygon asks of it to be taken.
double lead_over_hysteresis(const exact::Truth& truth, const EdgeAndPolygon& sides) {
  const double radius = total_radius(truth.pair());
  return truth.separation(sides.polygon) - radius -
         (0.98 * (truth.separation(sides.edge) - radius) + 0.001);
}

/// What is left of an incident edge between the ends of a reference face.
struct BetweenEnds {
  Vector2<double> normal;  ///< from A to B, in the world
  double run = 0;          ///< along the face; negative where it misses
  double nearest = 0;      ///< to the face, of what is left
  double slack = 0;        ///< of `nearest`: an end that is cut moves along a slope
  bool is_cut = false;     ///< the end nearest to the face is beyond the face's ends, or nearly
};

BetweenEnds between_ends(const RoughPair& placed, FaceOf reference, int incident, double bound) {
  const RoughPolygon& on = placed[reference.side];
  const RoughPolygon& of = placed[other(reference.side)];
  const Vector2<double>& out = on.normals[reference.index];
  const Vector2<double> along(-out.y(), out.x());
  const Vector2<double>& corner = on.vertices[reference.index];
  const Vector2<double> face = on.vertices[on.next(reference.index)] - corner;
  Vector2<double> first = of.vertices[incident] - corner;
  Vector2<double> last = of.vertices[of.next(incident)] - corner;
  if (first.dot(along) > last.dot(along)) std::swap(first, last);
  const double low = std::max(first.dot(along), 0.0);
  const double high = std::min(last.dot(along), face.dot(along));
  const double rise = std::abs((last - first).dot(out));
  const double run = (last - first).dot(along);
  const auto height_at = [&](double place) {
    if (!(run > 0)) return std::min(first.dot(out), last.dot(out));
    const double share = std::clamp((place - first.dot(along)) / run, 0.0, 1.0);
    return first.dot(out) + share * (last - first).dot(out);
  };
  const double deepest = (first.dot(out) < last.dot(out) ? first : last).dot(along);
  return {.normal = reference.side == Side::a ? out : Vector2<double>(-out),
          .run = high - low,
          .nearest = std::min(height_at(low), height_at(high)),
          .slack = bound + (run > 0 ? std::min(bound * rise / run, rise) : rise),
          .is_cut = deepest <= 2 * bound || deepest >= face.dot(along) - 2 * bound};
}

/// Whether the answer is what that clip gives: no contact where nothing is left, or the face's
/// normal with the depth of what is.
bool is_given_by(const Deviation& d, const BetweenEnds& clip) {
  const Bounds& bounds = d.right.bounds;
  const PairCase& pair = d.right.pair();
  const double radius = total_radius(pair);
  if (d.got.count == 0) {
    return clip.run <= 2 * bounds.separation || clip.nearest >= radius - clip.slack;
  }
  const Vector2<double> normal =
      rotate<double>(pair.a.pose.rotation.cast<double>(), d.got.normal).normalized();
  if ((normal - clip.normal).norm() > 2 * bounds.normal) return false;
  double deepest = 0;
  for (int i = 0; i < d.got.count; ++i) deepest = std::max(deepest, d.got.points[i].depth);
  const double turned = bounds.normal * (d.right.truth->extent() + radius);
  return std::abs(deepest - (radius - clip.nearest)) <= clip.slack + turned;
}

/// Whether the answer is what a face makes it, of which `is_at_fault` tells.
template <class Fault>
bool is_clip_from(const Deviation& d, FaceOf face, const Fault& is_at_fault) {
  const exact::Truth& truth = *d.right.truth;
  const Bounds& bounds = d.right.bounds;
  const RoughPair placed = exact::place_roughly(truth.stored());
  return std::ranges::any_of(truth.incident_edges(face, bounds.incident_dot), [&](int incident) {
    const BetweenEnds clip = between_ends(placed, face, incident, bounds.separation);
    return is_at_fault(clip) && is_given_by(d, clip);
  });
}

/// The same of the best faces of that side.
template <class Fault>
bool any_clip_from(const Deviation& d, Side side, const Fault& is_at_fault) {
  const exact::Truth& truth = *d.right.truth;
  for (int i = 0; i < d.right.pair()[side].polygon.face_count(); ++i) {
    const FaceOf face{side, i};
    if (truth.separation(face) < truth.separation(side) - 2 * d.right.bounds.separation) continue;
    if (is_clip_from(d, face, is_at_fault)) return true;
  }
  return false;
}

/// The faces of an edge that planck may take for its front, towards the polygon's centroid, and how
/// much farther the polygon's best face is than planck asks of it to be taken instead.
struct FrontOfPlanck {
  std::vector<FaceOf> faces;
  double lead = 0;
};

FrontOfPlanck front_of_planck(const Deviation& d, const EdgeAndPolygon& sides) {
  const exact::Truth& truth = *d.right.truth;
  const RoughPair placed = exact::place_roughly(truth.stored());
  const RoughPolygon& polygon = placed[sides.polygon];
  const RoughPolygon& edge = placed[sides.edge];
  const Vector2<double> corner = polygon.vertices[0];
  Vector2<double> moment(0, 0);
  double area = 0;
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const Vector2<double> p = polygon.vertices[i] - corner;
    const Vector2<double> q = polygon.vertices[i + 1] - corner;
    const double part = p.x() * q.y() - p.y() * q.x();
    moment += part / 3 * (p + q);
    area += part;
  }
  const Vector2<double> centroid = corner + moment / area;
  FrontOfPlanck front{.faces = {}, .lead = -INFINITY};
  for (int i = 0; i < 2; ++i) {
    const double off = edge.normals[i].dot(centroid - edge.vertices[0]);
    if (off < -4 * d.right.bounds.separation) continue;
    const FaceOf face{sides.edge, i};
    front.faces.push_back(face);
    front.lead = std::max(
        front.lead, truth.separation(sides.polygon) - (0.98 * truth.separation(face) + 0.001));
  }
  return front;
}

/// Whether the answer is planck's of an edge and a polygon, of which `is_at_fault` tells.
template <class Fault>
bool is_edge_clip_of_planck(const Deviation& d, const Fault& is_at_fault) {
  const auto sides = edge_and_polygon(d.right.pair());
  if (!sides) return false;
  const double bound = 2 * d.right.bounds.separation;
  const FrontOfPlanck front = front_of_planck(d, *sides);
  const auto is_from = [&](FaceOf face) { return is_clip_from(d, face, is_at_fault); };
  return (front.lead <= bound && std::ranges::any_of(front.faces, is_from)) ||
         (front.lead >= -bound && any_clip_from(d, sides->polygon, is_at_fault));
}

/// b2Mul of a transform and a vector.
Vector2<float> placed_by_box2d(const Pose<float>& pose, const Vector2<float>& v) {
  return rotate(pose.rotation, v) + pose.position;
}

/// A circle whose centre lies on a corner of the other core, as Box2D's floats have it.
struct CentreOnCorner {
  Side circle = Side::a;
  Vector2<float> from_corner;  ///< to the centre: in the world of an edge's end, of a polygon's
                               ///< corner in the polygon's frame
};

/// Those within `bound`, a world length.
std::vector<CentreOnCorner> centres_on_corners(const PairCase& pair, double bound) {
  std::vector<CentreOnCorner> found;
  const RoughPair placed = exact::place_roughly(pair);
  for (const Side side : {Side::a, Side::b}) {
    const Body& other_body = pair[other(side)];
    if (pair[side].polygon.count != 1) continue;
    const Vector2<float> centre = placed_by_box2d(pair[side].pose, pair[side].polygon.vertices[0]);
    for (int i = 0; i < other_body.polygon.count; ++i) {
      const Vector2<double> apart = placed[side].vertices[0] - placed[other(side)].vertices[i];
      if (apart.norm() > bound) continue;
      const Vector2<float>& corner = other_body.polygon.vertices[i];
      if (other_body.polygon.count < kMinVertices) {
        found.push_back({side, centre - placed_by_box2d(other_body.pose, corner)});
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

bool planck_edge_slab_not_widened(const Deviation& d) {
  return is_edge_clip_of_planck(d, [](const BetweenEnds& clip) { return clip.is_cut; });
}

bool planck_edge_hysteresis(const Deviation& d) {
  return is_edge_clip_of_planck(d, [](const BetweenEnds&) { return true; });
}

}  // namespace manifuzz
