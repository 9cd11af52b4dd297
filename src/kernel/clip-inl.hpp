// One pair a lane: the greatest separation over A's faces and over B's (clipping/separation.hpp),
// reference, incident and the three clips (clipping/features.hpp, clip.hpp).

#if defined(MANIFUZZ_KERNEL_CLIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_CLIP_INL
#undef MANIFUZZ_KERNEL_CLIP_INL
#else
#define MANIFUZZ_KERNEL_CLIP_INL
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
HWY_INLINE LaneEdge<D> first_edge(const Strip<D>& s, int polygon) {
  const auto* const corner = s.corner(polygon, 0);
  return {hn::Zero(DInt<D>()), s.load2(corner), s.load2(corner + kCornerRows)};
}

/// A face of each lane, its edge and its outward normal.
template <class D>
struct LaneFace {
  LaneEdge<D> edge;
  Lanes2<D> normal;
};

/// Takes face `index` of a polygon in some lanes.
template <class D>
HWY_INLINE void take(const Strip<D>& s, int polygon, int index, hn::Mask<D> where,
                     LaneFace<D>& face) {
  const auto* const corner = s.corner(polygon, index);
  const LaneEdge<D> edge{hn::Set(DInt<D>(), index), s.load2(corner), s.load2(corner + kCornerRows)};
  face.normal = select<D>(where, s.load2(corner + 2), face.normal);
  face.edge = select<D>(where, edge, face.edge);
}

/// Takes face `index` of a polygon where it lies farther in front: of equals, the first stays.
template <class D>
HWY_INLINE void consider(const Strip<D>& s, int polygon, int index, hn::Vec<D> separation,
                         hn::Vec<D>& greatest, LaneFace<D>& face) {
  const auto is_greater = hn::Gt(separation, greatest);
  greatest = hn::IfThenElse(is_greater, separation, greatest);
  take(s, polygon, index, is_greater, face);
}

/// The greatest separations and the reference, A's face unless B's leads by more than the bias.
template <class D>
struct LaneSearch {
  hn::Vec<D> of_a;
  hn::Vec<D> of_b;
  hn::Mask<D> take_b;
  LaneFace<D> reference;
};

/// Both polygons' faces at once: a face of B looks along v_a - v_b, a face of A along its exact
/// opposite, so that each difference serves two faces, and A's separation is minus the greatest
/// product. B's count is a constant, so that its faces' separations stay in registers;
/// `consider_a` is told those of A's faces one after another.
template <int kCountB, class D, class Consider, class V = hn::Vec<D>>
HWY_INLINE void separate_faces(D d, const Strip<D>& s, const Consider& consider_a,
                               V (&of_face_b)[kCountB]) {
  const auto infinity = hn::Set(d, std::numeric_limits<hn::TFromD<D>>::infinity());
  for (int j = 0; j < kCountB; ++j) of_face_b[j] = infinity;
  for (int i = 0; i < s.count_max[0]; ++i) {
    const auto* const face = s.corner(0, i);
    const auto* const corners_b = reloaded(s.corners[1]);
    const Lanes2<D> origin = s.load2(face);
    const Lanes2<D> normal = s.load2(face + 2);
    auto most_opposed = hn::Neg(infinity);
    HWY_UNROLL(kMaxVertices)
    for (int j = 0; j < kCountB; ++j) {
      const auto* const other = corners_b + kCornerRows * j;
      const Lanes2<D> back = subtract(origin, s.load2(other));
      most_opposed = hn::Max(dot(normal, back), most_opposed);
      of_face_b[j] = hn::Min(dot(s.load2(other + 2), back), of_face_b[j]);
    }
    consider_a(i, hn::Neg(most_opposed));
  }
}

/// Where a face of B leads, it replaces A's as the reference, which is carried along once.
template <int kCountB, class D>
HWY_INLINE void search_faces(D d, const Strip<D>& s, hn::TFromD<D> tie_bias, LaneSearch<D>& found) {
  auto of_a = hn::Set(d, -std::numeric_limits<hn::TFromD<D>>::infinity());
  LaneFace<D> reference{first_edge(s, 0), s.load2(s.corner(0, 0) + 2)};  // where none is greater
  hn::Vec<D> of_face_b[kCountB];
  separate_faces<kCountB>(
      d, s,
      [&](int i, hn::Vec<D> separation)
          HWY_ATTR { consider(s, 0, i, separation, of_a, reference); },
      of_face_b);
  found.of_a = of_a;
  found.reference = reference;

  found.of_b = of_face_b[0];
  for (int j = 1; j < kCountB; ++j) found.of_b = hn::Max(of_face_b[j], found.of_b);
  found.take_b = hn::Gt(found.of_b, hn::Add(found.of_a, hn::Set(d, tie_bias)));
  const auto none = hn::Set(d, std::numeric_limits<hn::TFromD<D>>::quiet_NaN());
  const auto sought = hn::IfThenElse(found.take_b, found.of_b, none);
  HWY_UNROLL(kMaxVertices)
  for (int j = kCountB - 1; j >= 0; --j) {  // the first of equals last
    take(s, 1, j, hn::Eq(of_face_b[j], sought), found.reference);
  }
}

template <class D>
HWY_INLINE void search_faces(D d, const Strip<D>& s, hn::TFromD<D> tie_bias, LaneSearch<D>& found) {
  switch (s.count_max[1]) {
    case 3:
      return search_faces<3>(d, s, tie_bias, found);
    case 4:
      return search_faces<4>(d, s, tie_bias, found);
    case 5:
      return search_faces<5>(d, s, tie_bias, found);
    case 6:
      return search_faces<6>(d, s, tie_bias, found);
    case 7:
      return search_faces<7>(d, s, tie_bias, found);
    default:
      return search_faces<kMaxVertices>(d, s, tie_bias, found);
  }
}

/// The edge of each lane's incident polygon whose normal is most opposed, the first of equals;
/// `of_both` becomes the product of both normals.
template <class D>
HWY_INLINE LaneEdge<D> incident_edge(D d, const Strip<D>& s, hn::Mask<D> incident_is_a,
                                     const Lanes2<D>& normal, hn::Vec<D>& of_both) {
  auto least = hn::Set(d, std::numeric_limits<hn::TFromD<D>>::infinity());
  LaneEdge<D> incident = first_edge(s, 0);  // until the first product, which is less than infinity
  const auto consider_edges = [&](int first, int last, const auto& at, hn::Mask<D> among) {
    Lanes2<D> vertex = at(first, 0);
    for (int k = first; k < last; ++k) {
      const Lanes2<D> next = at(k + 1, 0);
      const auto product = dot(normal, at(k, 2));
      const auto is_less = hn::And(among, hn::Lt(product, least));
      least = hn::IfThenElse(is_less, product, least);
      incident = select<D>(is_less, {hn::Set(DInt<D>(), k), vertex, next}, incident);
      vertex = next;
    }
  };
  const auto of = [&](int p, int k, int element) { return s.load2(s.corner(p, k) + element); };
  const int both = HWY_MIN(s.count_max[0], s.count_max[1]);
  consider_edges(
      0, both,
      [&](int k, int element) {
        return select<D>(incident_is_a, of(0, k, element), of(1, k, element));
      },
      hn::Eq(normal.x, normal.x));
  const int longer = s.count_max[0] > s.count_max[1] ? 0 : 1;
  consider_edges(
      both, s.count_max[longer], [&](int k, int element) { return of(longer, k, element); },
      longer == 0 ? incident_is_a : hn::Not(incident_is_a));
  of_both = least;
  return incident;
}

/// An end of the incident edge; its features as a `FeaturePair`'s bytes, the reference's first.
template <class D>
struct ClipEnds {
  Lanes2<D> position;
  hn::Vec<DInt<D>> features;
};

inline constexpr int kFace = 1;  // `Feature::Kind`'s values; a vertex is 0

/// One clip (clipping/clip.hpp): `offset` of the whole edge's ends from the plane. Lanes whose edge
/// is left without a point are taken out of `kept`.
template <class D>
HWY_INLINE void clip(D d, ClipEnds<D> (&edge)[2], const LaneEdge<D>& whole, hn::Vec<D> offset0,
                     hn::Vec<D> offset1, hn::Vec<DInt<D>> crossing_features, hn::Mask<D>& kept) {
  const DInt<D> di;
  const auto zero = hn::Zero(d);
  const auto is_whole = hn::And(hn::Ge(offset0, zero), hn::Ge(offset1, zero));
  const auto is_gone = hn::And(hn::Le(offset0, zero), hn::Le(offset1, zero));
  kept = hn::And(kept, hn::Or(is_whole, hn::Not(is_gone)));
  const auto share = hn::Div(offset0, hn::Sub(offset0, offset1));
  const Lanes2<D> along = subtract(whole.second, whole.first);
  const Lanes2<D> crossing{hn::Add(whole.first.x, hn::Mul(share, along.x)),
                           hn::Add(whole.first.y, hn::Mul(share, along.y))};
  const auto is_first = hn::Lt(offset0, zero);
  const auto replace = [&](ClipEnds<D>& end, auto where) {
    end.position = select<D>(where, crossing, end.position);
    end.features = hn::IfThenElse(hn::RebindMask(di, where), crossing_features, end.features);
  };
  replace(edge[0], hn::AndNot(is_whole, is_first));
  replace(edge[1], hn::Not(hn::Or(is_whole, is_first)));
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
