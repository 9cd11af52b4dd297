#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/box2d/edge_clips.hpp"
#include "oracle/planck/deviations.hpp"

// planck on an edge and a polygon.

namespace manifuzz {

using namespace ledger_of;

namespace {

using exact::FaceOf;
using exact::RoughPair;
using exact::RoughPolygon;

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

}  // namespace

bool planck_edge_slab_not_widened(const Deviation& d) {
  return is_edge_clip_of_planck(d, [](const BetweenEnds& clip) { return clip.is_cut; });
}

bool planck_edge_hysteresis(const Deviation& d) {
  return is_edge_clip_of_planck(d, [](const BetweenEnds&) { return true; });
}

}  // namespace manifuzz
