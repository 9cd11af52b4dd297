// Reference, incident and the three clips, one pair a lane (clipping/features.hpp, clip.hpp).

#if defined(MANIFUZZ_KERNEL_CLIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_CLIP_INL
#undef MANIFUZZ_KERNEL_CLIP_INL
#else
#define MANIFUZZ_KERNEL_CLIP_INL
#endif

#include "kernel/separation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The edge of each lane's incident polygon whose normal is most opposed, the first of equals.
template <class D>
HWY_INLINE hn::Vec<DInt<D>> incident_edges(D d, const Strip<D>& s, hn::Mask<D> incident_is_a,
                                           const Lanes2<D>& normal) {
  const DInt<D> di;
  auto least = hn::Set(d, std::numeric_limits<hn::TFromD<D>>::infinity());
  auto incident = hn::Zero(di);
  for (int k = 0; k < s.corners(); ++k) {
    const auto normal_of = [&](int axis) {
      return hn::IfThenElse(incident_is_a, hn::Load(d, s.corner[0][k][2 + axis]),
                            hn::Load(d, s.corner[1][k][2 + axis]));
    };
    const auto product = dot(normal.x, normal.y, normal_of(0), normal_of(1));
    const auto is_less = hn::Lt(product, least);
    least = hn::IfThenElse(is_less, product, least);
    incident = hn::IfThenElse(hn::RebindMask(di, is_less), hn::Set(di, k), incident);
  }
  return incident;
}

/// Corners of both polygons, fetched by each lane's own indices.
template <class D>
class CornerFetch {
 public:
  HWY_INLINE CornerFetch(D d, const Strip<D>& s) : d_(d), corners_(s.corner[0][0][0]) {}

  /// Where corner `index` of polygon A (0) or B (1) stands.
  HWY_INLINE hn::Vec<DInt<D>> at(hn::Vec<DInt<D>> polygon, hn::Vec<DInt<D>> index) const {
    const DInt<D> di;
    const auto corner = hn::Add(hn::ShiftLeft<3>(polygon), index);
    constexpr int kShift = hwy::CeilLog2(4 * Strip<D>::kLanes);
    return hn::Add(hn::ShiftLeft<kShift>(corner), hn::Iota(di, 0));
  }
  HWY_INLINE Lanes2<D> vertex(hn::Vec<DInt<D>> place) const { return fetch(place, 0); }
  HWY_INLINE Lanes2<D> normal(hn::Vec<DInt<D>> place) const { return fetch(place, 2); }

 private:
  HWY_INLINE Lanes2<D> fetch(hn::Vec<DInt<D>> place, int element) const {
    const auto* const base = corners_ + element * Strip<D>::kLanes;
    return {hn::GatherIndex(d_, base, place), hn::GatherIndex(d_, base + Strip<D>::kLanes, place)};
  }

  D d_;
  const hn::TFromD<D>* corners_;
};

/// An end of the incident edge; its features as a `FeaturePair`'s bytes, the reference's first.
template <class D>
struct ClipEnds {
  Lanes2<D> position;
  hn::Vec<DInt<D>> features;
};

inline constexpr int kFace = 1;  // `Feature::Kind`'s values; a vertex is 0

/// One clip (clipping/clip.hpp): `offset` of both ends from the plane. Lanes whose edge is left
/// without a point are taken out of `kept`.
template <class D>
HWY_INLINE void clip(D d, ClipEnds<D> (&edge)[2], hn::Vec<D> offset0, hn::Vec<D> offset1,
                     hn::Vec<DInt<D>> crossing_features, hn::Mask<D>& kept) {
  const DInt<D> di;
  const auto zero = hn::Zero(d);
  const auto is_whole = hn::And(hn::Ge(offset0, zero), hn::Ge(offset1, zero));
  const auto is_gone = hn::And(hn::Le(offset0, zero), hn::Le(offset1, zero));
  kept = hn::And(kept, hn::Or(is_whole, hn::Not(is_gone)));
  const auto share = hn::Div(offset0, hn::Sub(offset0, offset1));
  const auto crossing = [&](auto from, auto to) {
    return hn::Add(from, hn::Mul(share, hn::Sub(to, from)));
  };
  const Lanes2<D> at{crossing(edge[0].position.x, edge[1].position.x),
                     crossing(edge[0].position.y, edge[1].position.y)};
  const auto is_first = hn::Lt(offset0, zero);
  const auto replace = [&](ClipEnds<D>& end, auto where) {
    end.position.x = hn::IfThenElse(where, at.x, end.position.x);
    end.position.y = hn::IfThenElse(where, at.y, end.position.y);
    end.features = hn::IfThenElse(hn::RebindMask(di, where), crossing_features, end.features);
  };
  replace(edge[0], hn::AndNot(is_whole, is_first));
  replace(edge[1], hn::Not(hn::Or(is_whole, is_first)));
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
