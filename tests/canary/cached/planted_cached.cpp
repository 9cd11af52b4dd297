// Copied with the bugs planted into what keeps points over frames, and compiled under a namespace
// of theirs.
#include "base/random.hpp"
#include "canary/cached/cached_bugs.hpp"
#include "own_colliders/cached.cpp"
#include "own_colliders/detected.cpp"

namespace manifuzz {
namespace {

/// Over gjk64 that does not say whose face clips, and puts its point elsewhere.
SequenceCollider kept_of_gjk(const char* name, PointsAt at, double share_of_depth) {
  Collider collider = make_gjk64();
  collider.declaration.name = name;
  collider.declaration.points = at;
  collider.collide = [ask = collider.collide, at, share_of_depth](const PairCase& pair) -> Answer {
    const Answer answer = ask(pair);
    const auto* const found = std::get_if<Manifold<double>>(&answer);
    if (found == nullptr) return answer;
    PartialManifold partial{.manifold = *found};
    ContactPoint<double>& point = partial.manifold.points[0];
    if (at == PointsAt::clip || found->count == 0) return partial;
    const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
    const double local_per_world = 1 / std::sqrt(rotation.dot(rotation));
    const bool is_on_b = found->reference == Side::a;
    const bool is_on_surface = is_round(pair);
    const double radius = static_cast<double>(pair[is_on_b ? Side::b : Side::a].polygon.radius);
    const double to_surface = is_on_surface ? 0 : (is_on_b ? -radius : radius);
    const double through = (is_on_b ? share_of_depth : share_of_depth - 1) * point.depth;
    point.position += (to_surface + through) * local_per_world * found->normal;
    return partial;
  };
  SequenceCollider (*const over_any)(const Collider&) = cached_over;
  return over_any(collider);
}

SequenceCollider kept_of_clips() {
  return kept_of_gjk("unnamed clips", PointsAt::clip, 0);
}
SequenceCollider kept_of_midpoints() {
  return kept_of_gjk("midpoints", PointsAt::midpoint, 0.5);
}
SequenceCollider kept_of_points_on_a() {
  return kept_of_gjk("points on A", PointsAt::surface_a, 1);
}
SequenceCollider kept_of_points_on_b() {
  return kept_of_gjk("points on B", PointsAt::surface_b, 0);
}

/// Where faces are parallel but for float's rounding any place of them is right: this one takes
/// another each time, so that there are soon more points than are kept.
SequenceCollider kept_of_wandering_points() {
  Collider collider = make_clip();
  collider.declaration.name = "wandering points";
  collider.declaration.claims = Claims::point;
  collider.declaration.min_vertices = kMinVertices;
  collider.declaration.takes_round = false;
  collider.collide = [ask = make_gjk64().collide, clip = make_clip64().collide,
                      random = Random(1, "places", 0)](const PairCase& pair) mutable -> Answer {
    if (is_round(pair)) return Unsupported{"takes no round shapes"};
    Manifold<double> manifold = std::get<Manifold<double>>(clip(pair));
    const auto& [first, second] = manifold.points;
    const double share = random.unit();
    if (manifold.count == 2 && std::abs(first.depth - second.depth) <= 1e-7 * size(pair)) {
      manifold.points[0].position += share * (second.position - first.position);
      manifold.points[0].depth += share * (second.depth - first.depth);
      manifold.count = 1;
      return manifold;
    }
    return ask(pair);
  };
  SequenceCollider (*const over_any)(const Collider&) = cached_over;
  return over_any(collider);
}

[[maybe_unused]] const bool planted = canary::add_keepers(
    {PLANTED_BUGS}, {make_cached, make_cached64, kept_of_clips, kept_of_midpoints,
                     kept_of_points_on_a, kept_of_points_on_b, kept_of_wandering_points});

}  // namespace
}  // namespace manifuzz
