#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/batch.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <bit>
#include <cassert>
#include <hwy/highway.h>

#include "kernel/batch.hpp"
#include "kernel/collide-inl.hpp"
#include "kernel/transpose-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

template <class T>
void collide_packed(const PackedPairs<T>& pairs, T tie_bias, std::span<ManifoldBlock<T>> out) {
  for (std::size_t i = 0; i < pairs.block_count(); ++i) {
    collide_block(pairs.block(i), tie_bias, out[i]);
  }
}

/// Sixteen pairs to be fetched, and where their manifolds go.
template <class T>
struct Group {
  const Placement<T>* body[2][kBlockPairs];
  Manifold<T>* out[kBlockPairs];
};

/// Fetches a shape's corners for every column, two or one at a time, and closes the polygon.
template <class D>
HWY_INLINE void load_corners(D d, const ShapeRows<hn::TFromD<D>>* const* shape, int count_max,
                             Row<hn::TFromD<D>>* rows) {
  constexpr int kQuadScalars = static_cast<int>(kQuad<D>);
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    const auto load = [&](const auto& scalars, int first, int rows_from) {
      hn::Vec<D> quad[kQuad<D>];
      load_rows(
          d, [&](std::size_t lane) { return scalars(shape[column + lane]) + first; }, quad);
      for (int r = 0; r < kQuadScalars; ++r) {
        const int element = first + r;
        auto& row = rows[kCornerRows * (element / 2) + rows_from + element % 2];
        hn::Store(quad[r], d, row.column + column);
      }
    };
    for (int i = 0; i < 2 * count_max; i += kQuadScalars) {
      load([](const auto* of) { return of->vertices.data(); }, i, 0);
      load([](const auto* of) { return of->normals.data(); }, i, 2);
    }
    for (int axis = 0; axis < 2; ++axis) {
      hn::Store(hn::Load(d, rows[axis].column + column), d,
                rows[kCornerRows * count_max + axis].column + column);
    }
  }
}

template <class D>
HWY_INLINE void load_poses(D d, const Placement<hn::TFromD<D>>* const* body,
                           Row<hn::TFromD<D>>* rows) {
  constexpr int kQuadScalars = static_cast<int>(kQuad<D>);
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    for (int i = 0; i < 4; i += kQuadScalars) {
      hn::Vec<D> quad[kQuad<D>];
      load_rows(
          d, [&](std::size_t lane) { return body[column + lane]->pose.position.data() + i; }, quad);
      for (int r = 0; r < kQuadScalars; ++r) hn::Store(quad[r], d, rows[i + r].column + column);
    }
  }
}

/// Lays a group out as a block of pairs, in `rows`.
template <class T>
HWY_INLINE PairBlock<T> load_group(const Shapes<T>& shapes, const Group<T>& group, Row<T>* rows) {
  const hn::CappedTag<T, kBlockPairs> d;
  const ShapeRows<T>* shape[2][kBlockPairs];
  int count_max[2] = {0, 0};
  for (int column = 0; column < kBlockPairs; ++column) {
    T total_radius = 0;
    for (const int p : {0, 1}) {
      const std::uint32_t index = group.body[p][column]->shape;
      const auto count = static_cast<int>(shapes.count(index));
      shape[p][column] = &shapes.rows(index);
      total_radius += shapes.radius(index);
      rows[kCountA + p].column[column] = static_cast<T>(count);
      count_max[p] = std::max(count_max[p], count);
    }
    rows[kTotalRadius].column[column] = total_radius;
  }
  load_poses(d, group.body[0], rows + kPoseA);
  load_poses(d, group.body[1], rows + kPoseB);
  load_corners(d, shape[0], count_max[0], rows + kCorners);
  load_corners(d, shape[1], count_max[1], rows + kCorners + polygon_rows(count_max[0]));
  return {rows, count_max[0], count_max[1]};
}

/// Hands a block's columns out to the group's manifolds.
HWY_INLINE void store_group(const ManifoldBlock<float>& block, const Group<float>& group) {
  static_assert(std::endian::native == std::endian::little);
  static_assert(sizeof(Manifold<float>) == 48 && offsetof(Manifold<float>, normal) == 8 &&
                offsetof(Manifold<float>, points) == 16);
  using D = hn::CappedTag<float, kBlockPairs>;
  const D d;
  const DInt<D> di;
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    const auto from = [&](const Row<float>& row) { return hn::Load(d, row.column + column); };
    const auto from_int = [&](const Row<std::int32_t>& row) {
      return hn::BitCast(d, hn::Load(di, row.column + column));
    };
    const auto to = [&](std::size_t offset) {
      return [&group, column, offset](std::size_t lane) {
        return reinterpret_cast<std::uint8_t*>(group.out[column + lane]) + offset;
      };
    };
    hn::Vec<D> head[4] = {from_int(block.count), from_int(block.reference), from(block.normal[0]),
                          from(block.normal[1])};
    store_rows(d, head, to(0));
    for (const int i : {0, 1}) {
      hn::Vec<D> point[4] = {from(block.position[i][0]), from(block.position[i][1]),
                             from(block.depth[i]), from_int(block.features[i])};
      store_rows(d, point, to(16 + 16 * std::size_t(i)));
    }
  }
}

HWY_INLINE void store_group(const ManifoldBlock<double>& block, const Group<double>& group) {
  for (int column = 0; column < kBlockPairs; ++column) {
    *group.out[column] = manifold(block, column);
  }
}

inline constexpr std::size_t kChunkPairs = 4096;

/// The order of a chunk's pairs in which those of equal vertex counts stand together.
template <class Scalar>
void group_by_counts(const Shapes<Scalar>& shapes, std::span<const Placement<Scalar>> bodies,
                     std::span<const BodyPair> pairs, std::uint16_t* order) {
  constexpr int kCounts = kMaxVertices - kMinVertices + 1;
  std::uint8_t keys[kChunkPairs];
  std::uint32_t begin[kCounts * kCounts + 1] = {};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const unsigned count_a = shapes.count(bodies[pairs[i].a].shape);
    const unsigned count_b = shapes.count(bodies[pairs[i].b].shape);
    keys[i] =
        static_cast<std::uint8_t>((count_a - kMinVertices) * kCounts + count_b - kMinVertices);
    ++begin[keys[i] + 1];
  }
  for (int k = 0; k < kCounts * kCounts; ++k) begin[k + 1] += begin[k];
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    order[begin[keys[i]]++] = static_cast<std::uint16_t>(i);
  }
}

template <class T>
void collide_chunk(const Shapes<T>& shapes, std::span<const Placement<T>> bodies,
                   std::span<const BodyPair> pairs, T tie_bias, Manifold<T>* out) {
  std::uint16_t order[kChunkPairs];
  group_by_counts(shapes, bodies, pairs, order);
  Row<T> rows[kBlockRowsMax];
  ManifoldBlock<T> block{};
  Group<T> group;
  for (std::size_t first = 0; first < pairs.size(); first += kBlockPairs) {
    for (std::size_t column = 0; column < kBlockPairs; ++column) {
      const std::size_t i = order[std::min(first + column, pairs.size() - 1)];
      group.body[0][column] = &bodies[pairs[i].a];
      group.body[1][column] = &bodies[pairs[i].b];
      group.out[column] = out + i;
    }
    collide_block(load_group(shapes, group, rows), tie_bias, block);
    store_group(block, group);
  }
}

template <class Scalar>
void collide_pairs(const Shapes<Scalar>& shapes, std::span<const Placement<Scalar>> bodies,
                   std::span<const BodyPair> pairs, Scalar tie_bias,
                   std::span<Manifold<Scalar>> out) {
  for (std::size_t first = 0; first < pairs.size(); first += kChunkPairs) {
    const std::size_t count = std::min(kChunkPairs, pairs.size() - first);
    collide_chunk(shapes, bodies, pairs.subspan(first, count), tie_bias, out.data() + first);
  }
}

void collide_packed_float(const PackedPairs<float>& pairs, float tie_bias,
                          std::span<ManifoldBlock<float>> out) {
  collide_packed<float>(pairs, tie_bias, out);
}
void collide_packed_double(const PackedPairs<double>& pairs, double tie_bias,
                           std::span<ManifoldBlock<double>> out) {
  collide_packed<double>(pairs, tie_bias, out);
}
void collide_pairs_float(const Shapes<float>& shapes, std::span<const Placement<float>> bodies,
                         std::span<const BodyPair> pairs, float tie_bias,
                         std::span<Manifold<float>> out) {
  collide_pairs<float>(shapes, bodies, pairs, tie_bias, out);
}
void collide_pairs_double(const Shapes<double>& shapes, std::span<const Placement<double>> bodies,
                          std::span<const BodyPair> pairs, double tie_bias,
                          std::span<Manifold<double>> out) {
  collide_pairs<double>(shapes, bodies, pairs, tie_bias, out);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::kernel {

HWY_EXPORT(collide_packed_float);
HWY_EXPORT(collide_packed_double);
HWY_EXPORT(collide_pairs_float);
HWY_EXPORT(collide_pairs_double);

void collide_packed(const PackedPairs<float>& pairs, float tie_bias,
                    std::span<ManifoldBlock<float>> out) {
  assert(out.size() >= pairs.block_count());
  HWY_DYNAMIC_DISPATCH(collide_packed_float)(pairs, tie_bias, out);
}

void collide_packed(const PackedPairs<double>& pairs, double tie_bias,
                    std::span<ManifoldBlock<double>> out) {
  assert(out.size() >= pairs.block_count());
  HWY_DYNAMIC_DISPATCH(collide_packed_double)(pairs, tie_bias, out);
}

void collide_pairs(const Shapes<float>& shapes, std::span<const Placement<float>> bodies,
                   std::span<const BodyPair> pairs, float tie_bias,
                   std::span<Manifold<float>> out) {
  assert(out.size() >= pairs.size());
  HWY_DYNAMIC_DISPATCH(collide_pairs_float)(shapes, bodies, pairs, tie_bias, out);
}

void collide_pairs(const Shapes<double>& shapes, std::span<const Placement<double>> bodies,
                   std::span<const BodyPair> pairs, double tie_bias,
                   std::span<Manifold<double>> out) {
  assert(out.size() >= pairs.size());
  HWY_DYNAMIC_DISPATCH(collide_pairs_double)(shapes, bodies, pairs, tie_bias, out);
}

}  // namespace manifuzz::kernel
#endif
