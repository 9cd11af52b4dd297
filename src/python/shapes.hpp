#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "geometry/convex_polygon.hpp"
#include "geometry/pair_case.hpp"
#include "python/records.hpp"

namespace manifuzz::python {

/// The shape of a record, checked. Throws ValueError that names the array and the index.
template <class Scalar>
ConvexPolygon<Scalar> checked_shape(std::span<const ShapeRecord<Scalar>> shapes, std::size_t index,
                                    std::string_view array);

/// The shape as an array has it.
ShapeRecord<float> record_of(const ConvexPolygon<float>& shape);

template <class Scalar>
Pose<Scalar> pose_of(const PoseRecord<Scalar>& pose) {
  return {{pose[0], pose[1]}, {pose[2], pose[3]}};
}

/// Throws ValueError, naming the array and the index, unless the pose is finite and its rotation
/// unit.
template <class Scalar>
void expect_pose(const Pose<Scalar>& pose, std::string_view array, std::size_t index);

/// The pose of one body of a pair, checked.
template <class Scalar>
Pose<Scalar> checked_pose(std::span<const PosesRecord<Scalar>> poses, std::size_t index, Side side);

/// Puts zeros where nothing is specified, between the fields as well: equal manifolds have equal
/// bytes, whoever made them. Without branches, for no processor foretells which pairs touch, and
/// eight bytes at a time where they are.
template <class Scalar>
void clear_unspecified(Manifold<Scalar>& manifold) {
  using Word = std::uint64_t;
  constexpr std::size_t points = offsetof(Manifold<Scalar>, points) / sizeof(Word);
  constexpr std::size_t of_point = sizeof(ContactPoint<Scalar>) / sizeof(Word);
  constexpr Word all = ~Word{0};
  constexpr Word features = std::is_same_v<Scalar, float> ? all : all >> 32;  // behind the depth
  static_assert(offsetof(Manifold<Scalar>, normal) == sizeof(Word) &&
                std::endian::native == std::endian::little);
  const auto keep = [&manifold](std::size_t index, Word mask) {
    char* const at = reinterpret_cast<char*>(&manifold) + index * sizeof(Word);
    Word word;
    std::memcpy(&word, at, sizeof word);
    word &= mask;
    std::memcpy(at, &word, sizeof word);
  };
  const Word first = manifold.count > 0 ? all : 0;
  const Word second = manifold.count > 1 ? all : 0;
  keep(0, first & 0xff'ffff'ffff);  // the count and the reference
  for (std::size_t i = 1; i < points + of_point; ++i) {
    keep(i, i + 1 < points + of_point ? first : first & features);
  }
  for (std::size_t i = 0; i < of_point; ++i) {
    keep(points + of_point + i, i + 1 < of_point ? second : second & features);
  }
}

}  // namespace manifuzz::python
