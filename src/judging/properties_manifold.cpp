#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "judging/inquiry.hpp"
#include "judging/judge.hpp"

namespace manifuzz {
namespace {

using truth::Real;

/// The collider at bias 0, or none where its bias is fixed at another value.
std::optional<Collider> without_bias(const Collider& collider) {
  if (collider.declaration.tie_bias == 0) return collider;
  if (!collider.with_tie_bias) return std::nullopt;
  return collider.with_tie_bias(0);
}

double largest_depth(const Manifold<double>& manifold) {
  double largest = 0;
  for (int i = 0; i < manifold.count; ++i) largest = std::max(largest, manifold.points[i].depth);
  return largest;
}

/// The widest depth bound of any right manifold.
double widest_depth_bound(const Admissible& right) {
  double widest = right.bounds.length;
  for (const Candidate& candidate : right.candidates) {
    for (int i = 0; i < candidate.clip.count; ++i) {
      widest =
          std::max(widest, depth_bound(candidate.clip, candidate.clip.points[i], right.bounds));
    }
  }
  return widest;
}

Real distance_to_segment(const truth::Vector& p, const truth::Vector& from,
                         const truth::Vector& to) {
  const truth::Vector along = to - from;
  const Real share = std::clamp(Real((p - from).dot(along) / along.dot(along)), Real(0), Real(1));
  return (p - from - share * along).norm();
}

/// The reported point in world directions from A's position, as truth::place has everything.
truth::Vector placed(const PairCase& pair, const Vector2<double>& local) {
  return rotate<Real>(pair.a.pose.rotation.cast<Real>(), local.cast<Real>());
}

Outcome point_in_place(const PairCase& pair, const truth::World<Real>& world,
                       const Manifold<double>& manifold, const ContactPoint<double>& point,
                       double bound) {
  const Feature of_reference = manifold.reference == Side::a ? point.features.a : point.features.b;
  const Feature of_incident = manifold.reference == Side::a ? point.features.b : point.features.a;
  const auto& reference = world[manifold.reference];
  const auto& incident = world[other(manifold.reference)];
  const truth::Vector at = placed(pair, point.position);
  const double unit = size(pair);
  if (of_reference.kind == of_incident.kind) {
    return fails("features that are neither end nor crossing", 0);
  }
  if (of_incident.kind == Feature::Kind::vertex) {
    const Real off = (at - incident.vertices[of_incident.index]).norm();
    if (!(off <= bound)) return fails("a point off its vertex", static_cast<double>(off) / unit);
    return holds();
  }
  const int edge = of_incident.index;
  const Real off =
      distance_to_segment(at, incident.vertices[edge], incident.vertices[incident.next(edge)]);
  if (!(off <= bound)) {
    return fails("a point off the incident edge", static_cast<double>(off) / unit);
  }
  // The crossing lies on the side plane through the reference vertex, the total radius outside it.
  const truth::Vector normal =
      rotate<Real>(pair.a.pose.rotation.cast<Real>(), manifold.normal.cast<Real>()).normalized();
  const Real aside = std::abs(cross<Real>(normal, at - reference.vertices[of_reference.index]));
  if (!(std::abs(aside - world.total_radius) <= 2 * bound)) {
    return fails("a crossing off its side plane",
                 static_cast<double>(std::abs(aside - world.total_radius)) / unit);
  }
  return holds();
}

/// The article finds its edges by the farthest vertex, which is decided where the deepest vertex
/// lies clearly below all others, the reference face clearly above all other vertices of its
/// polygon, and is clearly more perpendicular to the normal than the edges next to it.
bool farthest_vertices_decided(const PairCase& pair, const Admissible& right) {
  const Candidate& only = right.candidates.front();
  const auto world = truth::place<Real>(pair);
  const auto& reference = world[only.reference_side];
  const auto& incident = world[other(only.reference_side)];
  const truth::Vector& normal = reference.normals[only.reference];
  const Real clear_height = 2 * right.bounds.separation;
  const Real clear_tilt = 2 * right.bounds.normal;

  const auto is_clear = [&](const auto& polygon, Real sign, int v, int w) {
    const truth::Vector below = polygon.vertices[v] - polygon.vertices[w];
    return v == w || sign * normal.dot(below) > clear_height;
  };
  const auto tilted = [&](const auto& polygon, int edge) {
    return std::abs(cross<Real>(polygon.normals[edge], normal)) > clear_tilt;
  };
  const int first = only.reference;
  const int second = reference.next(first);
  for (int i = 0; i < reference.count; ++i) {
    if (i == first || i == second) continue;
    if (!is_clear(reference, 1, first, i) || !tilted(reference, i)) return false;
  }
  const int end = incident.next(only.incident);
  const Real fall = normal.dot(incident.vertices[end] - incident.vertices[only.incident]);
  const int deepest = fall < 0 ? end : only.incident;
  for (int i = 0; i < incident.count; ++i) {
    if (!is_clear(incident, -1, deepest, i)) return false;
  }
  return tilted(incident, only.incident) && tilted(reference, second);
}

}  // namespace

Outcome points_lie_where_they_say(Inquiry& ask, const PairCase& pair) {
  const auto manifold = ask.manifold(pair);
  if (!manifold || manifold->count == 0) return not_applicable();
  const auto world = truth::place<Real>(pair);
  const Bounds within = bounds(pair, ask.declaration());
  // A normal off by its bound turns the side plane about the reference vertex.
  const double bound = within.length + within.normal * extent(pair);
  for (int i = 0; i < manifold->count; ++i) {
    const auto& point = manifold->points[i];
    if (!(point.depth >= 0)) return fails("a point in front of the reference face", -point.depth);
    const Outcome outcome = point_in_place(pair, world, *manifold, point, bound);
    if (outcome.kind != Outcome::Kind::holds) return outcome;
  }
  return holds();
}

Outcome depth_is_the_overlap(Inquiry& ask, const PairCase& pair) {
  const auto unbiased = without_bias(ask.collider());
  if (!unbiased) return not_applicable();
  const Admissible right = admissible(pair, unbiased->declaration);
  if (!right.must_touch()) return not_applicable();
  Inquiry ask_unbiased(*unbiased);
  const auto manifold = ask_unbiased.manifold(pair);
  if (!manifold) return not_applicable();
  const double expected = static_cast<double>(right.total_radius - right.separation());
  const double off = std::abs(largest_depth(*manifold) - expected);
  if (off <= widest_depth_bound(right)) return holds();
  return fails("a largest depth that is not the overlap", off / size(pair));
}

Outcome depth_moves_apart(Inquiry& ask, const PairCase& pair) {
  const auto unbiased = without_bias(ask.collider());
  if (!unbiased) return not_applicable();
  const Admissible right = admissible(pair, unbiased->declaration);
  if (!right.must_touch()) return not_applicable();
  Inquiry ask_unbiased(*unbiased);
  const auto manifold = ask_unbiased.manifold(pair);
  if (!manifold || manifold->count == 0) return not_applicable();
  const Vector2<double> normal = world_normal(pair, manifold->normal);
  for (const double further : {0.0, size(pair) / 4}) {
    const double by = largest_depth(*manifold) + further;
    PairCase moved = pair;
    const Vector2<double> start = pair.b.pose.position.cast<double>();
    moved.b.pose.position = Vector2<double>(start + by * normal).cast<float>();
    const Vector2<double> shift = moved.b.pose.position.cast<double>() - start;
    const double rounding = (shift - by * normal).norm();
    const Bounds after = bounds(moved, unbiased->declaration);
    const double bound =
        widest_depth_bound(right) + after.separation + rounding + right.bounds.normal * by;
    const double off = std::abs(truth::separation(moved) - total_radius(pair) - further);
    if (!(off <= bound)) {
      return fails(further == 0 ? "not touching at zero when moved by the depth"
                                : "not as far apart as it was moved",
                   off / size(pair));
    }
  }
  return holds();
}

Outcome float_and_double_agree(Inquiry& ask, const PairCase& pair) {
  if (!ask.collider().in_double) return not_applicable();
  const auto manifold = ask.manifold(pair);
  if (!manifold) return not_applicable();
  const Judgement judgement = judge(pair, ask.collider(), ask.collider().in_double());
  if (judgement.bucket.fault == Fault::none) return holds();
  return fails(to_string(judgement.bucket), judgement.magnitude);
}

Outcome overlap_is_never_empty(Inquiry& ask, const PairCase& pair) {
  const Admissible right = admissible(pair, ask.declaration());
  if (!right.must_touch()) return not_applicable();
  const auto manifold = ask.manifold(pair);
  if (!manifold) return not_applicable();
  if (manifold->count > 0) return holds();
  return fails("no contact for an overlap",
               static_cast<double>(right.total_radius - right.separation()) / size(pair));
}

Outcome manifold_is_admissible(Inquiry& ask, const PairCase& pair) {
  const auto manifold = ask.manifold(pair);
  if (!manifold) return not_applicable();
  const Mismatch found = mismatch(*manifold, admissible(pair, ask.declaration()));
  if (found.kind == Kind::none) return holds();
  return fails(fmt::format("wrong: {}", name_of(found.kind, kKindNames)),
               found.magnitude / size(pair));
}

Outcome given_normal_agrees(Inquiry& ask, const PairCase& pair) {
  if (!ask.collider().from_normal) return not_applicable();
  const auto right = decided(pair, ask.declaration());
  if (!right || !farthest_vertices_decided(pair, *right)) return not_applicable();
  const auto manifold = ask.manifold(pair);
  if (!manifold || manifold->count == 0) return not_applicable();
  const Answer given = ask.collider().from_normal(pair, manifold->normal);
  return same_manifold(pair, *manifold, std::get<Manifold<double>>(given), tolerance(*right),
                       Features::compared);
}

}  // namespace manifuzz
