// The vocabulary of the kernels: vectors of pairs, and a strip of pairs in memory. Included once a
// target.

#if defined(MANIFUZZ_KERNEL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_LANES_INL
#undef MANIFUZZ_KERNEL_LANES_INL
#else
#define MANIFUZZ_KERNEL_LANES_INL
#endif

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

/// Some columns of a block, as many as a vector has lanes, with B's polygon in A's frame.
template <class D>
struct Strip {
  using T = hn::TFromD<D>;

  const Row<T>* rows;        ///< the block's
  const Row<T>* corners[2];  ///< A's rows, and B's once placed
  int count_max[2];
  int column;

  HWY_INLINE hn::Vec<D> load(const Row<T>& row) const { return hn::Load(D(), row.column + column); }
  HWY_INLINE Lanes2<D> load2(const Row<T>* row) const { return {load(row[0]), load(row[1])}; }
  HWY_INLINE const Row<T>* corner(int polygon, int index) const {
    return corners[polygon] + kCornerRows * index;
  }
  HWY_INLINE hn::Vec<DInt<D>> count(int polygon) const {
    return hn::ConvertTo(DInt<D>(), load(rows[kCountA + polygon]));
  }
};

/// Puts B's rows into A's frame: `relative_pose`, then `transform`.
template <class D>
HWY_INLINE void place(D d, const Strip<D>& s, Row<hn::TFromD<D>>* placed) {
  const Lanes2<D> rotation_a = s.load2(s.rows + kPoseA + 2);
  const auto rotate_back = [&](const Lanes2<D>& v) -> Lanes2<D> {
    return {dot(rotation_a, v), hn::Sub(hn::Mul(rotation_a.x, v.y), hn::Mul(rotation_a.y, v.x))};
  };
  const Lanes2<D> position =
      rotate_back(subtract(s.load2(s.rows + kPoseB), s.load2(s.rows + kPoseA)));
  const Lanes2<D> rotation = rotate_back(s.load2(s.rows + kPoseB + 2));
  const auto store = [&](const Lanes2<D>& v, Row<hn::TFromD<D>>* row) {
    hn::Store(v.x, d, row[0].column + s.column);
    hn::Store(v.y, d, row[1].column + s.column);
  };
  Row<hn::TFromD<D>>* row = placed;
  for (int j = 0; j < s.count_max[1]; ++j, row += kCornerRows) {
    const Lanes2<D> vertex = turned(rotation, s.load2(s.corner(1, j)));
    store({hn::Add(vertex.x, position.x), hn::Add(vertex.y, position.y)}, row);
    store(turned(rotation, s.load2(s.corner(1, j) + 2)), row + 2);
  }
  store(s.load2(placed), row);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
