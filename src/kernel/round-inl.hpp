// What lanes need of round shapes: corners by each lane's own index, and directions of differences,
// whose squares and roots are taken in double as the clean code takes them.

#if defined(MANIFUZZ_KERNEL_ROUND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_ROUND_INL
#undef MANIFUZZ_KERNEL_ROUND_INL
#else
#define MANIFUZZ_KERNEL_ROUND_INL
#endif

#include <limits>

#include "kernel/deepest_contact.hpp"
#include "kernel/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// As many lanes as a vector of doubles has.
template <class T>
using NarrowLanes = hn::Rebind<T, hn::CappedTag<double, kBlockPairs>>;

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

/// Lengths below this are those of differences that may be subnormal
/// (`clipping::direction_between`).
template <class T>
inline constexpr T kShortest = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();

/// What the difference of two places says of them.
template <class D>
struct LaneDirection {
  Lanes2<D> unit;        ///< (1, 0) of a difference shorter than `kShortest`
  hn::Vec<D> length;     ///< rounded
  hn::Vec<D> is_beyond;  ///< 1 where it is longer than the reach (`clipping::are_beyond`), else 0
};

template <class D>
HWY_INLINE void find_direction(D d, const Lanes2<D>& apart, hn::Vec<D> reach,
                               LaneDirection<D>& found) {
  using T = hn::TFromD<D>;
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(D()) > hn::MaxLanes(NarrowLanes<T>())) {
    const hn::Half<D> half;
    LaneDirection<hn::Half<D>> lower;
    LaneDirection<hn::Half<D>> upper;
    find_direction(half, {hn::LowerHalf(half, apart.x), hn::LowerHalf(half, apart.y)},
                   hn::LowerHalf(half, reach), lower);
    find_direction(half, {hn::UpperHalf(half, apart.x), hn::UpperHalf(half, apart.y)},
                   hn::UpperHalf(half, reach), upper);
    found.unit.x = hn::Combine(d, upper.unit.x, lower.unit.x);
    found.unit.y = hn::Combine(d, upper.unit.y, lower.unit.y);
    found.length = hn::Combine(d, upper.length, lower.length);
    found.is_beyond = hn::Combine(d, upper.is_beyond, lower.is_beyond);
  } else
#endif
  {
    const Wide<D> dw;
    constexpr double more = 1 + 8 * static_cast<double>(std::numeric_limits<T>::epsilon());
    const Lanes2<Wide<D>> wide{widened(d, apart.x), widened(d, apart.y)};
    const auto wide_reach = widened(d, reach);
    const auto squared = dot(wide, wide);
    const auto length = hn::Sqrt(squared);
    const auto is_short = hn::Lt(length, hn::Set(dw, static_cast<double>(kShortest<T>)));
    const auto limit = hn::Mul(hn::Mul(wide_reach, wide_reach), hn::Set(dw, more));
    const auto one = hn::Set(dw, 1.0);
    found.unit.x = narrowed(d, hn::IfThenElse(is_short, one, hn::Div(wide.x, length)));
    found.unit.y = narrowed(d, hn::IfThenZeroElse(is_short, hn::Div(wide.y, length)));
    found.length = narrowed(d, length);
    found.is_beyond = narrowed(d, hn::IfThenElseZero(hn::Gt(squared, limit), one));
  }
}

/// An outward normal turned by a quarter: along its face, from the first end to the second.
template <class D>
HWY_INLINE Lanes2<D> along_face(const Lanes2<D>& normal) {
  return {hn::Neg(normal.y), normal.x};
}

template <class D>
HWY_INLINE Lanes2<D> opposite(const Lanes2<D>& v) {
  return {hn::Neg(v.x), hn::Neg(v.y)};
}

template <class D>
HWY_INLINE Lanes2<D> scaled(hn::Vec<D> factor, const Lanes2<D>& v) {
  return {hn::Mul(factor, v.x), hn::Mul(factor, v.y)};
}

/// The corner before this one, counted round.
template <class DI, class VI>
HWY_INLINE VI previous_corner(DI di, VI index, VI count) {
  return hn::Sub(hn::IfThenElse(hn::Eq(index, hn::Zero(di)), count, index), hn::Set(di, 1));
}

/// A corner of each lane's polygon, between its neighbours.
template <class D>
struct LaneCorner {
  hn::Vec<DInt<D>> index;
  hn::Vec<DInt<D>> index_before;
  hn::Vec<DInt<D>> index_after;
  Lanes2<D> vertex;
  Lanes2<D> before;         ///< the vertex before
  Lanes2<D> after;          ///< the vertex after
  Lanes2<D> normal;         ///< of the face that begins there
  Lanes2<D> normal_before;  ///< of the face that ends there
};

/// `corner` becomes the corner of each lane's own index.
template <class D>
HWY_INLINE void find_corner(D d, const Strip<D>& s, int polygon, hn::Vec<DInt<D>> index,
                            LaneCorner<D>& corner) {
  const DInt<D> di;
  const auto count = s.count(polygon);
  corner.index = index;
  corner.index_before = previous_corner(di, index, count);
  corner.index_after = next_corner(di, index, count);
  const auto* row = s.corner(polygon, 0);
  corner.vertex = corner.before = s.load2(row);
  corner.normal = corner.normal_before = s.load2(row + 2);
  corner.after = s.load2(row + kCornerRows);
  for (int k = 1; k < s.count_max[polygon]; ++k) {
    row += kCornerRows;
    const auto is_it = hn::RebindMask(d, hn::Eq(index, hn::Set(di, k)));
    const auto is_before = hn::RebindMask(d, hn::Eq(corner.index_before, hn::Set(di, k)));
    const Lanes2<D> vertex = s.load2(row);
    const Lanes2<D> normal = s.load2(row + 2);
    corner.vertex = select<D>(is_it, vertex, corner.vertex);
    corner.normal = select<D>(is_it, normal, corner.normal);
    corner.after = select<D>(is_it, s.load2(row + kCornerRows), corner.after);
    corner.before = select<D>(is_before, vertex, corner.before);
    corner.normal_before = select<D>(is_before, normal, corner.normal_before);
  }
}

/// Whether a direction is among a corner's outward normals (`clipping::is_normal_at`).
template <class D>
HWY_INLINE hn::Mask<D> is_normal_at(D d, const LaneCorner<D>& corner, const Lanes2<D>& direction) {
  const auto zero = hn::Zero(d);
  return hn::And(hn::Le(dot(direction, along_face(corner.normal)), zero),
                 hn::Ge(dot(direction, along_face(corner.normal_before)), zero));
}

/// Whether a point lies between the ends of a face (`clipping::is_before_face`).
template <class D>
HWY_INLINE hn::Mask<D> is_before_face(D d, const Lanes2<D>& first, const Lanes2<D>& second,
                                      const Lanes2<D>& normal, const Lanes2<D>& point) {
  const auto zero = hn::Zero(d);
  const Lanes2<D> along = along_face(normal);
  return hn::And(hn::Gt(dot(along, subtract(point, first)), zero),
                 hn::Gt(dot(along, subtract(second, point)), zero));
}

/// 1 where the mask says so, else 0.
template <class DI, class M>
HWY_INLINE hn::Vec<DI> flag(DI di, M mask) {
  return hn::IfThenElseZero(hn::RebindMask(di, mask), hn::Set(di, 1));
}

/// `put_on_surface` of clipping/curved_shapes.hpp: how far an incident point moves along the
/// normal, by A's radius, or by minus B's where A has the reference.
template <class D>
HWY_INLINE hn::Vec<D> towards_b(const Strip<D>& s, hn::Mask<D> reference_is_a) {
  return hn::IfThenElse(reference_is_a, hn::Neg(s.load(s.radii[1])), s.load(s.radii[0]));
}

/// The columns that lanes leave to the clean code, one by one.
template <class D>
HWY_NOINLINE void collide_left(D d, const Strip<D>& s, hn::Mask<D> left, hn::TFromD<D> tie_bias,
                               ManifoldBlock<hn::TFromD<D>>& out) {
  using T = hn::TFromD<D>;
  for_each_lane(d, left, [&](std::size_t lane) {
    const int column = s.column + static_cast<int>(lane);
    const auto at = [&](const Row<T>& row) { return row.column[column]; };
    put(collide_round_column<T>(
            {{s.corners[0], s.corners[1]},
             column,
             {static_cast<int>(at(s.rows[kCountA])), static_cast<int>(at(s.rows[kCountB]))},
             {at(s.radii[0]), at(s.radii[1])}},
            tie_bias),
        out, column);
  });
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
