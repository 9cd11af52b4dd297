// The manifolds of a block of circles: clipping/circle_contact.hpp, step by step, one pair a lane.

#if defined(MANIFUZZ_KERNEL_CIRCLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_CIRCLES_INL
#undef MANIFUZZ_KERNEL_CIRCLES_INL
#else
#define MANIFUZZ_KERNEL_CIRCLES_INL
#endif

#include "kernel/round-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The manifolds of some columns of circles whose centres stand in A's frame.
template <class D>
HWY_INLINE void collide_circles(D d, const Lanes2<D>& centre_a, const Lanes2<D>& centre_b,
                                hn::Vec<D> radius_a, hn::Vec<D> radius_b, int column,
                                ManifoldBlock<hn::TFromD<D>>& out) {
  const DInt<D> di;
  const Lanes2<D> apart = subtract(centre_b, centre_a);
  const auto total_radius = hn::Add(radius_a, radius_b);
  LaneDirection<D> direction;
  find_direction(d, apart, total_radius, direction);
  const Lanes2<D>& normal = direction.unit;
  const auto separation = dot(normal, apart);
  const auto touches =
      hn::AndNot(hn::Gt(direction.is_beyond, hn::Zero(d)), hn::Le(separation, total_radius));
  const auto depth = hn::Sub(total_radius, separation);
  const auto gap = hn::Min(hn::Sub(total_radius, direction.length), hn::Zero(d));
  hn::Store(flag(di, touches), di, out.count.column + column);
  hn::Store(hn::Set(di, 1), di, out.reference.column + column);
  hn::Store(normal.x, d, out.normal[0].column + column);
  hn::Store(normal.y, d, out.normal[1].column + column);
  hn::Store(hn::Add(centre_a.x, hn::Mul(radius_a, normal.x)), d,
            out.position[0][0].column + column);
  hn::Store(hn::Add(centre_a.y, hn::Mul(radius_a, normal.y)), d,
            out.position[0][1].column + column);
  hn::Store(hn::IfThenElse(touches, depth, gap), d, out.depth[0].column + column);
  hn::Store(hn::Zero(di), di, out.features[0].column + column);  // both centres
}

/// The manifolds of a block of circles, laid out as `CircleRow`s.
template <class T>
HWY_INLINE void collide_circles(const Row<T>* rows, ManifoldBlock<T>& out) {
  using D = hn::CappedTag<T, kBlockPairs>;
  const D d;
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    const Strip<D> s{rows, {rows, rows}, {1, 1}, column};
    const auto pose = [&](int row) -> LanePose<D> {
      return {s.load2(rows + row), s.load2(rows + row + 2)};
    };
    const LanePose<D> b_in_a = relative_pose(pose(kPoseA), pose(kPoseB));
    collide_circles(d, s.load2(rows + kCentreA), transformed(b_in_a, s.load2(rows + kCentreB)),
                    s.load(rows[kRadiusA]), s.load(rows[kRadiusB]), column, out);
  }
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
