#include <algorithm>
#include <cmath>
#include <vector>

#include "engines/engine.hpp"
#include "judging/faults/circle_faults.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"
#include "oracle/box2d/edge_clips.hpp"
#include "sequence/kept_faults.hpp"

// planck on an edge and a polygon, and on circles; what it makes of the case is computed in double.
// Its other faults are Box2D's own.

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
    const double part = cross(p, q);
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

/// An edge against a polygon, clipped between the very ends of the reference face.
bool planck_edge_slab_not_widened(const Deviation& d) {
  return is_edge_clip_of_planck(d, [](const BetweenEnds& clip) { return clip.is_cut; });
}

/// An edge against a polygon, clipped between the very ends of a face that is not the one of the
/// greatest separation: the edge's towards the polygon's centroid, or whichever 0.98 times the
/// edge's separation and 0.001 decide for.
bool planck_edge_hysteresis(const Deviation& d) {
  return is_edge_clip_of_planck(d, [](const BetweenEnds&) { return true; });
}

constexpr double kEpsilonOfPlanck = 1e-9;

bool axis_within_planck_epsilon(const Deviation& d) {
  return is_axis_within(d, kEpsilonOfPlanck);
}

bool face_within_planck_epsilon(const Deviation& d) {
  return is_face_within(d, kEpsilonOfPlanck);
}

constexpr LedgerRow kPlanckRows[] = {
    {"edge-slab-not-widened", planck_edge_slab_not_widened},
    {"edge-hysteresis", planck_edge_hysteresis},
    {"axis-within-epsilon", axis_within_planck_epsilon},
    {"face-within-epsilon", face_within_planck_epsilon},
    {"no-contact-under-bias", no_contact_under_bias},
    {"no-contact-on-tied-features", no_contact_on_tied_features},
    {"circle-tied-faces", is_end_of_tied_face},
};

bool detected_wrongly(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("planck", view, judgement);
}

constexpr SequenceRow kKeptRows[] = {{"detection", detected_wrongly}};

}  // namespace

Engine engine_planck() {
  return {.name = "planck",
          .ledger = {{"planck", kPlanckRows}},
          .sequence_ledger = {{"planck-kept", kKeptRows}}};
}

}  // namespace manifuzz
