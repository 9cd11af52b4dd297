#include <algorithm>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include "exact/truth.hpp"
#include "generating/regime.hpp"
#include "kernel/target.hpp"

namespace manifuzz::exact {
namespace {

template <class Check>
void for_all_cases_on_every_target(const Check& check) {
  for (const std::string& target : kernel::targets()) {
    CAPTURE(target);
    kernel::use_target(target);
    for (const Regime& regime : regimes()) {
      CAPTURE(regime.name);
      for (std::uint64_t i = 0; i < 10; ++i) check(generate(1, regime, i));
    }
  }
  kernel::use_target(kernel::targets().front());
}

Vector2<double> turned(const Body& body, const Vector2<double>& v) {
  return rotate<double>(body.pose.rotation.cast<double>(), v);
}

}  // namespace

TEST_CASE("all corners and faces are placed as each is by itself, on every instruction set") {
  for_all_cases_on_every_target([](const PairCase& pair) {
    const RoughPair placed = place_roughly(pair);
    const Vector2<double> apart =
        pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
    for (const Side side : {Side::a, Side::b}) {
      const Body& body = pair[side];
      REQUIRE(placed[side].count == body.polygon.count);
      for (int i = 0; i < body.polygon.count; ++i) {
        const Vector2<double> corner = body.polygon.vertices[i].cast<double>();
        const Vector2<double> edge =
            body.polygon.vertices[body.polygon.next(i)].cast<double>() - corner;
        const Vector2<double> outward = turned(body, clockwise_quarter<double>(edge));
        const Vector2<double> place = turned(body, corner);
        REQUIRE(placed[side].vertices[i] ==
                (side == Side::a ? place : Vector2<double>(place + apart)));
        if (body.polygon.count == 1) {
          REQUIRE(placed[side].normals[i] == Vector2<double>(0, 0));
        } else {
          REQUIRE(placed[side].normals[i] == outward / std::sqrt(outward.dot(outward)));
        }
      }
    }
  });
}

TEST_CASE("all faces separate as each does by itself, on every instruction set") {
  for_all_cases_on_every_target([](const PairCase& pair) {
    const Truth truth(pair);
    const RoughPair placed = place_roughly(pair);
    for (const Side side : {Side::a, Side::b}) {
      double greatest = -std::numeric_limits<double>::infinity();
      for (int i = 0; i < placed[side].face_count(); ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (int j = 0; j < placed[other(side)].count; ++j) {
          const Vector2<double> before = placed[other(side)].vertices[j] - placed[side].vertices[i];
          least = std::min(least, placed[side].normals[i].dot(before));
        }
        REQUIRE(truth.separation(FaceOf{side, i}) == least);
        greatest = std::max(greatest, least);
      }
      REQUIRE(truth.separation(side) == greatest);
    }
  });
}

TEST_CASE("floats separate as what is stored of them in doubles, on every instruction set") {
  for_all_cases_on_every_target([](const PairCase& pair) {
    const Separations of_floats = separations(pair);
    const Separations of_stored = separations(stored(pair), extent(pair));
    REQUIRE(of_floats.extent == of_stored.extent);
    REQUIRE(of_floats.error == of_stored.error);
    REQUIRE(of_floats.greatest == of_stored.greatest);
    REQUIRE(Truth(pair).extent() == extent(pair));
  });
}

TEST_CASE("the size is at least what is known of it without asking for it") {
  for_all_cases_on_every_target([](const PairCase& pair) {
    const Truth truth(pair);
    const double at_least = truth.size_at_least();
    REQUIRE(truth.size() == manifuzz::size(pair));
    REQUIRE((0 <= at_least && at_least <= truth.size()));
    REQUIRE(truth.size_at_least() == truth.size());
  });
}

TEST_CASE("diameters are those of all pairs of vertices, on every instruction set") {
  for_all_cases_on_every_target([](const PairCase& pair) {
    const auto by_itself = [](const ConvexPolygon<float>& polygon) {
      double squared = 0;
      for (int i = 0; i < polygon.count; ++i) {
        for (int j = 0; j < i; ++j) {
          const Vector2<double> d =
              polygon.vertices[i].cast<double>() - polygon.vertices[j].cast<double>();
          squared = std::max(squared, d.dot(d));
        }
      }
      return std::sqrt(squared);
    };
    const double of_a = by_itself(pair.a.polygon);
    const double of_b = by_itself(pair.b.polygon);
    REQUIRE(diameter(pair.a.polygon) == of_a);
    REQUIRE(diameter(pair.b.polygon) == of_b);
    REQUIRE(smaller_diameter(pair.a.polygon, pair.b.polygon) == std::min(of_a, of_b));
  });
}

}  // namespace manifuzz::exact
