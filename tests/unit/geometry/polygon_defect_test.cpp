#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "geometry/convex_polygon.hpp"

using namespace manifuzz;

namespace {

using Outline = std::vector<Vector2<float>>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Points in strictly convex position, counter-clockwise.
const Outline kRing = {{12, 0},  {11, 5},   {8, 9},   {4, 12},   {-1, 13}, {-6, 11}, {-9, 7},
                       {-11, 2}, {-11, -3}, {-8, -8}, {-4, -11}, {1, -12}, {6, -10}, {9, -7}};

/// Every step-th of the first `count` points of the ring: a star, if the step is not 1.
Outline star(int count, int step) {
  Outline outline;
  for (int i = 0; i < count; ++i) outline.push_back(kRing[(i * step) % count]);
  return outline;
}

/// The outlines that begin at each of the vertices in turn.
std::vector<Outline> every_start(Outline outline) {
  std::vector<Outline> all;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    all.push_back(outline);
  }
  return all;
}

bool all_have(const Outline& outline, std::optional<PolygonDefect> defect) {
  const auto outlines = every_start(outline);
  return std::all_of(outlines.begin(), outlines.end(),
                     [&](const Outline& o) { return find_defect(o) == defect; });
}

/// The definition, word for word: each face has all other vertices strictly on its left.
bool is_strictly_convex(const Outline& v) {
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (j != i && j != (i + 1) % n && orientation(v[i], v[(i + 1) % n], v[j]) <= 0) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("polygons without a defect") {
  for (int count = kMinVertices; count <= kMaxVertices; ++count) {
    CAPTURE(count);
    CHECK(all_have(star(count, 1), std::nullopt));
  }
  CHECK(all_have({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, std::nullopt));
}

TEST_CASE("too few vertices") {
  CHECK(find_defect({}) == PolygonDefect::too_few);
  CHECK(find_defect(Outline{{0, 0}}) == PolygonDefect::too_few);
  CHECK(find_defect(Outline{{0, 0}, {1, 0}}) == PolygonDefect::too_few);
}

TEST_CASE("too many vertices") {
  const Outline nine(kRing.begin(), kRing.begin() + 9);
  REQUIRE(is_strictly_convex(nine));
  CHECK(find_defect(nine) == PolygonDefect::too_many);
}

TEST_CASE("a vertex that is not finite") {
  for (const float bad : {std::nanf(""), kInfinity, -kInfinity}) {
    CAPTURE(bad);
    CHECK(all_have({{0, 0}, {1, 0}, {bad, 1}}, PolygonDefect::not_finite));
    CHECK(all_have({{0, 0}, {1, 0}, {0, bad}}, PolygonDefect::not_finite));
  }
}

TEST_CASE("a repeated vertex") {
  CHECK(all_have({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, PolygonDefect::repeated_vertex));
  CHECK(all_have({{0, 0}, {1, 0}, {0, 0}, {0, 1}}, PolygonDefect::repeated_vertex));
  CHECK(all_have({{0, 0}, {1, 0}, {1, 1}, {-0.0F, 0}}, PolygonDefect::repeated_vertex));
}

TEST_CASE("clockwise vertices") {
  for (int count = kMinVertices; count <= kMaxVertices; ++count) {
    CAPTURE(count);
    CHECK(all_have(star(count, count - 1), PolygonDefect::clockwise));
  }
}

TEST_CASE("vertices that are not strictly convex") {
  CHECK(all_have({{0, 0}, {1, 0}, {2, 0}}, PolygonDefect::not_strictly_convex));
  CHECK(all_have({{0, 0}, {1, 0}, {2, 0}, {1, 1}}, PolygonDefect::not_strictly_convex));
  CHECK(all_have({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, PolygonDefect::not_strictly_convex));
  CHECK(all_have({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, PolygonDefect::not_strictly_convex));
  CHECK(all_have({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {2, 0.5}}, PolygonDefect::not_strictly_convex));
}

TEST_CASE("vertices that go round more than once") {
  CHECK(all_have(star(5, 2), PolygonDefect::winds_twice));
  CHECK(all_have(star(7, 2), PolygonDefect::winds_twice));
  CHECK(all_have(star(7, 3), PolygonDefect::winds_twice));
  CHECK(all_have(star(8, 3), PolygonDefect::winds_twice));
  CHECK(all_have(star(5, 3), PolygonDefect::clockwise));
}

TEST_CASE("one ulp decides between convex and not") {
  const float above = std::nextafter(1.0F, 2.0F);
  const float below = std::nextafter(1.0F, 0.0F);
  CHECK(all_have({{0, 0}, {2, 0}, {2, 1}, {1, above}, {0, 1}}, std::nullopt));
  CHECK(all_have({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, PolygonDefect::not_strictly_convex));
  CHECK(all_have({{0, 0}, {2, 0}, {2, 1}, {1, below}, {0, 1}}, PolygonDefect::not_strictly_convex));
  CHECK(all_have({{16777212, 0}, {16777216, 0}, {16777214, 1}}, std::nullopt));
  // On a slope whose products are not exact in float.
  const float third = 1.0F / 3.0F;
  const Vector2<float> on_line(0.5F, third / 2);
  REQUIRE(orientation(Vector2<float>(0, 0), Vector2<float>(1, third), on_line) == 0);
  const Vector2<float> right(0.5F, std::nextafter(third / 2, 0.0F));
  const Vector2<float> left(0.5F, std::nextafter(third / 2, 1.0F));
  CHECK(all_have({{0, 0}, right, {1, third}, {0, 1}}, std::nullopt));
  CHECK(all_have({{0, 0}, on_line, {1, third}, {0, 1}}, PolygonDefect::not_strictly_convex));
  CHECK(all_have({{0, 0}, left, {1, third}, {0, 1}}, PolygonDefect::not_strictly_convex));
}

TEST_CASE("the smallest and the largest floats make polygons") {
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  constexpr float huge = std::numeric_limits<float>::max();
  CHECK(all_have({{0, 0}, {tiny, 0}, {0, tiny}}, std::nullopt));
  CHECK(all_have({{-huge, -huge}, {huge, -huge}, {huge, huge}, {-huge, huge}}, std::nullopt));
  CHECK(all_have({{-huge, -huge}, {huge, huge}, {0, tiny}}, std::nullopt));
}

TEST_CASE("no defect is found exactly where the definition of strictly convex holds") {
  std::mt19937 bits(1);
  const auto draw = [&bits](int n) { return static_cast<int>(bits() % static_cast<unsigned>(n)); };
  int wrong = 0;
  int convex = 0;
  int winding = 0;
  for (int n = 0; n < 30000; ++n) {
    const int count = kMinVertices + draw(kMaxVertices - kMinVertices + 1);
    Outline outline;
    if (draw(2) == 0) {  // a subset of the ring as a star, so that many wind and many are convex
      std::set<int> chosen;
      while (static_cast<int>(chosen.size()) < count) {
        chosen.insert(draw(static_cast<int>(kRing.size())));
      }
      const std::vector<int> sorted(chosen.begin(), chosen.end());
      const int step = 1 + draw(count - 1);
      for (int i = 0; i < count; ++i) outline.push_back(kRing[sorted[(i * step) % count]]);
    } else {
      for (int i = 0; i < count; ++i) {
        outline.emplace_back(static_cast<float>(draw(5)), static_cast<float>(draw(5)));
      }
    }
    const auto defect = find_defect(outline);
    if (defect == std::nullopt) ++convex;
    if (defect == PolygonDefect::winds_twice) ++winding;
    if ((defect == std::nullopt) != is_strictly_convex(outline)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(convex > 1500);
  CHECK(winding > 600);
}

TEST_CASE("every defect has a description of its own") {
  std::set<std::string> texts;
  const int count = static_cast<int>(PolygonDefect::radius_not_a_length) + 1;
  for (int i = 0; i < count; ++i) texts.emplace(describe(static_cast<PolygonDefect>(i)));
  CHECK(static_cast<int>(texts.size()) == count);
  CHECK_FALSE(texts.contains(""));
}

TEST_CASE("a circle whose radius is 0 as a float is told what is expected") {
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  const auto tiny = static_cast<float>(1e-60);
  REQUIRE(find_shape_defect(center, tiny) == PolygonDefect::no_radius);
  CHECK(describe(PolygonDefect::no_radius) ==
        "one vertex without a radius: a circle's is above 0 as a float, 1e-45 or more");
}

TEST_CASE("numbers that are not trusted become a shape, or a defect") {
  const auto defect_of = [](const Outline& outline, float radius = 0) {
    return std::get<PolygonDefect>(checked_polygon(outline, radius));
  };
  CHECK(defect_of({}) == PolygonDefect::too_few);
  CHECK(defect_of(star(9, 1)) == PolygonDefect::too_many);
  CHECK(defect_of(Outline(1000, {1, 2})) == PolygonDefect::too_many);
  CHECK(defect_of({{0, 0}, {0, 0}, {1, 0}}) == PolygonDefect::repeated_vertex);
  CHECK(defect_of({{0, 0}, {0, 0}}) == PolygonDefect::repeated_vertex);
  CHECK(defect_of({{0, 0}, {4, 0}, {1, 1}, {0, 4}}) == PolygonDefect::not_strictly_convex);
  CHECK(defect_of({{0, 0}, {0, 1}, {1, 0}}) == PolygonDefect::clockwise);
  CHECK(defect_of({{0, 0}, {std::nanf(""), 1}}) == PolygonDefect::not_finite);
  for (const float radius : {-1.0F, kInfinity, std::nanf("")}) {
    for (const int count : {1, 2, 3, 8}) {
      CHECK(defect_of(star(count, 1), radius) == PolygonDefect::radius_not_a_length);
    }
  }
  const Outline triangle = star(3, 1);
  const auto shape = std::get<ConvexPolygon<float>>(checked_polygon(triangle, 2, Rounding::round));
  CHECK(shape == make_polygon<float>(triangle, 2, Rounding::round));
}

TEST_CASE("a shape of too many vertices or none is not made, and one of equal vertices ends") {
  CHECK_THROWS_AS(make_polygon<float>(Outline{}), std::invalid_argument);
  CHECK_THROWS_AS(make_polygon<float>(star(9, 1)), std::invalid_argument);
  const Outline doubled = {{0, 0}, {0, 0}, {1, 0}};
  CHECK(std::isnan(make_polygon<float>(doubled).normals[0].x()));
  CHECK(std::isnan(unit_direction({0, 0}).x()));
  CHECK(std::isnan(unit_direction({std::nan(""), 1}).x()));
  CHECK(std::isnan(unit_direction({1, kInfinity}).x()));
  CHECK(unit_direction({0, 5e-324}) == Vector2<double>(0, 1));
}
