#include "unit/sequence/keepers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "methods/cached_points.hpp"
#include "own_colliders/detected.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz::test {
namespace {

using Cache = methods::PointCache<double>;
using Point = methods::CachedPoint<double>;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

class Keeper {
 public:
  Keeper(Mistake mistake, Collider one_point)
      : mistake_(mistake), one_point_(std::move(one_point)) {}

  KeptAnswer next(const PairCase& pair) {
    const Vector2<double> rotation_a = pair.a.pose.rotation.cast<double>();
    length_ = std::sqrt(rotation_a.dot(rotation_a));
    b_in_a_ = own::exact_b_in_a(pair);
    const auto limits = limits_of(pair);
    if (is(Mistake::keeps_nothing)) cache_.count = 0;
    methods::refresh(cache_, b_in_a_, limits);
    if (cache_.frame > 0 && cache_.frame % 3 == 0) drop_one();
    detect(pair, limits);
    methods::reduce(cache_, b_in_a_);
    KeptManifold kept;
    for (const Point& point : cache_.all()) kept.points.push_back(said_of(point, pair));
    for (int id = 100; is(Mistake::too_many) && kept.points.size() < 4; ++id) {
      kept.points.push_back({.id = id, .born = cache_.frame, .normal = {1, 0}});
    }
    ++cache_.frame;
    last_ = kept;
    return kept;
  }

 private:
  bool is(Mistake mistake) const { return mistake_ == mistake; }

  methods::KeepLimits<double> limits_of(const PairCase& pair) const {
    const ShapeLength reach{.absolute = 0, .relative = 1};
    auto limits = methods::keep_limits(reach.of(pair) / length_);
    if (is(Mistake::past_gap)) limits.gap = kUnlimited;
    if (is(Mistake::past_drift)) limits.drift = kUnlimited;
    if (is(Mistake::past_turn)) limits.turn = kUnlimited;
    return limits;
  }

  void detect(const PairCase& pair, const methods::KeepLimits<double>& limits) {
    if (is(Mistake::detects_no_more) && cache_.frame > 0) return;
    if (gives_both_ends() && !is_round(pair)) return detect_ends(pair, limits);
    auto found = own::detected(pair, one_point_.declaration, one_point_.collide(pair));
    if (!found) return;
    const double aside = 0.3 * size(pair) / length_;
    const Vector2<double> tangent = counter_clockwise_quarter(found->normal);
    if (is(Mistake::anchor_aside)) found->on_b += aside * tangent;
    if (is(Mistake::both_aside)) {
      const double far = 10 * (extent(pair) + total_radius(pair)) / length_;
      found->on_a += far * tangent;
      found->on_b += far * tangent;
    }
    auto within = limits;
    if (is(Mistake::new_beside_old)) within.match = 0;
    methods::add(cache_, b_in_a_, within, *found);
  }

  bool gives_both_ends() const {
    return is(Mistake::both_ends) || is(Mistake::one_depth) || is(Mistake::end_aside);
  }

  /// The deeper end last: it takes the other's place where both are near each other.
  void detect_ends(const PairCase& pair, const methods::KeepLimits<double>& limits) {
    auto clip = std::get<Manifold<double>>(clip_.collide(pair));
    auto& [first, second] = clip.points;
    if (clip.count == 2 && first.depth > second.depth) std::swap(first, second);
    for (int i = 0; i < clip.count; ++i) {
      Manifold<double> end = clip;
      end.count = 1;
      end.points[0] = clip.points[i];
      const bool is_shallow = i + 1 < clip.count;
      if (is_shallow && is(Mistake::one_depth)) end.points[0].depth = clip.points[i + 1].depth;
      if (is_shallow && is(Mistake::end_aside)) {
        end.points[0].position += clip.points[i].position - clip.points[i + 1].position;
      }
      methods::add(cache_, b_in_a_, limits, *own::detected(pair, clip_.declaration, end));
      methods::reduce(cache_, b_in_a_);
    }
  }

  /// The deepest of those kept, or the one farthest to a side that is not the deepest.
  void drop_one() {
    if (cache_.count < 2 || !(is(Mistake::drops_deepest) || is(Mistake::drops_end))) return;
    const auto points = cache_.all();
    const auto deepest = std::ranges::max_element(points, {}, &Point::depth);
    int dropped = deepest->id;
    if (is(Mistake::drops_end)) {
      const Vector2<double> along =
          counter_clockwise_quarter(methods::normal_in_a(*deepest, b_in_a_));
      const auto place = [&](const Point& point) { return along.dot(point.anchor_a); };
      const auto [first, last] = std::ranges::minmax_element(points, {}, place);
      dropped = first == deepest ? last->id : first->id;
    }
    methods::keep_if(cache_, [&](const Point& point) { return point.id != dropped; });
  }

  TravelsWith carrier_of(const Point& point) const {
    if (is(Mistake::stale_normal)) return TravelsWith::world;
    const bool is_of_a = point.carrier == methods::Carrier::a;
    return is_of_a != is(Mistake::wrong_carrier) ? TravelsWith::a : TravelsWith::b;
  }

  KeptPoint said_of(const Point& point, const PairCase& pair) {
    const bool is_kept = point.born != cache_.frame;
    const Vector2<double> normal = world_normal(pair, methods::normal_in_a(point, b_in_a_));
    KeptPoint said{.id = point.id,
                   .born = point.born,
                   .anchor_a = point.anchor_a,
                   .anchor_b = point.anchor_b,
                   .normal = normal,
                   .travels_with = carrier_of(point),
                   .depth = point.depth * length_};
    const auto old =
        std::ranges::find_if(last_.points, [&](const KeptPoint& p) { return p.id == point.id; });
    if (is_kept && old != last_.points.end()) {
      if (is(Mistake::stale_depth)) said.depth = old->depth;
      if (is(Mistake::stale_normal)) {
        said.normal = old->normal;
        said.depth =
            local_normal(pair, said.normal).dot(methods::between_anchors(point, b_in_a_)) * length_;
      }
      if (is(Mistake::moves_anchors)) {
        const Vector2<double> to_a = methods::between_anchors(point, b_in_a_);
        const Vector2<double> across =
            to_a - to_a.dot(local_normal(pair, normal)) * local_normal(pair, normal);
        said.anchor_a -= across;
      }
    }
    if (is(Mistake::false_birth)) said.born = cache_.frame;
    if (is(Mistake::born_before) && cache_.frame > 0) said.born = cache_.frame - 1;
    if (is(Mistake::shares_ids)) said.id = 7;
    return said;
  }

  Mistake mistake_;
  Collider one_point_;
  Collider clip_ = make_clip64();
  Cache cache_;
  KeptManifold last_;
  Pose<double> b_in_a_;
  double length_ = 1;
};

}  // namespace

SequenceCollider keeper_with(Mistake mistake) {
  const Collider gjk = make_gjk64();
  SequenceCollider collider = make_cached64();
  collider.declaration.name = "a keeper";
  const std::set ends{Mistake::both_ends, Mistake::one_depth, Mistake::end_aside};
  if (ends.contains(mistake)) {
    collider.declaration.claims = Claims::manifold;
    collider.declaration.clips = true;
  }
  if (mistake == Mistake::keeps_nothing)
    collider.keeping = Keeping{.gap = {}, .drift = {}, .turn = 0, .match = {}};
  collider.begin = [mistake, gjk] {
    return
        [keeper = Keeper(mistake, gjk)](const PairCase& pair) mutable { return keeper.next(pair); };
  };
  return collider;
}

}  // namespace manifuzz::test
