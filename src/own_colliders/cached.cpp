#include <cassert>
#include <cmath>

#include "methods/cached_as_bullet.hpp"
#include "own_colliders/detected.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

using methods::Carrier;
using methods::DetectedPoint;
using methods::PointCache;

/// How the bodies stand in a frame, as points are kept.
template <class Scalar>
struct Standing {
  Pose<Scalar> b_in_a;
  Vector2<Scalar> rotation_a;
  Vector2<Scalar> rotation_b;
  Scalar world_per_local = 1;  ///< the world's length of one of A's frame
};

/// In float rotations are taken to be unit, as detection takes them; in double they are divided by.
template <class Scalar>
Standing<Scalar> standing(const PairCase& pair) {
  if constexpr (std::is_same_v<Scalar, float>) {
    return {relative_pose(pair.a.pose, pair.b.pose), pair.a.pose.rotation, pair.b.pose.rotation, 1};
  } else {
    const Vector2<double> rotation_a = pair.a.pose.rotation.cast<double>();
    return {own::exact_b_in_a(pair), rotation_a, pair.b.pose.rotation.cast<double>(),
            std::sqrt(rotation_a.dot(rotation_a))};
  }
}

template <class Scalar>
KeptPoint kept_point(const methods::CachedPoint<Scalar>& point, const Standing<Scalar>& at) {
  KeptPoint kept{.id = point.id,
                 .born = point.born,
                 .anchor_a = point.anchor_a.template cast<double>(),
                 .anchor_b = point.anchor_b.template cast<double>(),
                 .normal = point.normal.template cast<double>(),
                 .travels_with = TravelsWith::world,
                 .depth = static_cast<double>(point.depth * at.world_per_local)};
  if (point.carrier == Carrier::world) return kept;
  const bool is_of_a = point.carrier == Carrier::a;
  const Vector2<Scalar>& rotation = is_of_a ? at.rotation_a : at.rotation_b;
  const Vector2<Scalar> turned = rotate(rotation, point.normal) / std::sqrt(rotation.dot(rotation));
  kept.travels_with = is_of_a ? TravelsWith::a : TravelsWith::b;
  kept.normal = turned.template cast<double>();
  return kept;
}

/// A share of the smaller shape.
constexpr ShapeLength share_of(ShapeMeasure measure) {
  return {.absolute = 0, .relative = methods::kKeptShare, .measure = measure};
}

/// As it should be in the plane.
struct InPlane {
  static Keeping keeping() {
    constexpr ShapeLength share = share_of(ShapeMeasure::reach);
    return {.gap = share,
            .drift = share,
            .turn = methods::kKeptShare,
            .since = StaleSince::birth,
            .match = share,
            .match_by = MatchBy::either,
            .points_max = 3};
  }

  template <class Scalar, class Detect>
  static void next(PointCache<Scalar>& cache, const PairCase& pair, const Standing<Scalar>& at,
                   const Detect& detect) {
    const ShapeLength reach{.absolute = 0, .relative = 1};
    const auto limits =
        methods::keep_limits(static_cast<Scalar>(reach.of(pair)) / at.world_per_local);
    methods::next_frame(cache, at.b_in_a, limits, detect);
  }
};

/// As Bullet has it.
struct AsBullet {
  static Keeping keeping() {
    constexpr ShapeLength share = share_of(ShapeMeasure::angular_disc);
    return {.gap = share,
            .drift = share,
            .since = StaleSince::birth,
            .match = share,
            .match_by = MatchBy::a,
            .points_max = 4};
  }

  template <class Scalar, class Detect>
  static void next(PointCache<Scalar>& cache, const PairCase& pair, const Standing<Scalar>& at,
                   const Detect& detect) {
    const Scalar threshold = methods::bullet_threshold(polygon_cast<Scalar>(pair.a.polygon),
                                                       polygon_cast<Scalar>(pair.b.polygon));
    methods::next_frame_as_bullet(cache, at.b_in_a, at.rotation_a, threshold / at.world_per_local,
                                  detect);
  }
};

/// What is kept from frame to frame, and what detection leaves to itself.
template <class Scalar>
struct Memory {
  PointCache<Scalar> cache;
  methods::Simplex hint;
};

template <class Scalar>
KeptAnswer as_answer(const PointCache<Scalar>& cache, const Standing<Scalar>& at) {
  KeptManifold manifold;
  for (const auto& point : cache.all()) manifold.points.push_back(kept_point(point, at));
  return manifold;
}

/// What is said of a point at its birth is what the one-point collider says; both anchors are on
/// surfaces.
template <class Way>
SequenceCollider keeper_of(const Declaration& one_point, std::string name,
                           std::string description) {
  SequenceCollider collider;
  collider.declaration = one_point;
  collider.declaration.name = std::move(name);
  collider.declaration.description = std::move(description);
  collider.declaration.points = PointsAt::surface_b;
  collider.keeping = Way::keeping();
  return collider;
}

/// Over GJK in float, whose hint is kept as well.
template <class Way>
SequenceCollider over_gjk(std::string name, std::string description) {
  const Collider gjk = make_gjk();
  SequenceCollider collider =
      keeper_of<Way>(gjk.declaration, std::move(name), std::move(description));
  collider.begin = [] {
    return [memory = Memory<float>()](const PairCase& pair) mutable -> KeptAnswer {
      const Standing<float> at = standing<float>(pair);
      const auto detect = [&]() -> std::optional<DetectedPoint<float>> {
        const ConvexPolygon<float>& a = pair.a.polygon;
        const ConvexPolygon<float>& b = pair.b.polygon;
        const auto found = methods::contact_by_gjk(a, b, at.b_in_a, memory.hint);
        if (found.manifold.count == 0) return std::nullopt;
        return methods::detected_point(a, b, found.manifold);
      };
      Way::next(memory.cache, pair, at, detect);
      return as_answer(memory.cache, at);
    };
  };
  return collider;
}

/// Over any collider of one point, in double.
template <class Way>
SequenceCollider over(const Collider& one_point, std::string name, std::string description) {
  assert(one_point.declaration.claims == Claims::point);
  SequenceCollider collider =
      keeper_of<Way>(one_point.declaration, std::move(name), std::move(description));
  collider.is_isolated = one_point.is_isolated();
  collider.begin = [one_point] {
    return [one_point, cache = PointCache<double>()](const PairCase& pair) mutable -> KeptAnswer {
      const Answer answer = one_point.collide(pair);
      if (const auto* const unsupported = std::get_if<Unsupported>(&answer)) return *unsupported;
      if (const auto* const lost = std::get_if<Lost>(&answer)) return *lost;
      const Standing<double> at = standing<double>(pair);
      Way::next(cache, pair, at,
                [&] { return own::detected(pair, one_point.declaration, answer); });
      return as_answer(cache, at);
    };
  };
  return collider;
}

std::string kept_of(const Collider& one_point) {
  return "points of " + one_point.declaration.name + " kept over frames";
}

}  // namespace

SequenceCollider make_cached() {
  return over_gjk<InPlane>("cached", "points of gjk kept over frames, in float");
}

SequenceCollider make_cached64() {
  return over<InPlane>(make_gjk64(), "cached64", "the same of gjk64, in double");
}

SequenceCollider make_cached_bullet() {
  return over_gjk<AsBullet>("cached-bullet",
                            "points of gjk kept by the rules of Bullet's btPersistentManifold");
}

SequenceCollider cached_over(const Collider& one_point) {
  return over<InPlane>(one_point, "cached+" + one_point.declaration.name, kept_of(one_point));
}

SequenceCollider cached_bullet_over(const Collider& one_point) {
  return over<AsBullet>(one_point, "cached-bullet+" + one_point.declaration.name,
                        kept_of(one_point) + " by Bullet's rules");
}

}  // namespace manifuzz
