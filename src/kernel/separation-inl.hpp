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

template <class D>
struct FaceSeparations {
  hn::Vec<D> separation;
  hn::Vec<DInt<D>> face;

  /// Takes a face that lies farther in front: of equals, the first stays.
  HWY_INLINE void consider(int candidate, hn::Vec<D> candidate_separation) {
    const DInt<D> di;
    const auto is_greater = hn::Gt(candidate_separation, separation);
    separation = hn::IfThenElse(is_greater, candidate_separation, separation);
    face = hn::IfThenElse(hn::RebindMask(di, is_greater), hn::Set(di, candidate), face);
  }
};

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
  const DInt<D> di;
  const auto infinity = hn::Set(d, std::numeric_limits<T>::infinity());
  alignas(64) T most_opposed[kMaxVertices][Strip<D>::kLanes];
  for (int j = 0; j < s.count_max[1]; ++j) hn::Store(hn::Neg(infinity), d, most_opposed[j]);

  BothSeparations<D> both{{hn::Neg(infinity), hn::Zero(di)}, {hn::Neg(infinity), hn::Zero(di)}};
  for (int i = 0; i < s.count_max[0]; ++i) {
    const auto& face = s.corner[0][i];
    const Lanes2<D> origin = load2(d, face[0], face[1]);
    const Lanes2<D> normal = load2(d, face[2], face[3]);
    auto least = infinity;
    for (int j = 0; j < s.count_max[1]; ++j) {
      const auto& other = s.corner[1][j];
      const auto x = hn::Sub(hn::Load(d, other[0]), origin.x);
      const auto y = hn::Sub(hn::Load(d, other[1]), origin.y);
      least = hn::Min(dot(normal.x, normal.y, x, y), least);
      const auto opposed = dot(hn::Load(d, other[2]), hn::Load(d, other[3]), x, y);
      hn::Store(hn::Max(opposed, hn::Load(d, most_opposed[j])), d, most_opposed[j]);
    }
    both.of_a.consider(i, least);
  }
  for (int j = 0; j < s.count_max[1]; ++j) {
    both.of_b.consider(j, hn::Neg(hn::Load(d, most_opposed[j])));
  }
  return both;
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
