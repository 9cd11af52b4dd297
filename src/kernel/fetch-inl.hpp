// A batch of pairs on its way into rows, and its manifolds on their way out. Shapes, poses and
// manifolds lie anywhere in memory.

#if defined(MANIFUZZ_KERNEL_FETCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_FETCH_INL
#undef MANIFUZZ_KERNEL_FETCH_INL
#else
#define MANIFUZZ_KERNEL_FETCH_INL
#endif

#include <algorithm>
#include <bit>

#include "kernel/lanes-inl.hpp"
#include "kernel/pair_stream.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The rows of a batch. Those of the poses stay unwritten: B is placed on the way.
template <class T>
struct BatchRows {
  Row<T> of_block[kCorners];
  Row<T> corners[2][kCornerRows * (kMaxVertices + 1)];  ///< both in A's frame
  Row<T> radii[2];                                      ///< A's and B's
};

/// Reads `kScalars` of every lane's pair, from `address(lane)` on, as that many rows.
template <std::size_t kScalars, class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void load_scalars(D d, const Address& address, V (&rows)[kScalars]) {
  for (std::size_t i = 0; i < kScalars; i += kQuad<D>) {
    V quad[kQuad<D>];
    load_rows(
        d, [&](std::size_t lane) { return address(lane) + i; }, quad);
    for (std::size_t r = 0; r < kQuad<D>; ++r) rows[i + r] = quad[r];
  }
}

/// Reads two corners that follow each other of every lane's shape, from `address(lane)` on.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void load_corners(D d, const Address& address, V (&even)[kCornerScalars],
                             V (&odd)[kCornerScalars]) {
#if HWY_TARGET <= HWY_AVX3
  if constexpr (hn::MaxLanes(D()) == 16) {  // 32 bytes of a shape in one load, not in two
    const hn::Half<D> half;
    V lower[kCornerScalars];
    V upper[kCornerScalars];
    for (std::size_t r = 0; r < kCornerScalars; ++r) {
      const auto both = [&](std::size_t lane) { return hn::LoadU(half, address(lane)); };
      lower[r] = hn::Combine(d, both(r + 8), both(r));
      upper[r] = hn::Combine(d, both(r + 12), both(r + 4));
    }
    transpose_blocks(d, lower);
    transpose_blocks(d, upper);
    for (std::size_t r = 0; r < kCornerScalars; ++r) {
      even[r] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(upper[r]), lower[r]);
      odd[r] = hn::OddEvenBlocks(upper[r], hn::SwapAdjacentBlocks(lower[r]));
    }
    return;
  }
#endif
  load_scalars(d, address, even);
  load_scalars(
      d, [&](std::size_t lane) { return address(lane) + kCornerScalars; }, odd);
}

template <class D, class T = hn::TFromD<D>>
HWY_INLINE void store_corner(D d, const hn::Vec<D> (&corner)[kCornerRows], Row<T>* row,
                             int column) {
  for (int r = 0; r < kCornerRows; ++r) hn::Store(corner[r], d, row[r].column + column);
}

/// Writes a polygon's first vertex behind its last corner.
template <class D, class T>
HWY_INLINE void close_polygon(D d, int count_max, Row<T>* rows, int column) {
  for (const int axis : {0, 1}) {
    hn::Store(hn::Load(d, rows[axis].column + column), d,
              rows[kCornerRows * count_max + axis].column + column);
  }
}

/// Fetches the corners of the A or the B of some columns and closes the polygon. `place` may move
/// what has been fetched of a corner. Two corners are read before either is written: their
/// addresses are read once.
template <class D, class T, class Place>
HWY_INLINE void fetch_corners(D d, const PairBatch<T>& batch, int polygon, int count_max,
                              const Place& place, Row<T>* rows, int column) {
  for (int k = 0; k < count_max; k += 2) {
    const auto* const pair = reloaded(batch.pair + column);
    hn::Vec<D> even[kCornerRows];
    hn::Vec<D> odd[kCornerRows];
    load_corners(
        d, [&](std::size_t lane) { return pair[lane].corners[polygon] + kCornerRows * k; }, even,
        odd);
    place(even);
    place(odd);
    store_corner(d, even, rows + kCornerRows * k, column);
    store_corner(d, odd, rows + kCornerRows * (k + 1), column);
  }
  close_polygon(d, count_max, rows, column);
}

/// Stores the one shape that every pair has: each of its scalars goes to every column.
template <class D, class T, class Place>
HWY_INLINE void spread_corners(D d, const T* corners, int count_max, const Place& place,
                               Row<T>* rows, int column) {
  for (int k = 0; k < count_max; ++k) {
    hn::Vec<D> corner[kCornerRows];
    for (int r = 0; r < kCornerRows; ++r) corner[r] = hn::Set(d, corners[kCornerRows * k + r]);
    place(corner);
    store_corner(d, corner, rows + kCornerRows * k, column);
  }
  close_polygon(d, count_max, rows, column);
}

/// Whether all A's, or all B's, of a full batch have the one shape.
template <class T>
HWY_INLINE bool shares_shape(const PairBatch<T>& batch, int polygon) {
  if (batch.count[polygon] == 0) return false;
  for (int column = 1; column < kBlockPairs; ++column) {
    if (batch.pair[column].corners[polygon] != batch.pair[0].corners[polygon]) return false;
  }
  return true;
}

/// Fetches both polygons and poses for some columns, B's polygon into A's frame. An A that all
/// pairs share is left to `fetch`.
template <class D, class T>
HWY_INLINE void fetch_strip(D d, const PairBatch<T>& batch, const int (&count_max)[2],
                            const bool (&shared)[2], int column, BatchRows<T>& rows) {
  const auto pose = [&](int p) -> LanePose<D> {
    hn::Vec<D> scalars[4];
    load_scalars(
        d,
        [&](std::size_t lane) { return batch.pair[column + lane].body[p]->pose.position.data(); },
        scalars);
    return {{scalars[0], scalars[1]}, {scalars[2], scalars[3]}};
  };
  if (!shared[0]) {
    const auto stay = [](const auto&) {};
    fetch_corners(d, batch, 0, count_max[0], stay, rows.corners[0], column);
  }
  const LanePose<D> b_in_a = relative_pose(pose(0), pose(1));
  const auto place = [&](hn::Vec<D>(&corner)[kCornerRows]) {
    const Lanes2<D> vertex = transformed<D>(b_in_a, {corner[0], corner[1]});
    const Lanes2<D> normal = turned<D>(b_in_a.rotation, {corner[2], corner[3]});
    corner[0] = vertex.x;
    corner[1] = vertex.y;
    corner[2] = normal.x;
    corner[3] = normal.y;
  };
  if (shared[1]) {
    spread_corners(d, batch.pair[0].corners[1], count_max[1], place, rows.corners[1], column);
  } else {
    fetch_corners(d, batch, 1, count_max[1], place, rows.corners[1], column);
  }
}

/// Fetches the radii of both shapes.
template <class T>
HWY_INLINE void fetch_radii(const Shapes<T>& shapes, const PairBatch<T>& batch,
                            const bool (&shared)[2], BatchRows<T>& rows) {
  if (!shapes.has_radius() && batch.kind == PairKind::sharp) {
    for (const int p : {0, 1}) std::fill_n(rows.radii[p].column, kBlockPairs, T{0});
    return;
  }
  const auto radius = [&](int polygon, int column) {
    return shapes.radius(batch.pair[column].body[polygon]->shape);
  };
  for (const int p : {0, 1}) {
    T* const radii = rows.radii[p].column;
    if (shared[p]) {
      std::fill_n(radii, kBlockPairs, radius(p, 0));
    } else {
      for (int column = 0; column < kBlockPairs; ++column) radii[column] = radius(p, column);
    }
  }
}

/// Fetches all that the kernel asks of a batch; `count_max` becomes the most corners of any A and
/// of any B.
template <class T>
HWY_INLINE void fetch(const Shapes<T>& shapes, const PairBatch<T>& batch, BatchRows<T>& rows,
                      int (&count_max)[2]) {
  for (const int p : {0, 1}) {
    count_max[p] = batch.count[p];
    if (count_max[p] > 0) {
      std::fill_n(rows.of_block[kCountA + p].column, kBlockPairs, static_cast<T>(count_max[p]));
      continue;
    }
    for (int column = 0; column < kBlockPairs; ++column) {
      const auto count = static_cast<int>(shapes.count(batch.pair[column].body[p]->shape));
      rows.of_block[kCountA + p].column[column] = static_cast<T>(count);
      count_max[p] = std::max(count_max[p], count);
    }
  }
  const bool shared[2] = {shares_shape(batch, 0), shares_shape(batch, 1)};
  fetch_radii(shapes, batch, shared, rows);
  const hn::CappedTag<T, kBlockPairs> widest;
  const auto lanes = static_cast<int>(hn::Lanes(widest));
  for (int column = 0; shared[0] && column < kBlockPairs; column += lanes) {
    const auto stay = [](const auto&) {};
    spread_corners(widest, batch.pair[0].corners[0], count_max[0], stay, rows.corners[0], column);
  }
  for (int column = 0; column < kBlockPairs; column += lanes) {
    fetch_strip(widest, batch, count_max, shared, column, rows);
  }
  // Last: what was written one by one is slow to be read as a vector right after.
  for (int column = 0; column < kBlockPairs; column += lanes) {
    const auto of = [&](int p) { return hn::Load(widest, rows.radii[p].column + column); };
    const auto sum = hn::Add(hn::Add(hn::Zero(widest), of(0)), of(1));  // of -0 and -0 it is 0
    hn::Store(sum, widest, rows.of_block[kTotalRadius].column + column);
  }
}

/// Hands a block's columns out to the batch's manifolds.
HWY_INLINE void hand_out(const ManifoldBlock<float>& block, const PairBatch<float>& batch) {
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
      return [&batch, column, offset](std::size_t lane) {
        return reinterpret_cast<std::uint8_t*>(batch.pair[column + lane].out) + offset;
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

HWY_INLINE void hand_out(const ManifoldBlock<double>& block, const PairBatch<double>& batch) {
  for (int column = 0; column < kBlockPairs; ++column) {
    *batch.pair[column].out = manifold(block, column);
  }
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
