#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/pair_case.hpp"

// Cases and answers as rows of numbers, which a page reads from WebAssembly's memory.

namespace manifuzz::playground {

/// A body: count of vertices, 1 where corners are round or else 0, radius, position x and y, cos,
/// sin, then x and y of kMaxVertices vertices. All are rounded to float.
inline constexpr int kBodyNumbers = 7 + 2 * kMaxVertices;
/// A case: body A, then body B.
inline constexpr int kCaseNumbers = 2 * kBodyNumbers;

/// What is wrong with a case, in a clause that names the body and says what would be right.
std::optional<std::string> defect_of(std::span<const double, kCaseNumbers> numbers);

/// The case, which is free of defects.
PairCase pair_of(std::span<const double, kCaseNumbers> numbers);

/// What there is to show of a case.
struct Told {
  /// In this order; `places` are x and y in the world's directions, seen from A's position, a
  /// feature is its index, and 8 more of a face.
  ///
  ///   way (its place in Way), total radius, separation S, 1 where they touch
  ///   A's then B's: count of faces, then of each separation and deepest vertex; the greatest or -1
  ///   1 where cores are apart, then the nearest places on A and on B, A's and B's feature
  ///   1 where there are features, then 1 where B's face is the reference, its index, the edge's
  ///   the outward normal, the margin of side planes
  ///   the whole edge: two ends, each its place and the reference's and the incident feature
  ///   both side clips: corner, inward, 1 where something is left, two ends as above
  ///   how far either end lies in front of the reference face; 1 where the clip is replaced
  ///   the answers of clip64 and gjk64: 1 where right, magnitude of its error, count of points, 1
  ///     where B's is the reference, normal, then of each of two points: place, depth, A's and B's
  ///     feature
  ///   the curve: least depth, count of normals that have it, each of these, count of samples,
  ///     then of each angle, in radians from 0, and depth
  ///
  /// What stands behind a 0 for "there is none" is there all the same, as zeros.
  std::vector<double> numbers;
  /// The buckets of both answers, each judged alone, a line each.
  std::string buckets;
};

Told tell(const PairCase& pair);

}  // namespace manifuzz::playground
