#include "geometry/ray.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "base/random.hpp"
#include "exact/placed.hpp"
#include "exact/rational.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"

// A ray's answer against rationals: where its place lies, and that nothing before it is in the
// shape.

using namespace manifuzz;
using exact::Rational;
using Point = exact::Point<Rational>;

namespace {

Point point(const Vector2<float>& v) {
  return {Rational(static_cast<double>(v.x())), Rational(static_cast<double>(v.y()))};
}

Point scaled(const Rational& share, const Point& p) {
  return {share * p.x, share * p.y};
}

Rational cross(const Point& p, const Point& q) {
  return p.x * q.y - p.y * q.x;
}

Rational squared_between(const Point& p, const Point& q) {
  return dot(p - q, p - q);
}

/// The square of how far a point lies from a segment.
Rational squared_from_segment(const Point& p, const Point& from, const Point& to) {
  const Point along = to - from;
  const Rational length = dot(along, along);
  if (length == 0) return squared_between(p, from);
  Rational share = dot(p - from, along) / length;
  if (share < 0) share = 0;
  if (share > 1) share = 1;
  return squared_between(p, from + scaled(share, along));
}

bool cross_each_other(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side = [](const Point& p, const Point& q, const Point& r) {
    return cross(q - p, r - p).sign();
  };
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

/// A shape's core in the world, exactly.
struct Core {
  std::vector<Point> vertices;

  Core(const ConvexPolygon<float>& shape, const Pose<float>& pose) {
    const Point rotation = point(pose.rotation);
    for (const auto& vertex : shape.corners()) {
      const Point v = point(vertex);
      vertices.push_back(
          Point{rotation.x * v.x - rotation.y * v.y, rotation.y * v.x + rotation.x * v.y} +
          point(pose.position));
    }
  }

  const Point& next(std::size_t i) const { return vertices[(i + 1) % vertices.size()]; }

  bool holds(const Point& p) const {
    if (vertices.size() < 3) return false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (cross(next(i) - vertices[i], p - vertices[i]) < 0) return false;
    }
    return true;
  }

  Rational squared_from_outline(const Point& p) const {
    Rational least = squared_between(p, vertices[0]);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      least = std::min(least, squared_from_segment(p, vertices[i], next(i)));
    }
    return least;
  }

  /// The square of how far a segment lies from the core; 0 where they meet.
  Rational squared_from(const Point& from, const Point& to) const {
    if (holds(from) || holds(to)) return 0;
    Rational least = std::min(squared_from_outline(from), squared_from_outline(to));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      least = std::min(least, squared_from_segment(vertices[i], from, to));
      const bool is_segment = !(from.x == to.x && from.y == to.y) && vertices.size() > 1;
      if (is_segment && cross_each_other(from, to, vertices[i], next(i))) return 0;
    }
    return least;
  }
};

/// E of `cast_ray`, and its bound.
double bound_of(const ConvexPolygon<float>& shape, const Pose<float>& pose, const Ray& ray) {
  const Vector2<double> apart = pose.position.cast<double>() - ray.from.cast<double>();
  const Vector2<double> along = ray.along.cast<double>();
  const double extent = std::sqrt(apart.dot(apart)) + std::sqrt(along.dot(along)) + reach(shape) +
                        static_cast<double>(shape.radius);
  return 32 * 0x1p-53 * extent;
}

/// The bound along a face's normal, as a product with the face: no more than that.
Rational margin_of(const Point& face, double bound) {
  return Rational(bound * std::sqrt(static_cast<double>(dot(face, face))) * (1 - 1e-9));
}

/// What is wrong with the answer about a sharp polygon without radius: its place, which is past no
/// face and at one, or that anything before lies deeper than the bound.
std::string sharp_complaint(const Core& core, const Ray& ray, const std::optional<RayHit>& hit,
                            double bound) {
  const Point from = point(ray.from);
  const Point along = point(ray.along);
  Rational enters = 0;
  Rational leaves = 1;
  bool is_missed = false;
  for (std::size_t i = 0; i < core.vertices.size(); ++i) {
    const Point face = core.next(i) - core.vertices[i];
    // Half-planes moved in by the bound: the shape less what may be left out.
    const Rational inside = cross(face, from - core.vertices[i]);
    const Rational speed = cross(face, along);
    const Rational margin = margin_of(face, bound);
    const Rational before = margin - inside;  // above 0: outside of the smaller shape
    if (speed == 0) {
      is_missed = is_missed || before > 0;
    } else if (speed > 0) {
      enters = std::max(enters, Rational(before / speed));
    } else {
      leaves = std::min(leaves, Rational(before / speed));
    }
  }
  is_missed = is_missed || enters > leaves;
  if (!hit) return is_missed ? "" : "goes through the shape and has no hit";
  if (!is_missed && Rational(hit->share) > enters) return "is in the shape before the hit";
  const Point place = from + scaled(Rational(hit->share), along);
  bool is_at_a_face = hit->share == 0;
  for (std::size_t i = 0; i < core.vertices.size(); ++i) {
    const Point face = core.next(i) - core.vertices[i];
    const Rational inside = cross(face, place - core.vertices[i]);
    if (inside < -margin_of(face, bound)) return "the place is past a face";
    is_at_a_face = is_at_a_face || inside <= margin_of(face, bound);
  }
  return is_at_a_face ? "" : "the place is at no face";
}

std::string round_complaint(const Core& core, double radius, const Ray& ray,
                            const std::optional<RayHit>& hit, double bound) {
  const Point from = point(ray.from);
  const Point along = point(ray.along);
  const Rational least = Rational(radius - bound);
  const auto is_clear = [&](const Rational& share) {
    return radius <= bound || core.squared_from(from, from + scaled(share, along)) >= least * least;
  };
  if (!hit) return is_clear(1) ? "" : "goes through the shape and has no hit";
  if (hit->share > 0 && !is_clear(Rational(hit->share))) return "is in the shape before the hit";
  const Point place = from + scaled(Rational(hit->share), along);
  const Rational most = Rational(radius + bound);
  return core.squared_from(place, place) <= most * most ? "" : "the place is outside";
}

Vector2<float> anywhere(Random& random, double within) {
  return Vector2<double>(random.uniform(-within, within), random.uniform(-within, within))
      .cast<float>();
}

/// Anywhere, or through a vertex or the middle of a face, from near or far, in part beside it.
Ray any_ray(Random& random, const ConvexPolygon<float>& shape, const Pose<float>& pose) {
  const double extent = reach(shape) + static_cast<double>(shape.radius);
  Ray ray;
  ray.from = pose.position + anywhere(random, extent * random.magnitude(-1, 6));
  const int vertex = random.integer(0, shape.count - 1);
  const Vector2<float> middle =
      0.5F * (shape.vertices[vertex] + shape.vertices[shape.next(vertex)]);
  const Vector2<float> aim = transform(pose, random.chance(0.5) ? shape.vertices[vertex] : middle);
  ray.along = aim - ray.from + anywhere(random, extent * random.magnitude(-24, 1));
  if (random.chance(0.5)) ray.along *= 2;
  return ray;
}

}  // namespace

TEST_CASE("a ray's place is on the outline within the bound, and nothing before it is inside") {
  int hits = 0;
  for (const auto& regimes : {polygon_regimes(), round_regimes()}) {
    for (const Regime& regime : regimes) {
      CAPTURE(regime.name);
      for (std::uint64_t i = 0; i < 300; ++i) {
        CAPTURE(i);
        const auto& [shape, pose] = generate(17, regime, i).a;
        Random random(i, "rays", 0);
        const Ray ray = any_ray(random, shape, pose);
        const Core core(shape, pose);
        const double bound = bound_of(shape, pose, ray);
        const auto hit = cast_ray(shape, pose, ray);
        hits += hit ? 1 : 0;
        const std::string complaint =
            shape.is_round() || shape.radius > 0
                ? round_complaint(core, static_cast<double>(shape.radius), ray, hit, bound)
                : sharp_complaint(core, ray, hit, bound);
        CHECK(complaint == "");
      }
    }
  }
  CHECK(hits > 2000);
}

TEST_CASE("rays meet the tips of needles within the bound") {
  Random random(3, "needles", 0);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const auto width = static_cast<float>(random.magnitude(-16, -2));
    const std::array<Vector2<float>, 3> corners{{{-1, -width}, {0, 0}, {-1, width}}};
    const auto needle = make_polygon<float>(corners);
    const Pose<float> pose{anywhere(random, 10), {0.6F, 0.8F}};
    Ray ray = any_ray(random, needle, pose);
    ray.along = transform(pose, corners[1]) - ray.from + anywhere(random, 1e-7);
    const auto hit = cast_ray(needle, pose, ray);
    hits += hit ? 1 : 0;
    CHECK(sharp_complaint(Core(needle, pose), ray, hit, bound_of(needle, pose, ray)) == "");
  }
  CHECK(hits > 100);
}

TEST_CASE("rays meet a square, a circle and a capsule where they should") {
  const std::array<Vector2<float>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const auto square = make_polygon<float>(corners);
  const auto circle = make_polygon<float>(std::span(corners).first(1), 0.5F);
  const auto capsule = make_polygon<float>(std::span(corners).first(2), 0.5F);
  const Pose<float> pose{{10, 0}, {1, 0}};
  const auto share = [&](const auto& shape, const Vector2<float>& from,
                         const Vector2<float>& along) {
    const auto hit = cast_ray(shape, pose, {from, along});
    return hit ? hit->share : -1;
  };
  CHECK(share(square, {0, 0}, {18, 0}) == 0.5);
  CHECK(share(square, {0, 0}, {8, 0}) == -1);      // ends before it
  CHECK(share(square, {0, 2}, {18, 0}) == -1);     // passes over it
  CHECK(share(square, {10, 0}, {18, 0}) == 0);     // begins inside
  CHECK(share(square, {12, 0}, {18, 0}) == -1);    // looks away
  CHECK(share(circle, {0, -1}, {17, 0}) == 0.5);   // of centre (9, -1)
  CHECK(share(capsule, {10, 4}, {0, -9}) == 0.5);  // its upper side lies at -0.5
  CHECK(share(capsule, {10, -1}, {0, 0}) == 0);
  const auto segment = make_polygon<float>(std::span(corners).first(2));
  const auto end = cast_ray(segment, {{0, 0}, {1, 0}}, {{-3, -1}, {4, 0}});  // along it
  REQUIRE(end);
  CHECK(end->share == 0.5);
  CHECK(end->normal.x() == -1);
  const auto hit = cast_ray(capsule, pose, {{10, 4}, {0, -9}});
  CHECK(hit->normal.x() == 0);
  CHECK(hit->normal.y() == 1);
}
