#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include <catch2/catch.hpp>

#include "judging/ledger.hpp"

// Pairs by hand, and what an entry of the ledger says of an answer to them.

namespace manifuzz::test {

inline Body body_at(std::span<const Vector2<float>> corners, float x, float y, float radius = 0) {
  Body body;
  body.polygon = make_polygon<float>(corners);
  body.polygon.radius = radius;
  if (corners.size() < 3) body.polygon.rounding = Rounding::round;
  body.pose.position = {x, y};
  return body;
}

inline Body square_of_two(float x, float y) {
  const std::array<Vector2<float>, 4> corners{Vector2<float>{-1, -1}, Vector2<float>{1, -1},
                                              Vector2<float>{1, 1}, Vector2<float>{-1, 1}};
  return body_at(corners, x, y);
}

inline Body circle_of_half(float x, float y) {
  const std::array<Vector2<float>, 1> middle{Vector2<float>{0, 0}};
  return body_at(middle, x, y, 0.5F);
}

/// Two squares that overlap by 0.3 along x, and by 1.5 along y.
inline PairCase squares_side_by_side() {
  return {square_of_two(0, 0), square_of_two(1.7F, 0.5F)};
}

inline Body triangle_of(const std::array<Vector2<float>, 3>& corners) {
  return body_at(corners, 0, 0);
}

/// A corner of one is on a corner of the other, and that is all.
inline PairCase triangles_corner_on_corner() {
  return {triangle_of({Vector2<float>{0, 0}, {0, 1}, {-1, 0}}),
          triangle_of({Vector2<float>{0, 0}, {0, -1}, {1, 0}})};
}

/// An answer of one point, in A's frame.
inline Manifold<double> one_point(const Vector2<double>& normal, const Vector2<double>& at,
                                  double depth) {
  Manifold<double> manifold;
  manifold.count = 1;
  manifold.normal = normal;
  manifold.points[0].position = at;
  manifold.points[0].depth = depth;
  return manifold;
}

/// The entry of that id.
inline const LedgerEntry& entry_of(std::string_view id) {
  const auto found = std::ranges::find(ledger(), id, &LedgerEntry::id);
  REQUIRE(found != ledger().end());
  return *found;
}

/// What a predicate says of a manifold.
inline bool explains(bool (*predicate)(const Deviation&), const PairCase& pair,
                     const Manifold<double>& manifold, Kind kind = Kind::inconsistent,
                     ScalarType scalar = ScalarType::float32) {
  Declaration declaration;
  declaration.scalar = scalar;
  declaration.frame = RoundingFrame::world;
  declaration.min_vertices = 1;
  declaration.takes_round = true;
  const Admissible right = admissible(pair, declaration);
  return predicate({right, manifold, kind});
}

/// What the entry of that id says of a manifold.
inline bool explains(std::string_view id, const PairCase& pair, const Manifold<double>& manifold,
                     Kind kind = Kind::inconsistent, ScalarType scalar = ScalarType::float32) {
  return explains(entry_of(id).explains, pair, manifold, kind, scalar);
}

/// What it says of one point.
inline bool is_explained(std::string_view id, const PairCase& pair, const Vector2<double>& normal,
                         double depth, Kind kind = Kind::inconsistent,
                         ScalarType scalar = ScalarType::float32) {
  return explains(id, pair, one_point(normal.normalized(), {0, 0}, depth), kind, scalar);
}

}  // namespace manifuzz::test
