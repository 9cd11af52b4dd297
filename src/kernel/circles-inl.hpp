// The manifolds of a block of circles: clipping/circle_contact.hpp, step by step, one pair a lane.

#if defined(MANIFUZZ_KERNEL_CIRCLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_CIRCLES_INL
#undef MANIFUZZ_KERNEL_CIRCLES_INL
#else
#define MANIFUZZ_KERNEL_CIRCLES_INL
#endif

#include "kernel/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// As many lanes as a vector of doubles has: squares and roots are taken in double.
template <class T>
using CircleLanes = hn::Rebind<T, hn::CappedTag<double, kBlockPairs>>;

template <class D>
using Wide = hn::Rebind<double, D>;

template <class D>
HWY_INLINE hn::Vec<Wide<D>> widened([[maybe_unused]] D d, hn::Vec<D> v) {
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(double)) {
    return v;
  } else {
    return hn::PromoteTo(Wide<D>(), v);
  }
}

template <class D>
HWY_INLINE hn::Vec<D> narrowed([[maybe_unused]] D d, hn::Vec<Wide<D>> v) {
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(double)) {
    return v;
  } else {
    return hn::DemoteTo(d, v);
  }
}

/// The unit direction of a difference (`clipping::direction_between`), and its length in double;
/// (1, 0) of one so short that it may be subnormal.
template <class D>
HWY_INLINE Lanes2<D> direction_of(D d, const Lanes2<D>& apart, hn::Vec<Wide<D>>& length) {
  using T = hn::TFromD<D>;
  const Wide<D> dw;
  constexpr double shortest =
      static_cast<double>(std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon());
  const Lanes2<Wide<D>> wide{widened(d, apart.x), widened(d, apart.y)};
  length = hn::Sqrt(dot(wide, wide));
  const auto is_short = hn::Lt(length, hn::Set(dw, shortest));
  const auto x = hn::IfThenElse(is_short, hn::Set(dw, 1.0), hn::Div(wide.x, length));
  const auto y = hn::IfThenZeroElse(is_short, hn::Div(wide.y, length));
  return {narrowed(d, x), narrowed(d, y)};
}

/// The lanes whose circles are farther apart than `reach`, by more than rounding
/// (`clipping::are_beyond`).
template <class D>
HWY_INLINE hn::Mask<D> are_beyond(D d, const Lanes2<D>& apart, hn::Vec<D> reach) {
  using T = hn::TFromD<D>;
  const Wide<D> dw;
  constexpr double more = 1 + 8 * static_cast<double>(std::numeric_limits<T>::epsilon());
  const Lanes2<Wide<D>> wide{widened(d, apart.x), widened(d, apart.y)};
  const auto wide_reach = widened(d, reach);
  const auto limit = hn::Mul(hn::Mul(wide_reach, wide_reach), hn::Set(dw, more));
  const auto is_beyond = hn::Gt(dot(wide, wide), limit);
  const auto flags = narrowed(d, hn::IfThenElseZero(is_beyond, hn::Set(dw, 1.0)));
  return hn::Gt(flags, hn::Zero(d));
}

/// The manifolds of a block of circles, laid out as `CircleRow`s.
template <class T>
HWY_INLINE void collide_circles(const Row<T>* rows, ManifoldBlock<T>& out) {
  using D = CircleLanes<T>;
  const D d;
  const hn::RebindToSigned<D> di;
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    const Strip<D> s{rows, {rows, rows}, {1, 1}, column};
    const auto pose = [&](int row) -> LanePose<D> {
      return {s.load2(rows + row), s.load2(rows + row + 2)};
    };
    const Lanes2<D> centre_a = s.load2(rows + kCentreA);
    const LanePose<D> b_in_a = relative_pose(pose(kPoseA), pose(kPoseB));
    const Lanes2<D> apart = subtract(transformed(b_in_a, s.load2(rows + kCentreB)), centre_a);
    const auto radius_a = s.load(rows[kRadiusA]);
    const auto total_radius = hn::Add(radius_a, s.load(rows[kRadiusB]));
    hn::Vec<Wide<D>> length;
    const Lanes2<D> normal = direction_of(d, apart, length);
    const auto separation = dot(normal, apart);
    const auto touches =
        hn::AndNot(are_beyond(d, apart, total_radius), hn::Le(separation, total_radius));
    const auto depth = hn::Sub(total_radius, separation);
    const auto gap = hn::Min(hn::Sub(total_radius, narrowed(d, length)), hn::Zero(d));
    const auto one = hn::Set(di, 1);
    hn::Store(hn::IfThenElseZero(hn::RebindMask(di, touches), one), di, out.count.column + column);
    hn::Store(one, di, out.reference.column + column);
    hn::Store(normal.x, d, out.normal[0].column + column);
    hn::Store(normal.y, d, out.normal[1].column + column);
    hn::Store(hn::Add(centre_a.x, hn::Mul(radius_a, normal.x)), d,
              out.position[0][0].column + column);
    hn::Store(hn::Add(centre_a.y, hn::Mul(radius_a, normal.y)), d,
              out.position[0][1].column + column);
    hn::Store(hn::IfThenElse(touches, depth, gap), d, out.depth[0].column + column);
    hn::Store(hn::Zero(di), di, out.features[0].column + column);  // both centres
  }
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
