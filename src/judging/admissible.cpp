#include "judging/admissible.hpp"

#include <algorithm>
#include <limits>

namespace manifuzz {
namespace {

using truth::Clip;
using truth::ClipPoint;
using truth::Real;
using Separations = std::array<Real, kMaxVertices>;

Real greatest(const Separations& separations, int count) {
  return *std::max_element(separations.begin(), separations.begin() + count);
}

void add_candidates(const PairCase& pair, const truth::World<Real>& world, Side side, int face,
                    Admissible& result) {
  const auto dots = truth::normal_dots(world, side, face);
  const int count = world[other(side)].count;
  const Real least = *std::min_element(dots.begin(), dots.begin() + count);
  for (int j = 0; j < count; ++j) {
    if (dots[j] > least + result.bounds.incident_dot) continue;
    result.candidates.push_back({side, face, j, truth::clip(pair, world, side, face, j)});
  }
}

bool has_candidates_on(const Admissible& result, Side side) {
  return std::any_of(result.candidates.begin(), result.candidates.end(),
                     [side](const Candidate& c) { return c.reference_side == side; });
}

/// Adds the references of each side that the bias leaves open, unless they are there already.
void add_references(const PairCase& pair, const truth::World<Real>& world, double tie_bias,
                    const std::array<Separations, 2>& separations, Admissible& result) {
  const double bound = result.bounds.separation;
  const Real lead_of_b = result.separation_b - result.separation_a;
  const std::array<bool, 2> open{lead_of_b <= tie_bias + bound, lead_of_b > tie_bias - bound};
  const std::array<Real, 2> best{result.separation_a, result.separation_b};
  for (const Side side : {Side::a, Side::b}) {
    const auto s = static_cast<std::size_t>(side);
    if (!open[s] || has_candidates_on(result, side)) continue;
    for (int i = 0; i < world[side].count; ++i) {
      if (separations[s][i] >= best[s] - bound) add_candidates(pair, world, side, i, result);
    }
  }
}

Real distance(const Vector2<double>& reported, const truth::Vector& true_position) {
  const truth::Vector apart = reported.cast<Real>() - true_position;
  return std::sqrt(apart.dot(apart));
}

bool nearly_clipped(const Clip& clip, const ClipPoint& point, const Bounds& bounds) {
  return point.crossing || clip.count < 2 || point.margin <= bounds.length;
}

/// A point that a right collider may leave out: too shallow, or of an edge that may miss the slab.
bool is_optional(const Candidate& candidate, const ClipPoint& point, const Bounds& bounds) {
  return point.depth <= depth_bound(candidate.clip, point, bounds) || may_miss(candidate, bounds);
}

/// Two points within bound of each other may be reported as one.
bool is_matched(const Manifold<double>& manifold, const Clip& clip, const ClipPoint& point,
                const Bounds& bounds) {
  for (int i = 0; i < manifold.count; ++i) {
    const auto& reported = manifold.points[i];
    if (distance(reported.position, point.position) <= position_bound(clip, point, bounds) &&
        std::abs(reported.depth - point.depth) <= depth_bound(clip, point, bounds)) {
      return true;
    }
  }
  return false;
}

/// The candidate's point nearest to a reported one.
const ClipPoint& nearest_point(const Clip& clip, const Vector2<double>& reported) {
  const bool second = clip.count > 1 && distance(reported, clip.points[1].position) <
                                            distance(reported, clip.points[0].position);
  return clip.points[second ? 1 : 0];
}

/// Whether the clip may come out less deep than its face's separation: no end at that depth is
/// safely inside the slab. The share is far below any collider's rounding, and far above the
/// truth's.
bool may_miss_deepest(const Candidate& candidate, const Admissible& result) {
  const Clip& clip = candidate.clip;
  const Real of_side =
      candidate.reference_side == Side::a ? result.separation_a : result.separation_b;
  const Real as_deep = result.total_radius - of_side - result.resolution;
  if (may_miss(candidate, result.bounds)) return true;
  return std::none_of(clip.points.begin(), clip.points.begin() + clip.count,
                      [&](const ClipPoint& point) {
                        const bool inside = point.crossing || point.margin > result.bounds.length;
                        return inside && point.depth >= as_deep;
                      });
}

/// Whether nothing that makes the point's features is within bound: one candidate, two ends that
/// can be told apart, none of them at a side plane.
bool features_decided(const Clip& clip, const ClipPoint& point, const Admissible& admissible) {
  if (admissible.candidates.size() > 1 || clip.count < 2) return false;
  const double bound = position_bound(clip, point, admissible.bounds);
  const truth::Vector apart = clip.points[1].position - clip.points[0].position;
  return point.margin > bound && apart.dot(apart) > 4 * bound * bound;
}

Mismatch point_mismatch(const ContactPoint<double>& reported, const Candidate& candidate,
                        const Admissible& admissible) {
  const Clip& clip = candidate.clip;
  const ClipPoint& point = nearest_point(clip, reported.position);
  const Real off = distance(reported.position, point.position);
  if (!(off <= position_bound(clip, point, admissible.bounds))) {
    return {Kind::position, static_cast<double>(off)};
  }
  const Real depth_off = std::abs(reported.depth - point.depth);
  if (!(depth_off <= depth_bound(clip, point, admissible.bounds))) {
    return {Kind::depth, static_cast<double>(depth_off)};
  }
  if (features_decided(clip, point, admissible) && reported.features != point.features) {
    return {Kind::features, 0};
  }
  return {};
}

bool closer(const Mismatch& m, const Mismatch& n) {
  if (m.kind == Kind::none || n.kind == Kind::none) {
    return m.kind == Kind::none && n.kind != Kind::none;
  }
  return m.kind != n.kind ? m.kind > n.kind : m.magnitude < n.magnitude;
}

}  // namespace

double position_bound(const Clip& clip, const ClipPoint& point, const Bounds& bounds) {
  if (!nearly_clipped(clip, point, bounds)) return bounds.length;
  const Real along_edge = std::min(bounds.length / clip.cosine, clip.edge_length);
  return bounds.length + static_cast<double>(along_edge);
}

double depth_bound(const Clip& clip, const ClipPoint& point, const Bounds& bounds) {
  if (!nearly_clipped(clip, point, bounds)) return bounds.length;
  const Real sine = std::sqrt(std::max(Real(0), 1 - clip.cosine * clip.cosine));
  const Real across = std::min(bounds.length * sine / clip.cosine, clip.edge_length);
  return bounds.length + static_cast<double>(across);
}

bool may_miss(const Candidate& candidate, const Bounds& bounds) {
  return candidate.clip.gap >= -bounds.length || candidate.clip.slab_width <= bounds.length;
}

bool may_be_empty(const Candidate& candidate, const Bounds& bounds) {
  const auto& points = candidate.clip.points;
  return std::all_of(points.begin(), points.begin() + candidate.clip.count,
                     [&](const ClipPoint& p) { return is_optional(candidate, p, bounds); });
}

Admissible admissible(const PairCase& pair, const Declaration& declaration) {
  const auto world = truth::place<Real>(pair);
  const std::array<Separations, 2> separations{truth::face_separations(world, Side::a),
                                               truth::face_separations(world, Side::b)};
  Admissible result;
  result.bounds = bounds(pair, declaration);
  result.resolution = 0x1p-58L * extent(pair);
  result.total_radius = world.total_radius;
  result.separation_a = greatest(separations[0], world.a.count);
  result.separation_b = greatest(separations[1], world.b.count);
  if (!result.may_touch()) return result;
  add_references(pair, world, declaration.tie_bias, separations, result);
  const bool any_misses =
      std::any_of(result.candidates.begin(), result.candidates.end(),
                  [&](const Candidate& c) { return may_miss_deepest(c, result); });
  if (result.separation() < result.bounds.separation && any_misses) {
    add_references(pair, world, 0, separations, result);
  }
  return result;
}

Mismatch mismatch(const Manifold<double>& manifold, const Candidate& candidate,
                  const Admissible& admissible) {
  const Clip& clip = candidate.clip;
  const Bounds& bounds = admissible.bounds;
  if (manifold.count > 0) {
    const truth::Vector turn = manifold.normal.cast<Real>() - clip.normal;
    const Real off = std::sqrt(turn.dot(turn));
    if (manifold.reference != candidate.reference_side || !(off <= bounds.normal)) {
      return {Kind::normal, static_cast<double>(off)};
    }
    if (clip.gap > bounds.length) {
      return {Kind::position, static_cast<double>(clip.gap)};
    }
  }
  for (int i = 0; i < manifold.count; ++i) {
    const Mismatch found = point_mismatch(manifold.points[i], candidate, admissible);
    if (found.kind != Kind::none) return found;
  }
  for (int i = 0; i < clip.count; ++i) {
    const ClipPoint& point = clip.points[i];
    if (!is_optional(candidate, point, bounds) && !is_matched(manifold, clip, point, bounds)) {
      return {Kind::count, static_cast<double>(point.depth)};
    }
  }
  return {};
}

Mismatch mismatch(const Manifold<double>& manifold, const Admissible& admissible) {
  const double from_contact =
      static_cast<double>(std::abs(admissible.separation() - admissible.total_radius));
  if (manifold.count == 0 && !admissible.may_touch()) return {};
  if (manifold.count == 0 && admissible.must_touch()) return {Kind::missed_contact, from_contact};
  if (manifold.count > 0 && !admissible.may_touch()) return {Kind::phantom_contact, from_contact};
  if (manifold.count == 0 &&
      admissible.separation() >= admissible.total_radius - admissible.bounds.separation) {
    return {};
  }
  Mismatch closest{Kind::missed_contact, from_contact};
  for (const Candidate& candidate : admissible.candidates) {
    Mismatch found = mismatch(manifold, candidate, admissible);
    if (manifold.count == 0 && found.kind != Kind::none) {
      found = {Kind::missed_contact, from_contact};
    }
    if (closer(found, closest)) closest = found;
  }
  return closest;
}

}  // namespace manifuzz
