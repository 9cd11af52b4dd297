#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact/fine_point.hpp"
#include "judging/bound_shares.hpp"
#include "judging/judge.hpp"
#include "properties/round_answer.hpp"

namespace manifuzz {
namespace {

using exact::DoubleDouble;
using exact::FaceOf;
using exact::FinePoint;

double largest_depth(const Manifold<double>& manifold) {
  double largest = 0;
  for (int i = 0; i < manifold.count; ++i) largest = std::max(largest, manifold.points[i].depth);
  return largest;
}

/// The widest depth bound of any right manifold.
double widest_depth_bound(const Admissible& right) {
  double widest = right.bounds.separation;
  for (const exact::Clip* clip : right.candidates) {
    for (const exact::ClipPoint& point : points_of(*clip)) {
      widest = std::max(widest, depth_bound(right, *clip, point));
    }
  }
  return widest;
}

FinePoint scaled(const DoubleDouble& factor, const FinePoint& p) {
  return {factor * p.x, factor * p.y};
}

double length(const FinePoint& p) {
  return leading(sqrt(dot(p, p)));
}

/// The sine of the angle from p to q, both unit.
double sine(const FinePoint& p, const FinePoint& q) {
  return leading(cross(p, q));
}

double distance_to_segment(const FinePoint& p, const FinePoint& from, const FinePoint& to) {
  const FinePoint along = to - from;
  const DoubleDouble share = dot(p - from, along) / dot(along, along);
  if (leading(share) <= 0) return length(p - from);
  if (leading(share) >= 1) return length(p - to);
  return length(p - from - scaled(share, along));
}

/// A vector of A's frame in world directions, as every `exact::vertex` is.
FinePoint placed(const PairCase& pair, const Vector2<double>& local) {
  return exact::turned(pair.a, exact::widen<DoubleDouble>(local));
}

/// Whether a point lies between a face's side planes, which stand the total radius outside its
/// ends, and no farther in front of it than the total radius.
PropertyOutcome behind_face(const PairCase& pair, FaceOf face, const FinePoint& at, double bound) {
  const FinePoint from_corner = at - exact::vertex<DoubleDouble>(pair, face.side, face.index);
  const FinePoint direction = exact::direction<DoubleDouble>(pair, face);
  const double along = leading(dot(unit_of(direction), from_corner));
  const double outside = std::max(-along, along - length(direction)) - total_radius(pair);
  if (!(outside <= bound)) return fails("a point outside the slab", outside / size(pair));
  const double front =
      leading(dot(unit_of(exact::outward<DoubleDouble>(pair, face)), from_corner)) -
      total_radius(pair);
  if (!(front <= bound)) return fails("a point in front of the reference face", front / size(pair));
  return holds(taken_of(bound, std::max(outside, front)));
}

PropertyOutcome point_in_place(const PairCase& pair, const Manifold<double>& manifold,
                               const ContactPoint<double>& point, double bound) {
  const Side reference = manifold.reference;
  const Side incident = other(reference);
  const Feature of_reference = reference == Side::a ? point.features.a : point.features.b;
  const Feature of_incident = reference == Side::a ? point.features.b : point.features.a;
  const auto vertex = [&](Side side, int index) {
    return exact::vertex<DoubleDouble>(pair, side, index);
  };
  const FinePoint at = placed(pair, point.position);
  const double unit_length = size(pair);
  if (of_reference.kind == of_incident.kind) {
    return fails("features that are neither end nor crossing", 0);
  }
  if (of_incident.kind == Feature::Kind::vertex) {
    const double off = length(at - vertex(incident, of_incident.index));
    if (!(off <= bound)) return fails("a point off its vertex", off / unit_length);
    PropertyOutcome outcome = behind_face(pair, {reference, of_reference.index}, at, bound);
    outcome.of_bound = std::max(outcome.of_bound, taken_of(bound, off));
    return outcome;
  }
  const int edge = of_incident.index;
  const double off = distance_to_segment(at, vertex(incident, edge),
                                         vertex(incident, pair[incident].polygon.next(edge)));
  if (!(off <= bound)) return fails("a point off the incident edge", off / unit_length);
  // The crossing lies on the side plane through the reference vertex, the total radius outside it.
  const FinePoint normal = unit_of(placed(pair, manifold.normal));
  const double aside = std::abs(sine(normal, at - vertex(reference, of_reference.index)));
  const double off_plane = std::abs(aside - total_radius(pair));
  if (!(off_plane <= 2 * bound)) {
    return fails("a crossing off its side plane", off_plane / unit_length);
  }
  return holds(std::max(taken_of(bound, off), taken_of(2 * bound, off_plane)));
}

/// How far the second of two points lies beyond the first along the reference face.
double along_reference(const PairCase& pair, const Manifold<double>& manifold) {
  if (manifold.count < 2) return 0;
  const Vector2<double> apart = manifold.points[1].position - manifold.points[0].position;
  const double forward = sine(unit_of(placed(pair, manifold.normal)), placed(pair, apart));
  return manifold.reference == Side::a ? forward : -forward;
}

/// The article finds its edges by the farthest vertex, which is decided where the deepest vertex
/// lies clearly below all others, the reference face clearly above all other vertices of its
/// polygon, and is clearly more perpendicular to the normal than the edges next to it, and so is
/// the incident edge, than the other one at the deepest vertex.
bool farthest_vertices_decided(const PairCase& pair, const Admissible& right) {
  const exact::Clip& only = *right.candidates.front();
  const FaceOf face = only.reference;
  const Side opposing = other(face.side);
  const FinePoint normal = unit_of(exact::outward<DoubleDouble>(pair, face));
  const double clear_height = 2 * right.bounds.separation;
  const double clear_tilt = 2 * right.bounds.normal;

  /// How far vertex v lies along the normal beyond vertex w.
  const auto beyond = [&](Side side, int v, int w) {
    return leading(dot(normal, exact::vertex<DoubleDouble>(pair, side, v) -
                                   exact::vertex<DoubleDouble>(pair, side, w)));
  };
  const auto tilt = [&](FaceOf edge) {
    return std::abs(sine(unit_of(exact::outward<DoubleDouble>(pair, edge)), normal));
  };
  const auto tilted = [&](FaceOf edge) { return tilt(edge) > clear_tilt; };
  const ConvexPolygon<float>& reference = pair[face.side].polygon;
  const int second = reference.next(face.index);
  for (int i = 0; i < reference.count; ++i) {
    if (i == face.index || i == second) continue;
    if (beyond(face.side, face.index, i) <= clear_height || !tilted({face.side, i})) return false;
  }
  const ConvexPolygon<float>& incident = pair[opposing].polygon;
  const int end = incident.next(only.incident);
  const int deepest = beyond(opposing, end, only.incident) < 0 ? end : only.incident;
  for (int i = 0; i < incident.count; ++i) {
    if (i != deepest && beyond(opposing, i, deepest) <= clear_height) return false;
  }
  const int beside = deepest == only.incident ? incident.previous(deepest) : deepest;
  if (tilt({opposing, beside}) - tilt({opposing, only.incident}) <= clear_tilt) return false;
  return tilted({opposing, only.incident}) && tilted({face.side, second});
}

/// Total radius - S, to well past double.
DoubleDouble true_overlap(const PairCase& pair, const exact::Truth& truth) {
  return exact::total_radius<DoubleDouble>(pair) - truth.fine_separation(truth.greatest());
}

}  // namespace

PropertyOutcome points_lie_where_they_say(AskedCollider& ask, const PairCase& pair) {
  if (is_round(pair)) return not_applicable();  // those are in no slab, and on surfaces
  if (ask.declaration().claims != Claims::manifold) return not_applicable();  // nor need one be
  const auto manifold = ask.manifold(pair);
  if (!manifold || manifold->count == 0) return not_applicable();
  const Bounds within = bounds(pair, ask.declaration());
  // A normal off by its bound turns the side plane about the reference vertex.
  const double bound = within.separation + within.normal * extent(pair);
  double of_bound = 0;
  for (int i = 0; i < manifold->count; ++i) {
    const auto& point = manifold->points[i];
    if (!(point.depth >= 0)) return fails("a point in front of the reference face", -point.depth);
    const PropertyOutcome outcome = point_in_place(pair, *manifold, point, bound);
    if (outcome.kind != PropertyOutcome::Kind::holds) return outcome;
    of_bound = std::max(of_bound, outcome.of_bound);
  }
  const double forward = along_reference(pair, *manifold);
  if (!(forward >= -2 * bound)) {
    return fails("points against the reference face's direction", -forward / size(pair));
  }
  return holds(std::max(of_bound, taken_of(2 * bound, -forward)));
}

/// What a collider answers at bias 0 to a pair that must touch.
struct Unbiased {
  Declaration declaration;
  Admissible right;
  Manifold<double> manifold;
};

/// None where the bias is fixed at another value, where nothing must touch, or without an answer.
std::optional<Unbiased> ask_without_bias(const Collider& collider, const PairCase& pair) {
  const bool is_unbiased = collider.declaration.tie_bias.is_none();
  if (!is_unbiased && !collider.with_tie_bias) return std::nullopt;
  const Collider unbiased = is_unbiased ? collider : collider.with_tie_bias(0);
  const Admissible right = admissible(pair, unbiased.declaration);
  const auto manifold = right.must_touch ? AskedCollider(unbiased).manifold(pair) : std::nullopt;
  if (!manifold) return std::nullopt;
  return Unbiased{unbiased.declaration, right, *manifold};
}

PropertyOutcome depth_is_the_overlap(AskedCollider& ask, const PairCase& pair) {
  if (is_round(pair)) return round_depth_is_least(ask, pair);
  const auto unbiased = ask_without_bias(ask.collider(), pair);
  if (!unbiased) return not_applicable();
  const auto& [declaration, right, manifold] = *unbiased;
  const double off = std::abs(leading(largest_depth(manifold) - true_overlap(pair, *right.truth)));
  const double bound = widest_depth_bound(right);
  if (off <= bound) return holds(taken_of(bound, off));
  return fails("a largest depth that is not the overlap", off / size(pair));
}

PropertyOutcome depth_moves_apart(AskedCollider& ask, const PairCase& pair) {
  if (is_round(pair)) return round_depth_moves_apart(ask, pair);
  const auto unbiased = ask_without_bias(ask.collider(), pair);
  if (!unbiased || unbiased->manifold.count == 0) return not_applicable();
  const auto& [declaration, right, manifold] = *unbiased;
  const Vector2<double> normal = world_normal(pair, manifold.normal);
  double of_bound = 0;
  for (const double further : {0.0, size(pair) / 4}) {
    const double by = largest_depth(manifold) + further;
    PairCase moved = pair;
    const Vector2<double> start = pair.b.pose.position.cast<double>();
    moved.b.pose.position = Vector2<double>(start + by * normal).cast<float>();
    const Vector2<double> shift = moved.b.pose.position.cast<double>() - start;
    const double rounding = (shift - by * normal).norm();
    const Bounds after = bounds(moved, declaration);
    const double bound =
        widest_depth_bound(right) + after.separation + rounding + right.bounds.normal * by;
    const double off = std::abs(leading(true_overlap(moved, exact::Truth(moved)) + further));
    if (!(off <= bound)) {
      return fails(further == 0 ? "not touching at zero when moved by the depth"
                                : "not as far apart as it was moved",
                   off / size(pair));
    }
    // What the move was rounded by is known, and nobody's error.
    of_bound = std::max(of_bound, taken_of(bound - rounding, off - rounding));
  }
  return holds(of_bound);
}

PropertyOutcome float_and_double_agree(AskedCollider& ask, const PairCase& pair) {
  if (!ask.collider().in_double) return not_applicable();
  const auto manifold = ask.manifold(pair);
  if (!manifold) return not_applicable();
  const Judgement judgement = judge(pair, ask.collider(), ask.collider().in_double());
  if (judgement.bucket.fault == Fault::none) return holds();
  return fails(to_string(judgement.bucket), judgement.magnitude);
}

PropertyOutcome overlap_is_never_empty(AskedCollider& ask, const PairCase& pair) {
  if (is_round(pair)) return round_overlap_is_never_empty(ask, pair);
  const Admissible right = admissible(pair, ask.declaration());
  if (!right.must_touch) return not_applicable();
  const auto manifold = ask.manifold(pair);
  if (!manifold) return not_applicable();
  if (manifold->count > 0) return holds();
  return fails("no contact for an overlap", leading(true_overlap(pair, *right.truth)) / size(pair));
}

PropertyOutcome manifold_is_admissible(AskedCollider& ask, const PairCase& pair) {
  if (is_judged_by_curve(ask.declaration(), pair)) return manifold_is_right_by_curve(ask, pair);
  const auto manifold = ask.manifold(pair);
  if (!manifold) return not_applicable();
  const Admissible right = admissible(pair, ask.declaration());
  const Mismatch found = mismatch(*manifold, right);
  if (found.kind == Kind::none) {
    const ManifoldError shares = clip_shares(*manifold, right);
    return holds(std::min(std::max({shares.normal, shares.position, shares.depth}), 1.0));
  }
  return fails(fmt::format("wrong: {}", name_of(found.kind, kKindNames)),
               found.magnitude / size(pair));
}

PropertyOutcome given_normal_agrees(AskedCollider& ask, const PairCase& pair) {
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
