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

/// At most sixteen lanes: a block's columns.
template <class Scalar>
using Lanes = hn::CappedTag<Scalar, kBlockPairs>;

/// Gives both polygons as many corners as either has: B's or A's own first one again.
template <class D>
HWY_INLINE void even_out_corners(D d, Strip<D>& s) {
  for (const int p : {0, 1}) {
    for (int k = s.count_max[p]; k < s.corners(); ++k) {
      for (const int axis : {2, 3}) {
        hn::Store(hn::Load(d, s.corner[p][0][axis]), d, s.corner[p][k][axis]);
      }
    }
  }
}

template <class D>
HWY_INLINE void load_packed(D d, const PackedPairs<hn::TFromD<D>>& pairs,
                            const typename PackedPairs<hn::TFromD<D>>::Block& block, int column,
                            Strip<D>& s) {
  const DInt<D> di;
  const auto* row = pairs.rows(block);
  const auto at = [&](int index) { return hn::Load(d, row[index].column + column); };
  for (int i = 0; i < 4; ++i) {
    hn::Store(at(kPoseA + i), d, s.pose[0][i]);
    hn::Store(at(kPoseB + i), d, s.pose[1][i]);
  }
  hn::Store(at(kTotalRadius), d, s.total_radius);
  hn::Store(hn::ConvertTo(di, at(kCountA)), di, s.count[0]);
  hn::Store(hn::ConvertTo(di, at(kCountB)), di, s.count[1]);
  s.count_max[0] = block.count_a;
  s.count_max[1] = block.count_b;
  row += kCorners;
  for (const int p : {0, 1}) {
    for (int k = 0; k < s.count_max[p]; ++k) {
      for (int i = 0; i < kCornerRows; ++i) hn::Store(at(i), d, s.corner[p][k][i]);
      row += kCornerRows;
    }
  }
}

template <class Scalar>
void collide_packed(const PackedPairs<Scalar>& pairs, Scalar tie_bias,
                    std::span<ManifoldBlock<Scalar>> out) {
  const Lanes<Scalar> d;
  Strip<Lanes<Scalar>> strip;
  for (std::size_t i = 0; i < pairs.blocks().size(); ++i) {
    for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
      load_packed(d, pairs, pairs.blocks()[i], column, strip);
      place(d, strip);
      even_out_corners(d, strip);
      collide_strip(d, strip, tie_bias, out[i], column);
    }
  }
}

/// The pairs of one strip, by lane.
template <class Scalar>
struct Group {
  const Placement<Scalar>* body[2][kBlockPairs];
  Manifold<Scalar>* out[kBlockPairs];
};

template <class D>
HWY_INLINE void load_group(D d, const Shapes<hn::TFromD<D>>& shapes,
                           const Group<hn::TFromD<D>>& group, Strip<D>& s) {
  using T = hn::TFromD<D>;
  constexpr int kQuadScalars = static_cast<int>(kQuad<D>);
  hn::Vec<D> rows[kQuad<D>];
  for (const int p : {0, 1}) {
    const Placement<T>* const* const body = group.body[p];
    const ShapeRows<T>* shape[Strip<D>::kLanes];
    s.count_max[p] = 0;
    for (std::size_t lane = 0; lane < Strip<D>::kLanes; ++lane) {
      const std::uint32_t index = body[lane]->shape;
      shape[lane] = &shapes.rows(index);
      const auto count = static_cast<int>(shapes.count(index));
      s.count[p][lane] = count;
      s.count_max[p] = std::max(s.count_max[p], count);
      const T radius = shapes.radius(index);
      s.total_radius[lane] = p == 0 ? radius : s.total_radius[lane] + radius;
    }
    for (int i = 0; i < 4; i += kQuadScalars) {
      load_rows(
          d, [&](std::size_t lane) { return body[lane]->pose.position.data() + i; }, rows);
      for (int r = 0; r < kQuadScalars; ++r) hn::Store(rows[r], d, s.pose[p][i + r]);
    }
    for (int i = 0; i < 2 * s.count_max[p]; i += kQuadScalars) {
      const auto store = [&](int first_element) {
        for (int r = 0; r < kQuadScalars; ++r) {
          hn::Store(rows[r], d, s.corner[p][(i + r) / 2][first_element + (i + r) % 2]);
        }
      };
      load_rows(
          d, [&](std::size_t lane) { return shape[lane]->vertices.data() + i; }, rows);
      store(0);
      load_rows(
          d, [&](std::size_t lane) { return shape[lane]->normals.data() + i; }, rows);
      store(2);
    }
  }
}

/// Hands a block's first columns out to the group's manifolds.
HWY_INLINE void store_group(Lanes<float> d, const ManifoldBlock<float>& block,
                            const Group<float>& group) {
  static_assert(std::endian::native == std::endian::little);
  static_assert(sizeof(Manifold<float>) == 48 && offsetof(Manifold<float>, normal) == 8 &&
                offsetof(Manifold<float>, points) == 16);
  const DInt<Lanes<float>> di;
  const auto from = [&](const Row<float>& row) { return hn::Load(d, row.column); };
  const auto from_int = [&](const Row<std::int32_t>& row) {
    return hn::BitCast(d, hn::Load(di, row.column));
  };
  const auto to = [&](std::size_t offset) {
    return [&group, offset](std::size_t lane) {
      return reinterpret_cast<std::uint8_t*>(group.out[lane]) + offset;
    };
  };
  hn::Vec<Lanes<float>> head[4] = {from_int(block.count), from_int(block.reference),
                                   from(block.normal[0]), from(block.normal[1])};
  store_rows(d, head, to(0));
  for (const int i : {0, 1}) {
    hn::Vec<Lanes<float>> point[4] = {from(block.position[i][0]), from(block.position[i][1]),
                                      from(block.depth[i]), from_int(block.features[i])};
    store_rows(d, point, to(16 + 16 * std::size_t(i)));
  }
}

HWY_INLINE void store_group(Lanes<double>, const ManifoldBlock<double>& block,
                            const Group<double>& group) {
  for (std::size_t lane = 0; lane < Strip<Lanes<double>>::kLanes; ++lane) {
    *group.out[lane] = manifold(block, static_cast<int>(lane));
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

template <class Scalar>
void collide_chunk(const Shapes<Scalar>& shapes, std::span<const Placement<Scalar>> bodies,
                   std::span<const BodyPair> pairs, Scalar tie_bias, Manifold<Scalar>* out) {
  const Lanes<Scalar> d;
  constexpr std::size_t kLanes = Strip<Lanes<Scalar>>::kLanes;
  std::uint16_t order[kChunkPairs];
  group_by_counts(shapes, bodies, pairs, order);
  Strip<Lanes<Scalar>> strip;
  ManifoldBlock<Scalar> block{};
  Group<Scalar> group;
  for (std::size_t first = 0; first < pairs.size(); first += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t i = order[std::min(first + lane, pairs.size() - 1)];
      group.body[0][lane] = &bodies[pairs[i].a];
      group.body[1][lane] = &bodies[pairs[i].b];
      group.out[lane] = out + i;
    }
    load_group(d, shapes, group, strip);
    place(d, strip);
    even_out_corners(d, strip);
    collide_strip(d, strip, tie_bias, block, 0);
    store_group(d, block, group);
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
  assert(out.size() >= pairs.blocks().size());
  HWY_DYNAMIC_DISPATCH(collide_packed_float)(pairs, tie_bias, out);
}

void collide_packed(const PackedPairs<double>& pairs, double tie_bias,
                    std::span<ManifoldBlock<double>> out) {
  assert(out.size() >= pairs.blocks().size());
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
