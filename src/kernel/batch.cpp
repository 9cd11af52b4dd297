#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/batch.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "kernel/batch.hpp"
#include "kernel/collide-inl.hpp"
#include "kernel/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

template <class T>
void collide_packed(const PackedPairs<T>& pairs, T tie_bias, std::span<ManifoldBlock<T>> out) {
  for (std::size_t i = 0; i < pairs.block_count(); ++i) {
    collide_block(pairs.block(i), tie_bias, out[i]);
  }
}

/// The vertex counts of a pair, as one number by which pairs are grouped.
struct CountKey {
  static constexpr int kCounts = kMaxVertices - kMinVertices + 1;
  static constexpr int kKeys = kCounts * kCounts;

  static std::uint8_t of(unsigned count_a, unsigned count_b) {
    return static_cast<std::uint8_t>((count_a - kMinVertices) * kCounts + count_b - kMinVertices);
  }
  static int count_a(std::uint8_t key) { return key / kCounts + kMinVertices; }
  static int count_b(std::uint8_t key) { return key % kCounts + kMinVertices; }
};

/// Sixteen pairs to be fetched, in the order of their keys, and where their manifolds go.
template <class T>
struct Group {
  const Placement<T>* body[2][kBlockPairs];
  Manifold<T>* out[kBlockPairs];
  std::uint8_t key[kBlockPairs];
};

/// Fetches a shape's corners for every column and closes the polygon.
template <class D>
HWY_INLINE void load_corners(D d, const ShapeCorners<hn::TFromD<D>>* const* shape, int count_max,
                             Row<hn::TFromD<D>>* rows) {
  constexpr int kQuadScalars = static_cast<int>(kQuad<D>);
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    const auto store = [&](hn::Vec<D> v, int row) { hn::Store(v, d, rows[row].column + column); };
    for (int i = 0; i < kCornerRows * count_max; i += kQuadScalars) {
      hn::Vec<D> quad[kQuad<D>];
      load_rows(
          d, [&](std::size_t lane) { return shape[column + lane]->scalars.data() + i; }, quad);
      for (int r = 0; r < kQuadScalars; ++r) store(quad[r], i + r);
    }
    for (const int axis : {0, 1}) {
      store(hn::Load(d, rows[axis].column + column), kCornerRows * count_max + axis);
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

/// The rows of both counts; returns the greatest of each.
template <class T>
HWY_INLINE std::array<int, 2> load_counts(const Group<T>& group, Row<T>* rows) {
  std::array<int, 2> count_max{CountKey::count_a(group.key[0]), CountKey::count_b(group.key[0])};
  if (group.key[0] == group.key[kBlockPairs - 1]) {
    for (const int p : {0, 1}) {
      std::fill_n(rows[kCountA + p].column, kBlockPairs, static_cast<T>(count_max[p]));
    }
    return count_max;
  }
  for (int column = 0; column < kBlockPairs; ++column) {
    const std::array<int, 2> count{CountKey::count_a(group.key[column]),
                                   CountKey::count_b(group.key[column])};
    for (const int p : {0, 1}) {
      rows[kCountA + p].column[column] = static_cast<T>(count[p]);
      count_max[p] = std::max(count_max[p], count[p]);
    }
  }
  return count_max;
}

template <class T>
HWY_INLINE void load_radii(const Shapes<T>& shapes, const Group<T>& group, Row<T>& total_radius) {
  if (!shapes.has_radius()) {
    std::fill_n(total_radius.column, kBlockPairs, T{0});
    return;
  }
  for (int column = 0; column < kBlockPairs; ++column) {
    total_radius.column[column] =
        shapes.radius(group.body[0][column]->shape) + shapes.radius(group.body[1][column]->shape);
  }
}

/// Lays a group out as a block of pairs, in `rows`.
template <class T>
HWY_INLINE PairBlock<T> load_group(const Shapes<T>& shapes, const Group<T>& group, Row<T>* rows) {
  const hn::CappedTag<T, kBlockPairs> d;
  const std::array<int, 2> count_max = load_counts(group, rows);
  load_radii(shapes, group, rows[kTotalRadius]);
  Row<T>* corners = rows + kCorners;
  for (const int p : {0, 1}) {
    load_poses(d, group.body[p], rows + (p == 0 ? kPoseA : kPoseB));
    const ShapeCorners<T>* shape[kBlockPairs];
    for (int column = 0; column < kBlockPairs; ++column) {
      shape[column] = &shapes.corners(group.body[p][column]->shape);
    }
    load_corners(d, shape, count_max[p], corners);
    corners += polygon_rows(count_max[p]);
  }
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

/// A chunk's pairs in the order of their keys.
struct Order {
  std::uint16_t pair[kChunkPairs];
  std::uint8_t key[kChunkPairs];  ///< of the pair itself, wherever it stands in the order
};

template <class T>
void group_by_counts(const Shapes<T>& shapes, std::span<const Placement<T>> bodies,
                     std::span<const BodyPair> pairs, Order& order) {
  std::uint32_t begin[CountKey::kKeys + 1] = {};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    order.key[i] = CountKey::of(shapes.count(bodies[pairs[i].a].shape),
                                shapes.count(bodies[pairs[i].b].shape));
    ++begin[order.key[i] + 1];
  }
  for (int k = 0; k < CountKey::kKeys; ++k) begin[k + 1] += begin[k];
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    order.pair[begin[order.key[i]]++] = static_cast<std::uint16_t>(i);
  }
}

/// Fills a group with the chunk's pairs from `first` on in their order, its last pair filling up,
/// and asks for their shapes, which lie anywhere in memory.
template <class T>
HWY_INLINE void assemble(const Shapes<T>& shapes, std::span<const Placement<T>> bodies,
                         std::span<const BodyPair> pairs, const Order& order, std::size_t first,
                         Manifold<T>* out, Group<T>& group) {
  for (std::size_t column = 0; column < kBlockPairs; ++column) {
    const std::size_t i = order.pair[std::min(first + column, pairs.size() - 1)];
    group.body[0][column] = &bodies[pairs[i].a];
    group.body[1][column] = &bodies[pairs[i].b];
    group.out[column] = out + i;
    group.key[column] = order.key[i];
    for (const int p : {0, 1}) {
      const ShapeCorners<T>& corners = shapes.corners(group.body[p][column]->shape);
      hwy::Prefetch(&corners);
      hwy::Prefetch(&corners.scalars[corners.scalars.size() / 2]);
    }
  }
}

template <class T>
void collide_chunk(const Shapes<T>& shapes, std::span<const Placement<T>> bodies,
                   std::span<const BodyPair> pairs, T tie_bias, Manifold<T>* out) {
  Order order;
  group_by_counts(shapes, bodies, pairs, order);
  Row<T> rows[kBlockRowsMax];
  ManifoldBlock<T> block{};
  Group<T> groups[2];  // the next one is assembled while this one's shapes are on their way
  assemble(shapes, bodies, pairs, order, 0, out, groups[0]);
  for (std::size_t first = 0; first < pairs.size(); first += kBlockPairs) {
    const std::size_t number = first / kBlockPairs;
    const Group<T>& group = groups[number % 2];
    const std::size_t next = first + kBlockPairs;
    if (next < pairs.size()) {
      assemble(shapes, bodies, pairs, order, next, out, groups[(number + 1) % 2]);
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
