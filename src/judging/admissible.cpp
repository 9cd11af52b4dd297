#include "judging/admissible.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "exact/curve.hpp"
#include "judging/turned_faces.hpp"

namespace manifuzz {
namespace {

using exact::Clip;
using exact::ClipPoint;
using exact::FaceOf;

bool has_candidates_on(const Admissible& result, Side side) {
  return std::any_of(result.candidates.begin(), result.candidates.end(),
                     [side](const Clip* clip) { return clip->reference.side == side; });
}

/// Adds the references of each side that the bias leaves open, unless they are there already.
void add_references(const TieBias& bias, Admissible& result) {
  const exact::Truth& truth = *result.truth;
  for (const Side side : {Side::a, Side::b}) {
    if (has_candidates_on(result, side)) continue;
    if (!may_be_reference(truth, bias, side, result.bounds.separation)) continue;
    std::ranges::copy(clips_within(truth, side, result.bounds),
                      std::back_inserter(result.candidates));
  }
}

bool nearly_clipped(const Bounds& bounds, const Clip& clip, const ClipPoint& point) {
  return point.crossing || clip.count < 2 ||
         compare_margin(clip, point.end, bounds.separation) <= 0;
}

/// Whether a reported point has the true place and depth.
bool matches(const Admissible& right, const Clip& clip, const ClipPoint& point,
             const ContactPoint<double>& reported) {
  return is_near_position(clip, point, reported.position, position_bound(right, clip, point)) &&
         is_near_depth(clip, point, reported.depth, depth_bound(right, clip, point));
}

/// Two points within bound of each other may be reported as one.
bool is_matched(const Admissible& right, const Clip& clip, const ClipPoint& point,
                const Manifold<double>& manifold) {
  return std::any_of(manifold.points.begin(), manifold.points.begin() + manifold.count,
                     [&](const auto& reported) { return matches(right, clip, point, reported); });
}

bool closer(const Mismatch& m, const Mismatch& n) {
  if (m.kind == Kind::none || n.kind == Kind::none) {
    return m.kind == Kind::none && n.kind != Kind::none;
  }
  return m.kind != n.kind ? m.kind > n.kind : m.magnitude < n.magnitude;
}

Mismatch point_mismatch(const Admissible& right, const Clip& clip, const ClipPoint& point,
                        const ContactPoint<double>& reported) {
  const double apart = position_bound(right, clip, point);
  if (!is_near_position(clip, point, reported.position, apart)) {
    return {Kind::position, (reported.position - point.position()).norm(), apart};
  }
  const double deeper = depth_bound(right, clip, point);
  if (!is_near_depth(clip, point, reported.depth, deeper)) {
    return {Kind::depth, std::abs(reported.depth - point.depth()), deeper};
  }
  if (reported.features != point.features && features_decided(right, clip, point)) {
    return {Kind::features, 0};
  }
  return {};
}

/// A reported point against the clip's: the closest.
Mismatch point_mismatch(const Admissible& right, const Clip& clip,
                        const ContactPoint<double>& reported) {
  Mismatch closest = point_mismatch(right, clip, clip.points[0], reported);
  if (clip.count > 1 && closest.kind != Kind::none) {
    const Mismatch second = point_mismatch(right, clip, clip.points[1], reported);
    if (closer(second, closest)) closest = second;
  }
  return closest;
}

Mismatch mismatch_within(const Manifold<double>& manifold, const Clip& clip,
                         const Admissible& right) {
  if (manifold.count > 0) {
    if (manifold.reference != clip.reference.side ||
        !is_near_normal(clip, manifold.normal, right.bounds.normal)) {
      return {Kind::normal, (manifold.normal - clip.normal).norm(), right.bounds.normal};
    }
    if (compare_gap(clip, right.bounds.separation) > 0) {
      return {Kind::position, clip.gap(), right.bounds.separation};
    }
  }
  for (int i = 0; i < manifold.count; ++i) {
    const Mismatch found = point_mismatch(right, clip, manifold.points[i]);
    if (found.kind != Kind::none) return found;
  }
  for (const ClipPoint& point : points_of(clip)) {
    if (!is_optional(right, clip, point) && !is_matched(right, clip, point, manifold)) {
      return {Kind::count, point.depth(), depth_bound(right, clip, point)};
    }
  }
  return {};
}

}  // namespace

Bounds bounds_of_face(const Admissible& right, const Clip& clip) {
  Bounds bounds = right.bounds;
  const double turn = face_turn(bounds, *clip.pair, clip.reference);
  const double of_lengths = turn * (right.truth->extent() + total_radius(right.pair()));
  bounds.normal += turn;
  bounds.separation += of_lengths;
  bounds.position += of_lengths;
  return bounds;
}

Admissible with_face_of(const Admissible& right, const Clip& clip) {
  Admissible result = right;
  result.bounds = bounds_of_face(right, clip);
  return result;
}

std::vector<const Clip*> clips_within(const exact::Truth& truth, Side side, const Bounds& bounds) {
  const double bound = bounds.separation;
  std::vector<const Clip*> clips;
  for (int i = 0; i < truth.pair()[side].polygon.count; ++i) {
    const FaceOf face{side, i};
    if (truth.compare_with_greatest(face, -bound) < 0) continue;
    for (const int incident : truth.incident_edges(face, bounds.incident_dot)) {
      clips.push_back(&truth.clip(face, incident));
    }
  }
  return clips;
}

double Admissible::from_contact() const {
  if (is_round(pair()))
    return std::abs(exact::PenetrationCurve(*truth, exact::Skin::round).least());
  return std::abs(truth->separation() - total_radius(pair()));
}

double position_bound(const Bounds& bounds, const Clip& clip, const ClipPoint& point) {
  if (!nearly_clipped(bounds, clip, point)) return bounds.position;
  return bounds.position + std::min(bounds.separation / clip.cosine, clip.edge_length);
}

double depth_bound(const Bounds& bounds, const Clip& clip, const ClipPoint& point) {
  const double depth = bounds.separation;
  if (!nearly_clipped(bounds, clip, point)) return depth;
  return depth + std::min(depth * clip.tangent, clip.edge_length);
}

bool may_miss(const Admissible& right, const Clip& clip) {
  return compare_gap(clip, -right.bounds.separation) >= 0 ||
         compare_width(clip, right.bounds.separation) <= 0;
}

bool is_optional(const Admissible& right, const Clip& clip, const ClipPoint& point) {
  return compare_depth(clip, point, depth_bound(right, clip, point)) <= 0 || may_miss(right, clip);
}

bool is_at_zero_depth(const Admissible& right, const Clip& clip, const ClipPoint& point) {
  const double bound = depth_bound(right, clip, point);
  return compare_depth(clip, point, bound) <= 0 && compare_depth(clip, point, -bound) >= 0;
}

bool may_be_empty(const Admissible& right, const Clip& clip) {
  return std::ranges::all_of(
      points_of(clip), [&](const ClipPoint& point) { return is_optional(right, clip, point); });
}

bool features_decided(const Admissible& right, const Clip& clip, const ClipPoint& point) {
  if (right.candidates.size() > 1 || clip.count < 2) return false;
  const double bound = position_bound(right, clip, point);
  return compare_margin(clip, point.end, bound) > 0 && compare_apart(clip, 2 * bound) > 0;
}

Admissible admissible(std::shared_ptr<const exact::Truth> truth, const Declaration& declaration) {
  const Bounds own = bounds(truth->pair(), declaration, truth->extent());
  return admissible(std::move(truth), declaration.tie_bias, own);
}

int compare_lead_over_bias(const exact::Truth& truth, const TieBias& bias, double offset) {
  return truth.compare_lead(other(bias.towards), 1 - bias.relative, bias.absolute + offset);
}

bool may_be_reference(const exact::Truth& truth, const TieBias& bias, Side side, double bound) {
  return side == bias.towards ? compare_lead_over_bias(truth, bias, bound) <= 0
                              : compare_lead_over_bias(truth, bias, -bound) > 0;
}

Side reference_under(const exact::Truth& truth, const TieBias& bias) {
  return compare_lead_over_bias(truth, bias, 0) > 0 ? other(bias.towards) : bias.towards;
}

Admissible admissible(std::shared_ptr<const exact::Truth> truth, const TieBias& tie_bias,
                      const Bounds& bounds) {
  Admissible result;
  result.bounds = bounds;
  result.tie_bias = tie_bias;
  const double bound = result.bounds.separation;
  if (!std::isfinite(bound) || is_round(truth->pair())) {
    result.truth = std::move(truth);
    result.may_touch = result.may_be_apart = true;
    return result;
  }
  if (bounds.world_vertex > 0) return admissible_by_turned_faces(std::move(truth), result);
  result.must_touch = truth->compare_separation(-bound) < 0;
  result.may_touch = truth->compare_contact(bound) <= 0;
  result.may_be_apart = truth->compare_contact(-bound) >= 0;
  const bool may_overlap = truth->compare_separation(bound) < 0;
  result.truth = std::move(truth);
  if (!result.may_touch) return result;
  add_references(tie_bias, result);
  if (may_overlap && std::ranges::any_of(result.candidates, [&](const Clip* clip) {
        return may_be_empty(result, *clip);
      })) {
    add_references({}, result);
  }
  return result;
}

Admissible admissible(const PairCase& pair, const Declaration& declaration) {
  return admissible(std::make_shared<const exact::Truth>(pair), declaration);
}

Mismatch mismatch(const Manifold<double>& manifold, const Clip& clip, const Admissible& right) {
  const Mismatch found = mismatch_within(manifold, clip, right);
  if (found.kind == Kind::none || face_turn(right.bounds, *clip.pair, clip.reference) == 0) {
    return found;
  }
  return mismatch_within(manifold, clip, with_face_of(right, clip));
}

Mismatch mismatch(const Manifold<double>& manifold, const Admissible& right) {
  if (manifold.count == 0 && !right.may_touch) return {};
  const double bound = right.bounds.separation;
  const Mismatch missed{Kind::missed_contact, right.from_contact(), bound};
  if (manifold.count == 0 && right.must_touch) return missed;
  if (manifold.count > 0 && !right.may_touch) {
    return {Kind::phantom_contact, right.from_contact(), bound};
  }
  if (manifold.count == 0 && right.may_be_apart) return {};
  Mismatch closest = missed;
  for (const Clip* clip : right.candidates) {
    Mismatch found = mismatch(manifold, *clip, right);
    if (manifold.count == 0 && found.kind != Kind::none) found = missed;
    if (closer(found, closest)) closest = found;
  }
  return closest;
}

std::vector<Manifold<double>> right_manifolds(const Admissible& right) {
  std::vector<Manifold<double>> manifolds;
  if (!std::isfinite(right.bounds.separation) || is_round(right.pair())) return manifolds;
  const Manifold<double> apart;
  if (mismatch(apart, right).kind == Kind::none) manifolds.push_back(apart);
  for (const Clip* clip : right.candidates) {
    const Manifold<double> touching = true_manifold(*clip, right.bounds.separation);
    if (touching.count > 0) manifolds.push_back(touching);
  }
  return manifolds;
}

}  // namespace manifuzz
