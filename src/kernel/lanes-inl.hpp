// The vocabulary of the kernels: vectors of pairs, a strip of pairs in memory, and the way between
// its rows and what lies together in memory, shapes and poses in, manifolds out: sixteen bytes of
// each pair at a time, transposed in registers. Included once a target.

#if defined(MANIFUZZ_KERNEL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_LANES_INL
#undef MANIFUZZ_KERNEL_LANES_INL
#else
#define MANIFUZZ_KERNEL_LANES_INL
#endif

#include <bit>
#include <cstring>
#include <hwy/highway.h>

#include "kernel/packed.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using DInt = hn::RebindToSigned<D>;

/// A vector of the plane in every lane.
template <class D>
struct Lanes2 {
  hn::Vec<D> x;
  hn::Vec<D> y;
};

template <class D>
HWY_INLINE hn::Vec<D> dot(const Lanes2<D>& a, const Lanes2<D>& b) {
  return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y));
}

template <class D>
HWY_INLINE Lanes2<D> subtract(const Lanes2<D>& a, const Lanes2<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
}

/// `rotate` of geometry/pose.hpp: by (cos, sin).
template <class D>
HWY_INLINE Lanes2<D> turned(const Lanes2<D>& rotation, const Lanes2<D>& v) {
  return {hn::Sub(hn::Mul(rotation.x, v.x), hn::Mul(rotation.y, v.y)),
          hn::Add(hn::Mul(rotation.y, v.x), hn::Mul(rotation.x, v.y))};
}

/// `there` where the mask says so, else `here`.
template <class D>
HWY_INLINE Lanes2<D> select(hn::Mask<D> mask, const Lanes2<D>& there, const Lanes2<D>& here) {
  return {hn::IfThenElse(mask, there.x, here.x), hn::IfThenElse(mask, there.y, here.y)};
}

/// The corner after this one, counted round.
template <class DI, class VI>
HWY_INLINE VI next_corner(DI di, VI index, VI count) {
  const auto after = hn::Add(index, hn::Set(di, 1));
  return hn::IfThenZeroElse(hn::Eq(after, count), after);
}

/// Some columns of a block, as many as a vector has lanes, with B's polygon in A's frame.
template <class D>
struct Strip {
  using T = hn::TFromD<D>;

  const Row<T>* rows;        ///< the block's
  const Row<T>* corners[2];  ///< A's rows, and B's once placed
  int count_max[2];
  int column;
  const Row<T>* radii = nullptr;  ///< A's and B's, where a shape is round

  HWY_INLINE hn::Vec<D> load(const Row<T>& row) const { return hn::Load(D(), row.column + column); }
  HWY_INLINE Lanes2<D> load2(const Row<T>* row) const { return {load(row[0]), load(row[1])}; }
  HWY_INLINE const Row<T>* corner(int polygon, int index) const {
    return corners[polygon] + kCornerRows * index;
  }
  HWY_INLINE hn::Vec<DInt<D>> count(int polygon) const {
    return hn::ConvertTo(DInt<D>(), load(rows[kCountA + polygon]));
  }
};

/// `act(lane)` of each lane of a mask, one after the other.
template <class D, class Act>
HWY_INLINE void for_each_lane(D d, hn::Mask<D> mask, const Act& act) {
  static_assert(hn::MaxLanes(D()) <= 16);
  std::uint8_t bytes[8] = {};  // Highway asks for eight
  hn::StoreMaskBits(d, mask, bytes);
  for (unsigned bits = bytes[0] | unsigned{bytes[1]} << 8; bits != 0; bits &= bits - 1) {
    act(static_cast<std::size_t>(std::countr_zero(bits)));
  }
}

/// A frame's place in another, or in the world.
template <class D>
struct LanePose {
  Lanes2<D> position;
  Lanes2<D> rotation;  ///< (cos, sin)
};

/// `relative_pose` of geometry/pose.hpp.
template <class D>
HWY_INLINE LanePose<D> relative_pose(const LanePose<D>& a, const LanePose<D>& b) {
  const auto rotate_back = [&](const Lanes2<D>& v) -> Lanes2<D> {
    return {dot(a.rotation, v), hn::Sub(hn::Mul(a.rotation.x, v.y), hn::Mul(a.rotation.y, v.x))};
  };
  return {rotate_back(subtract(b.position, a.position)), rotate_back(b.rotation)};
}

/// `transform` of geometry/pose.hpp.
template <class D>
HWY_INLINE Lanes2<D> transformed(const LanePose<D>& pose, const Lanes2<D>& v) {
  const Lanes2<D> turned_v = turned(pose.rotation, v);
  return {hn::Add(turned_v.x, pose.position.x), hn::Add(turned_v.y, pose.position.y)};
}

/// Puts B's rows into A's frame.
template <class D>
HWY_INLINE void place(D d, const Strip<D>& s, Row<hn::TFromD<D>>* placed) {
  const auto pose = [&](int row) -> LanePose<D> {
    return {s.load2(s.rows + row), s.load2(s.rows + row + 2)};
  };
  const LanePose<D> b_in_a = relative_pose(pose(kPoseA), pose(kPoseB));
  const auto store = [&](const Lanes2<D>& v, Row<hn::TFromD<D>>* row) {
    hn::Store(v.x, d, row[0].column + s.column);
    hn::Store(v.y, d, row[1].column + s.column);
  };
  Row<hn::TFromD<D>>* row = placed;
  for (int j = 0; j < s.count_max[1]; ++j, row += kCornerRows) {
    store(transformed(b_in_a, s.load2(s.corner(1, j))), row);
    store(turned(b_in_a.rotation, s.load2(s.corner(1, j) + 2)), row + 2);
  }
  store(s.load2(placed), row);
}

/// The address itself, of which the compiler does not know that: what lies there is read again
/// rather than kept in registers, of which there are too few.
template <class T>
HWY_INLINE const T* reloaded(const T* address) {
  asm volatile("" : "+r"(address));
  return address;
}

/// How many scalars sixteen bytes hold.
template <class D>
inline constexpr std::size_t kQuad = 16 / sizeof(hn::TFromD<D>);

#if HWY_TARGET == HWY_SCALAR

/// Reads kQuad scalars of the one pair, from `address(0)` on, as that many rows.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void load_rows(D d, const Address& address, V (&rows)[kQuad<D>]) {
  for (std::size_t r = 0; r < kQuad<D>; ++r) rows[r] = hn::LoadU(d, address(0) + r);
}

/// Writes that many rows as kQuad scalars of the one pair, to `address(0)` on, bytes.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void store_rows(D, V (&rows)[kQuad<D>], const Address& address) {
  std::memcpy(address(0), rows, sizeof(rows));
}

#else

/// Sixteen bytes from each of `address(0)`, `address(kQuad)`, ...: a block of 128 bits each.
template <class D, class Address>
HWY_INLINE hn::Vec<D> load_blocks(D d, const Address& address) {
  if constexpr (hn::MaxLanes(D()) == kQuad<D>) {
    return hn::LoadU(d, address(0));
  } else {
    const hn::Half<D> half;
    return hn::Combine(
        d, load_blocks(half, [&](std::size_t i) { return address(i + hn::MaxLanes(half)); }),
        load_blocks(half, address));
  }
}

template <class D, class Address>
HWY_INLINE void store_blocks([[maybe_unused]] D d, hn::Vec<D> v, const Address& address) {
  if constexpr (hn::MaxLanes(D()) == kQuad<D>) {
    const hn::Repartition<std::uint8_t, D> bytes;
    hn::StoreU(hn::BitCast(bytes, v), bytes, address(0));
  } else {
    const hn::Half<D> half;
    store_blocks(half, hn::LowerHalf(half, v), address);
    store_blocks(half, hn::UpperHalf(half, v),
                 [&](std::size_t i) { return address(i + hn::MaxLanes(half)); });
  }
}

/// Transposes the square of scalars in every 128-bit block. It is its own inverse.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void transpose_blocks([[maybe_unused]] D d, V (&rows)[kQuad<D>]) {
  if constexpr (kQuad<D> == 2) {
    const V first = hn::InterleaveLower(d, rows[0], rows[1]);
    rows[1] = hn::InterleaveUpper(d, rows[0], rows[1]);
    rows[0] = first;
  } else {
    const hn::Repartition<double, D> dd;
    const auto lower01 = hn::BitCast(dd, hn::InterleaveLower(d, rows[0], rows[1]));
    const auto upper01 = hn::BitCast(dd, hn::InterleaveUpper(d, rows[0], rows[1]));
    const auto lower23 = hn::BitCast(dd, hn::InterleaveLower(d, rows[2], rows[3]));
    const auto upper23 = hn::BitCast(dd, hn::InterleaveUpper(d, rows[2], rows[3]));
    rows[0] = hn::BitCast(d, hn::InterleaveLower(dd, lower01, lower23));
    rows[1] = hn::BitCast(d, hn::InterleaveUpper(dd, lower01, lower23));
    rows[2] = hn::BitCast(d, hn::InterleaveLower(dd, upper01, upper23));
    rows[3] = hn::BitCast(d, hn::InterleaveUpper(dd, upper01, upper23));
  }
}

/// Reads kQuad scalars of every lane's pair, from `address(lane)` on, as that many rows.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void load_rows(D d, const Address& address, V (&rows)[kQuad<D>]) {
  for (std::size_t r = 0; r < kQuad<D>; ++r) {
    rows[r] = load_blocks(d, [&](std::size_t lane) { return address(lane + r); });
  }
  transpose_blocks(d, rows);
}

/// Writes that many rows as kQuad scalars of every lane's pair, to `address(lane)` on, bytes.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void store_rows(D d, V (&rows)[kQuad<D>], const Address& address) {
  transpose_blocks(d, rows);
  for (std::size_t r = 0; r < kQuad<D>; ++r) {
    store_blocks(d, rows[r], [&](std::size_t lane) { return address(lane + r); });
  }
}

#endif  // HWY_TARGET == HWY_SCALAR

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
