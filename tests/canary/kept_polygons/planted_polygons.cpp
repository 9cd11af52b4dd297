// Copied with the bugs planted into a keeper of polygons, and compiled under a namespace of theirs.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "canary/kept_polygons/polygon_bugs.hpp"
#include "methods/cached_points.hpp"
#include "own_colliders/detected.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

using methods::Carrier;
using methods::DetectedPoint;
using Point = methods::CachedPoint<double>;

constexpr int kPointsMax = 3;

/// How the bodies stand in a frame, and the limits of what is kept.
struct Place {
  PairCase pair;
  Pose<double> b_in_a;
  double world_per_local = 1;  ///< the world's length of one of A's frame
  methods::KeepLimits<double> limits;
};

Place place_of(const PairCase& pair) {
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  const double length = std::sqrt(rotation.dot(rotation));
  const double of_a = reach(pair.a.polygon) + static_cast<double>(pair.a.polygon.radius);
  const double of_b = reach(pair.b.polygon) + static_cast<double>(pair.b.polygon.radius);
  const double smaller = std::min(of_a, of_b);
  return {pair, own::exact_b_in_a(pair), length, methods::keep_limits(smaller / length)};
}

/// A point of a clip, which is on the incident core, on both surfaces.
DetectedPoint<double> on_surfaces(const Place& at, const Manifold<double>& clip, int index) {
  const Vector2<double> normal = clip.normal / at.world_per_local;
  const auto radius_a = static_cast<double>(at.pair.a.polygon.radius);
  const auto radius_b = static_cast<double>(at.pair.b.polygon.radius);
  const double depth = clip.points[index].depth;
  const Vector2<double>& place = clip.points[index].position;
  const bool is_of_a = clip.reference == Side::a;
  const Vector2<double> on_b = is_of_a ? Vector2<double>(place - radius_b * normal)
                                       : Vector2<double>(place + (radius_a - depth) * normal);
  return {clip.normal, on_b + depth * normal, on_b, clip.reference};
}

double apart(const Point& p, const Point& q) {
  const double on_a = (p.anchor_a - q.anchor_a).norm();
  const double on_b = (p.anchor_b - q.anchor_b).norm();
  return std::min(on_a, on_b);
}

class Keeper {
 public:
  KeptAnswer next(const PairCase& pair) {
    const Place at = place_of(pair);
    refresh(at);
    detect(at);
    reduce(at);
    KeptManifold kept;
    for (const Point& point : points_) kept.points.push_back(said_of(point, at));
    last_ = at;
    ++frame_;
    return kept;
  }

 private:
  void refresh(const Place& at) {
    for (Point& point : points_) measure(point, at);
    std::erase_if(points_, [&](const Point& point) { return !is_fresh(point, at); });
  }

  void measure(Point& point, const Place& at) const {
    const Vector2<double> to_a = methods::between_anchors(point, at.b_in_a);
    point.depth = methods::normal_in_a(point, at.b_in_a).dot(to_a);
  }

  bool is_fresh(const Point& point, const Place& at) const {
    const Vector2<double> normal = methods::normal_in_a(point, at.b_in_a);
    const double drift = std::abs(cross(normal, methods::between_anchors(point, at.b_in_a)));
    const double turn = methods::turn_since_birth(point, at.b_in_a);
    return -point.depth <= at.limits.gap && drift <= at.limits.drift && turn <= at.limits.turn;
  }

  void detect(const Place& at) {
    const auto clip = std::get<Manifold<double>>(clip_.collide(at.pair));
    const std::size_t old_count = points_.size();
    std::vector<bool> is_taken(old_count, false);
    for (int i = 0; i < clip.count; ++i) {
      Point born = born_of(on_surfaces(at, clip, i), at);
      const std::size_t matched = match_of(born, at, is_taken);
      const bool has_match = matched < old_count;
      born.id = has_match ? points_[matched].id : next_id_++;
      if (!has_match) {
        points_.push_back(born);
        continue;
      }
      points_[matched] = born;
      is_taken[matched] = true;
    }
  }

  Point born_of(const DetectedPoint<double>& found, const Place& at) const {
    const auto in_b = [&](const Vector2<double>& v) {
      return rotate_inverse(at.b_in_a.rotation, v);
    };
    Point point;
    point.born = frame_;
    point.anchor_a = found.on_a;
    point.anchor_b = in_b(found.on_b - at.b_in_a.position);
    point.normal = found.normal;
    if (found.carrier == Side::b) {
      point.carrier = Carrier::b;
      const Vector2<double> turned = in_b(found.normal);
      point.normal = turned / turned.norm();
    }
    point.rotation_b = at.b_in_a.rotation;
    measure(point, at);
    return point;
  }

  /// The nearest of the old points whose place the new one takes; past the last of them for none.
  std::size_t match_of(const Point& born, const Place& at, const std::vector<bool>& taken) const {
    std::size_t matched = taken.size();
    double least = at.limits.match;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      const double distance = apart(points_[i], born);
      if (taken[i] || distance > least) continue;
      least = distance;
      matched = i;
    }
    return matched;
  }

  /// The deepest stays, and what is farthest to either side.
  void reduce(const Place& at) {
    if (points_.size() < 3) return;
    const auto rank = [](const Point& point) { return std::pair(point.depth, point.born); };
    const Point deepest = *std::ranges::max_element(points_, {}, rank);
    const Vector2<double> along =
        counter_clockwise_quarter(methods::normal_in_a(deepest, at.b_in_a));
    const auto place = [&](const Point& point) { return along.dot(point.anchor_a); };
    const int first = std::ranges::min_element(points_, {}, place)->id;
    const int last = std::ranges::max_element(points_, {}, place)->id;
    std::erase_if(points_, [&](const Point& point) {
      return point.id != deepest.id && point.id != first && point.id != last;
    });
  }

  KeptPoint said_of(const Point& point, const Place& at) const {
    const bool is_of_b = point.carrier == Carrier::b;
    const PairCase& pair = at.pair;
    const Vector2<double> in_a = methods::normal_in_a(point, at.b_in_a);
    KeptPoint said{.id = point.id,
                   .born = point.born,
                   .anchor_a = point.anchor_a,
                   .anchor_b = point.anchor_b,
                   .normal = world_normal(pair, in_a),
                   .travels_with = is_of_b ? TravelsWith::b : TravelsWith::a,
                   .depth = point.depth * at.world_per_local};
    return said;
  }

  Collider clip_ = make_clip64();
  std::vector<Point> points_;
  std::optional<Place> last_;  ///< of the frame before
  int frame_ = 0;
  int next_id_ = 0;
};

SequenceCollider keeper_of_polygons() {
  constexpr ShapeLength share{.absolute = 0, .relative = methods::kKeptShare};
  SequenceCollider keeper;
  keeper.declaration = make_clip64().declaration;
  keeper.declaration.name = "a keeper of polygons";
  keeper.declaration.min_vertices = kMinVertices;
  keeper.declaration.takes_round = false;
  keeper.keeping = {.gap = share,
                    .drift = share,
                    .turn = methods::kKeptShare,
                    .match = share,
                    .match_by = MatchBy::either,
                    .points_max = kPointsMax};
  keeper.begin = [] {
    return [memory = Keeper()](const PairCase& pair) mutable { return memory.next(pair); };
  };
  return keeper;
}

[[maybe_unused]] const bool planted =
    canary::add_polygon_keepers({PLANTED_BUGS}, keeper_of_polygons);

}  // namespace
}  // namespace manifuzz
