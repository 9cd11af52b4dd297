#include <algorithm>
#include <limits>

#include "exact/curve.hpp"
#include "generating/drafts.hpp"
#include "judging/judge.hpp"

namespace manifuzz {
namespace {

ContactSummary summary_of(const Manifold<double>& manifold) {
  if (manifold.count == 0) return {.kind = ContactSummary::Kind::apart};
  ContactSummary result{.kind = ContactSummary::Kind::contact,
                        .count = manifold.count,
                        .reference = manifold.reference};
  for (int i = 0; i < manifold.count; ++i) result.features[i] = manifold.points[i].features;
  return result;
}

}  // namespace

Standing standing(const exact::Truth& truth) {
  const auto apart_by = [&](double above) {
    return Standing{.near = std::abs(above) <= kNearShare * truth.size_at_least() ||
                            std::abs(above) <= kNearShare * truth.size()};
  };
  if (!is_round(truth.pair())) {
    if (truth.compare_contact(0) <= 0) return {.touching = true};
    return apart_by(truth.separation() - total_radius(truth.pair()));
  }
  const exact::PenetrationCurve curve(truth, exact::Skin::round);
  if (curve.compare_least(0) >= 0) return {.touching = true};
  return apart_by(curve.least());
}

VertexOf deciding_vertex(const exact::Truth& truth) {
  if (is_round(truth.pair())) {
    const exact::PenetrationCurve curve(truth, exact::Skin::round);
    if (const auto nearest = curve.nearest_vertices()) return {Side::b, (*nearest)[1]};
  }
  const exact::FaceOf face = truth.greatest();
  return {other(face.side), truth.support(face)};
}

Grid grid_around(const exact::Truth& truth, int step) {
  const VertexOf vertex = deciding_vertex(truth);
  const ConvexPolygon<float>& polygon = truth.pair()[vertex.side].polygon;
  // A circle's center may be its origin.
  const double around = polygon.is_round() ? static_cast<double>(polygon.radius) : 0;
  return {.vertex = vertex, .ulp = ulp_of(std::max(reach(polygon), around)), .step = step};
}

std::optional<PairCase> neighbour(const PairCase& pair, const Grid& grid, int cell) {
  PairCase moved = pair;
  Vector2<float>& at = moved[grid.vertex.side].polygon.vertices[grid.vertex.index];
  const Vector2<double> steps(grid.x_of(cell), grid.y_of(cell));
  const Vector2<double> to = at.cast<double>() + grid.step * grid.ulp * steps;
  if (to.cwiseAbs().maxCoeff() > static_cast<double>(std::numeric_limits<float>::max())) {
    return std::nullopt;
  }
  at = to.cast<float>();
  return revalidated(moved);
}

ContactSummary summary_of(const Answer& answer) {
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr || manifold->count < 0 || manifold->count > 2) return {};
  return summary_of(*manifold);
}

ContactSummary summary_of(const exact::Truth& truth) {
  if (is_round(truth.pair())) {
    return {.kind = standing(truth).touching ? ContactSummary::Kind::contact
                                             : ContactSummary::Kind::apart};
  }
  if (truth.compare_contact(0) > 0) return {.kind = ContactSummary::Kind::apart};
  const exact::FaceOf face = truth.greatest();
  const exact::Clip& clip = truth.clip(face, truth.incident_edges(face, 0).front());
  const Manifold<double> manifold = true_manifold(clip);
  if (manifold.count > 0) return summary_of(manifold);
  return {.kind = ContactSummary::Kind::no_clip, .reference = face.side};
}

bool fails_alike(const Bucket& bucket, const Bucket& finding) {
  if (finding.fault != Fault::none) {
    return bucket.fault == finding.fault || bucket.fault == Fault::both;
  }
  if (finding.verdict == Verdict::agree) return bucket.fault != Fault::none;
  return bucket.verdict == finding.verdict;
}

Severity severity(const Neighbourhood& neighbourhood, const Bucket& finding) {
  Severity result;
  for (const Cell& cell : neighbourhood.cells) {
    if (cell.state != Cell::State::judged) continue;
    ++result.valid;
    if (fails_alike(cell.bucket, finding)) ++result.failing;
  }
  return result;
}

}  // namespace manifuzz
