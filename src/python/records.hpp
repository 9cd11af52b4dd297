#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <span>
#include <string>

#include "geometry/manifold.hpp"
#include "judging/errors/answer_error.hpp"
#include "kernel/packed.hpp"

// What arrays of numpy hold, byte by byte: manifuzz/_arrays.py has the dtypes, which must be these.

namespace manifuzz::python {

/// A shape.
template <class Scalar>
struct ShapeRecord {
  std::array<std::array<Scalar, 2>, kMaxVertices> vertices;  ///< in its own frame; `count` of them
  Scalar radius;                                             ///< a length
  std::int32_t count;                                        ///< of vertices
  Rounding rounding;                                         ///< of corners
};

/// x and y of the position in the world, cos and sin of the rotation.
template <class Scalar>
using PoseRecord = std::array<Scalar, 4>;

/// The poses of a pair's bodies, A's first.
template <class Scalar>
using PosesRecord = std::array<PoseRecord<Scalar>, 2>;

/// By how much an answer differs from the right one nearest to it.
struct PlainErrorRecord {
  double normal;    ///< length of the difference of two unit vectors
  double position;  ///< of points, the largest; a share of the size, or of the bound
  double depth;     ///< of points, the largest; likewise
};

/// What the judge says of an answer. The first bytes are places in lists of words.
struct JudgementRecord {
  std::uint8_t verdict;
  std::uint8_t kind;
  bool touching;
  std::int32_t right_count;
  double separation;
  double depth;
  std::array<double, 2> normal;
  double size;
  double magnitude;
  double bound;
  std::array<double, kComponentNames.size()> errors;
  PlainErrorRecord of_size;
  PlainErrorRecord of_bound;
  Manifold<double> right;
};

static_assert(sizeof(ShapeRecord<float>) == 76 && sizeof(ShapeRecord<double>) == 144);
static_assert(sizeof(kernel::Placement<float>) == 20 && sizeof(kernel::Placement<double>) == 40);
static_assert(sizeof(kernel::BodyPair) == 8);
static_assert(sizeof(Manifold<float>) == 48 && sizeof(Manifold<double>) == 88);
static_assert(sizeof(JudgementRecord) == 8 + 8 * (7 + 6 + 6) + 88);

/// Records that are read where they are, as rows of their bytes.
template <class Record>
using In = nanobind::ndarray<const std::uint8_t, nanobind::shape<-1, sizeof(Record)>,
                             nanobind::c_contig, nanobind::device::cpu>;

/// Records that are written where they are.
template <class Record>
using Out = nanobind::ndarray<std::uint8_t, nanobind::shape<-1, sizeof(Record)>, nanobind::c_contig,
                              nanobind::device::cpu>;

template <class Record>
std::span<const Record> records(const In<Record>& array) {
  return {reinterpret_cast<const Record*>(array.data()), array.shape(0)};
}

template <class Record>
std::span<Record> records(const Out<Record>& array) {
  return {reinterpret_cast<Record*>(array.data()), array.shape(0)};
}

/// Without the interpreter's lock: other threads of Python run meanwhile.
using Unlocked = nanobind::call_guard<nanobind::gil_scoped_release>;

void define_clip(nanobind::module_& module);
void define_batch(nanobind::module_& module);
void define_cases(nanobind::module_& module);
void define_judge(nanobind::module_& module);

}  // namespace manifuzz::python
