// The greatest separation over A's faces and over B's, one pair a lane (clipping/separation.hpp).

#if defined(MANIFUZZ_KERNEL_SEPARATION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_SEPARATION_INL
#undef MANIFUZZ_KERNEL_SEPARATION_INL
#else
#define MANIFUZZ_KERNEL_SEPARATION_INL
#endif

#include "kernel/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// An edge of each lane's polygon, with what a contact needs of it. It is carried along while edges
/// are compared: fetching it afterwards by each lane's own index would cost more than that.
template <class D>
struct LaneEdge {
  hn::Vec<DInt<D>> index;
  Lanes2<D> first;
  Lanes2<D> second;
};

template <class D>
HWY_INLINE LaneEdge<D> select(hn::Mask<D> mask, const LaneEdge<D>& there, const LaneEdge<D>& here) {
  return {hn::IfThenElse(hn::RebindMask(DInt<D>(), mask), there.index, here.index),
          select<D>(mask, there.first, here.first), select<D>(mask, there.second, here.second)};
}

template <class D>
struct FaceSeparations {
  hn::Vec<D> separation;
  Lanes2<D> normal;
  LaneEdge<D> edge;
};

template <class D>
HWY_INLINE LaneEdge<D> first_edge(const Strip<D>& s, int polygon) {
  const auto* const corner = s.corner(polygon, 0);
  return {hn::Zero(DInt<D>()), s.load2(corner), s.load2(corner + kCornerRows)};
}

/// Takes face `index` of a polygon where it lies farther in front: of equals, the first stays.
template <class D>
HWY_INLINE void consider(const Strip<D>& s, int polygon, int index, hn::Vec<D> separation,
                         FaceSeparations<D>& greatest) {
  const auto is_greater = hn::Gt(separation, greatest.separation);
  const auto* const corner = s.corner(polygon, index);
  const LaneEdge<D> edge{hn::Set(DInt<D>(), index), s.load2(corner), s.load2(corner + kCornerRows)};
  greatest.separation = hn::IfThenElse(is_greater, separation, greatest.separation);
  greatest.normal = select<D>(is_greater, s.load2(corner + 2), greatest.normal);
  greatest.edge = select<D>(is_greater, edge, greatest.edge);
}

/// What the search starts from: face 0 stays where no separation is greater than -infinity.
template <class D>
HWY_INLINE FaceSeparations<D> first_face(D d, const Strip<D>& s, int polygon) {
  return {hn::Set(d, -std::numeric_limits<hn::TFromD<D>>::infinity()),
          s.load2(s.corner(polygon, 0) + 2), first_edge(s, polygon)};
}

template <class D>
struct BothSeparations {
  FaceSeparations<D> of_a;
  FaceSeparations<D> of_b;
};

/// Both at once: a face of A looks along v_b - v_a, a face of B along its exact opposite, so that
/// each difference serves two faces, and B's separation is minus the greatest product.
template <class D>
HWY_INLINE BothSeparations<D> greatest_separations(D d, const Strip<D>& s) {
  using T = hn::TFromD<D>;
  const auto infinity = hn::Set(d, std::numeric_limits<T>::infinity());
  alignas(64) T most_opposed[kMaxVertices][hn::MaxLanes(D())];
  for (int j = 0; j < s.count_max[1]; ++j) hn::Store(hn::Neg(infinity), d, most_opposed[j]);

  BothSeparations<D> both{first_face(d, s, 0), first_face(d, s, 1)};
  for (int i = 0; i < s.count_max[0]; ++i) {
    const auto* const face = s.corner(0, i);
    const Lanes2<D> origin = s.load2(face);
    const Lanes2<D> normal = s.load2(face + 2);
    auto least = infinity;
    for (int j = 0; j < s.count_max[1]; ++j) {
      const auto* const other = s.corner(1, j);
      const Lanes2<D> between = subtract(s.load2(other), origin);
      least = hn::Min(dot(normal, between), least);
      const auto opposed = dot(s.load2(other + 2), between);
      hn::Store(hn::Max(opposed, hn::Load(d, most_opposed[j])), d, most_opposed[j]);
    }
    consider(s, 0, i, least, both.of_a);
  }
  for (int j = 0; j < s.count_max[1]; ++j) {
    consider(s, 1, j, hn::Neg(hn::Load(d, most_opposed[j])), both.of_b);
  }
  return both;
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
