#include "generating/in_lanes.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include "base/random.hpp"
#include "generating/regime.hpp"
#include "kernel/target.hpp"

namespace manifuzz {
namespace {

/// For every instruction set of this machine.
template <class Check>
void on_every_target(const Check& check) {
  for (const std::string& target : kernel::targets()) {
    CAPTURE(target);
    kernel::use_target(target);
    check();
  }
  kernel::use_target(kernel::targets().front());
}

template <class Check>
void for_all_cases(int cases, const Check& check) {
  for (const Regime& regime : polygon_regimes()) {
    CAPTURE(regime.name);
    for (int i = 0; i < cases; ++i) check(generate(1, regime, static_cast<std::uint64_t>(i)));
  }
}

/// What `faces_of` computes, a face at a time.
struct Face {
  Vector2<double> normal;
  double offset = 0;
};

Face face_by_itself(const Body& of, int index, const Body& opposing, double sign) {
  const auto turned = [](const Body& body, int i) {
    return rotate<double>(body.pose.rotation.cast<double>(),
                          body.polygon.vertices[i].cast<double>());
  };
  const Vector2<double> corner = turned(of, index);
  const Vector2<double> edge = turned(of, of.polygon.next(index)) - corner;
  const Vector2<double> normal = clockwise_quarter<double>(edge / std::sqrt(edge.dot(edge)));
  double least = std::numeric_limits<double>::infinity();
  for (int j = 0; j < opposing.polygon.count; ++j) {
    least = std::min(least, normal.dot(turned(opposing, j)));
  }
  return {sign * normal, normal.dot(corner) - least};
}

}  // namespace

TEST_CASE("plain normals are those of make_polygon, on every instruction set") {
  on_every_target([] {
    int plain = 0;
    for_all_cases(20, [&](const PairCase& pair) {
      ConvexPolygon<float> polygon = pair.a.polygon;
      const auto expected = make_polygon(polygon.corners(), polygon.radius, polygon.rounding);
      polygon.normals.fill(Vector2<float>(0, 0));
      if (!set_plain_normals(polygon)) return;
      ++plain;
      for (int i = 0; i < polygon.count; ++i) {
        REQUIRE(polygon.normals[i] == expected.normals[i]);
      }
    });
    CHECK(plain > 300);
  });
}

TEST_CASE("no polygon with a defect has plain normals, on every instruction set") {
  on_every_target([] {
    int defects = 0;
    Random random(1, "defects", 0);
    for_all_cases(20, [&](const PairCase& pair) {
      ConvexPolygon<float> polygon = pair.b.polygon;
      const int corner = random.integer(0, polygon.count - 1);
      const int other_corner = random.integer(0, polygon.count - 1);
      std::swap(polygon.vertices[corner], polygon.vertices[other_corner]);
      polygon.vertices[corner].x() *= random.chance(0.5) ? 1.0F : -1.0F;
      if (!find_defect(polygon.corners())) return;
      ++defects;
      REQUIRE_FALSE(set_plain_normals(polygon));
    });
    CHECK(defects > 200);
  });
}

TEST_CASE("of what is no polygon nothing is plain, on every instruction set") {
  on_every_target([] {
    const Vector2<float> ends[] = {{-1, 0}, {1, 0}};
    ConvexPolygon<float> segment = make_polygon<float>(ends, 1);
    CHECK_FALSE(set_plain_normals(segment));
    const Vector2<float> corners[] = {{0, 0}, {1, 0}, {0, 1}};
    ConvexPolygon<float> triangle = make_polygon<float>(corners);
    CHECK(set_plain_normals(triangle));
    triangle.vertices[1].x() = std::numeric_limits<float>::infinity();
    CHECK_FALSE(set_plain_normals(triangle));
    triangle.vertices[1].x() = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(set_plain_normals(triangle));
  });
}

TEST_CASE("outlines are rounded as each coordinate is, on every instruction set") {
  on_every_target([] {
    int plain = 0;
    for_all_cases(20, [&](const PairCase& pair) {
      // Away from floats, and now and then so near to each other that corners fall on one line.
      const auto outline_of = [](const ConvexPolygon<float>& polygon) {
        Outline outline;
        outline.count = polygon.count;
        for (int i = 0; i < polygon.count; ++i) {
          outline.vertices[i] = polygon.vertices[i].cast<double>() / 3;
        }
        return outline;
      };
      const Outline a = outline_of(pair.a.polygon);
      const Outline b = outline_of(pair.b.polygon);
      PairCase rounded = pair;
      const bool are_plain = round_plainly(a, b, rounded);
      plain += are_plain ? 1 : 0;
      for (const Side side : {Side::a, Side::b}) {
        const Outline& outline = side == Side::a ? a : b;
        ConvexPolygon<float> polygon = rounded[side].polygon;
        for (int i = 0; i < outline.count; ++i) {
          REQUIRE(polygon.vertices[i] == Vector2<float>(outline.vertices[i].cast<float>()));
        }
        if (!are_plain) continue;
        REQUIRE(set_plain_normals(polygon));
        REQUIRE(std::equal(polygon.normals.begin(), polygon.normals.begin() + polygon.count,
                           rounded[side].polygon.normals.begin()));
      }
    });
    CHECK(plain > 200);
  });
}

TEST_CASE("all faces at once are what each is by itself, on every instruction set") {
  on_every_target([] {
    for_all_cases(5, [](const PairCase& pair) {
      const Faces faces = faces_of(pair);
      REQUIRE(faces.count() == pair.a.polygon.count + pair.b.polygon.count);
      for (int k = 0; k < faces.count(); ++k) {
        const bool is_a = faces.side(k) == Side::a;
        const Face face = is_a ? face_by_itself(pair.a, k, pair.b, 1)
                               : face_by_itself(pair.b, k - pair.a.polygon.count, pair.a, -1);
        REQUIRE(faces.normal(k) == face.normal);
        REQUIRE(faces.offset(k) == face.offset);
      }
    });
  });
}

TEST_CASE("a pair slides as its faces do, on every instruction set") {
  on_every_target([] {
    Random random(1, "slides", 0);
    for_all_cases(20, [&](const PairCase& pair) {
      const double x = random.uniform(-1, 1);
      const double y = random.uniform(-1, 1);
      const Vector2<double> start(pair.a.pose.position.cast<double>());
      REQUIRE(slide(pair, start, {x, y}, 0) == slide(faces_of(pair), start, {x, y}, 0));
    });
  });
}

TEST_CASE("a slide ends where the last face lets go, on every instruction set") {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Body body;
  body.polygon = make_polygon<float>(corners);
  const Faces faces = faces_of({body, body});
  on_every_target([&] {
    CHECK(slide(faces, {0, 0}, {1, 0}, 0) == Vector2<double>(2, 0));
    CHECK(slide(faces, {0, 0}, {0, -1}, 0.5) == Vector2<double>(0, -2.5));
    CHECK(slide(faces, {-9, 1}, {1, 0}, -0.5) == Vector2<double>(1.5, 1));
    CHECK(slide(faces, {0, 3}, {1, 0}, 0.5) == Vector2<double>(0, 3));     // blocked all along
    CHECK(slide(faces, {-9, 0}, {1, 1}, -1.5) == Vector2<double>(-9, 0));  // beside it
  });
}

TEST_CASE("cases are the same, on every instruction set") {
  std::vector<PairCase> known;
  for_all_cases(10, [&](const PairCase& pair) { known.push_back(pair); });
  on_every_target([&] {
    auto expected = known.begin();
    for_all_cases(10, [&](const PairCase& pair) { REQUIRE(pair == *expected++); });
  });
}

}  // namespace manifuzz
