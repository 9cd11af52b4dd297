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

/// An edge of each lane's polygon, with what a contact needs of it.
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

/// The face of greatest separation of each polygon, the first of equals.
template <class D>
struct LaneSearch {
  hn::Vec<D> of[2];
  hn::Vec<DInt<D>> face[2];
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

template <int kCountB, class D>
HWY_INLINE void search_faces(D d, const Strip<D>& s, LaneSearch<D>& found) {
  const DInt<D> di;
  const auto consider = [&](int p, int k, hn::Vec<D> separation) HWY_ATTR {
    const auto is_greater = hn::Gt(separation, found.of[p]);
    found.of[p] = hn::IfThenElse(is_greater, separation, found.of[p]);
    found.face[p] = hn::IfThenElse(hn::RebindMask(di, is_greater), hn::Set(di, k), found.face[p]);
  };
  found.of[0] = hn::Set(d, -std::numeric_limits<hn::TFromD<D>>::infinity());
  found.face[0] = found.face[1] = hn::Zero(di);
  hn::Vec<D> of_face_b[kCountB];
  separate_faces<kCountB>(
      d, s, [&](int i, hn::Vec<D> separation) HWY_ATTR { consider(0, i, separation); }, of_face_b);
  found.of[1] = of_face_b[0];
  HWY_UNROLL(kMaxVertices)
  for (int j = 1; j < kCountB; ++j) consider(1, j, of_face_b[j]);
}

template <class D>
HWY_INLINE void search_faces(D d, const Strip<D>& s, LaneSearch<D>& found) {
  switch (s.count_max[1]) {
    case 2:
      return search_faces<2>(d, s, found);
    case 3:
      return search_faces<3>(d, s, found);
    case 4:
      return search_faces<4>(d, s, found);
    case 5:
      return search_faces<5>(d, s, found);
    case 6:
      return search_faces<6>(d, s, found);
    case 7:
      return search_faces<7>(d, s, found);
    default:
      return search_faces<kMaxVertices>(d, s, found);
  }
}

/// The lanes whose reference is B's face: it leads A's by more than the bias.
template <class D>
HWY_INLINE hn::Mask<D> reference_is_b(D d, const LaneSearch<D>& found, hn::TFromD<D> tie_bias) {
  return hn::Gt(found.of[1], hn::Add(found.of[0], hn::Set(d, tie_bias)));
}

/// Fetches the reference. To carry it along while faces are compared takes no less time where pairs
/// touch, and is in vain where all are apart.
template <class D>
HWY_INLINE LaneFace<D> reference_face(const Strip<D>& s, const LaneSearch<D>& found,
                                      hn::Mask<D> take_b) {
  const DInt<D> di;
  const auto face_b =
      hn::IfThenElse(hn::RebindMask(di, take_b), found.face[1], hn::Set(di, -1));  // or none
  const auto is_at = [&](hn::Vec<DInt<D>> face, int index)
                         HWY_ATTR { return hn::RebindMask(D(), hn::Eq(face, hn::Set(di, index))); };
  LaneFace<D> face{first_edge(s, 0), s.load2(s.corner(0, 0) + 2)};
  for (int i = 1; i < s.count_max[0]; ++i) take(s, 0, i, is_at(found.face[0], i), face);
  for (int j = 0; j < s.count_max[1]; ++j) take(s, 1, j, is_at(face_b, j), face);
  return face;
}

/// The edge of each lane's incident polygon whose normal is most opposed, the first of equals: it
/// is carried along while edges are compared. `of_both` becomes the product of both normals.
template <class D>
HWY_INLINE LaneEdge<D> incident_edge(D d, const Strip<D>& s, hn::Mask<D> incident_is_a,
                                     const Lanes2<D>& normal, hn::Vec<D>& of_both) {
  auto least = hn::Set(d, std::numeric_limits<hn::TFromD<D>>::infinity());
  LaneEdge<D> incident = first_edge(s, 0);  // until the first product, which is less than infinity
  const auto consider_edges = [&](int first, int last, const auto& at, const auto& among) {
    Lanes2<D> vertex = at(first, 0);
    for (int k = first; k < last; ++k) {
      const Lanes2<D> next = at(k + 1, 0);
      const auto product = dot(normal, at(k, 2));
      const auto is_less = among(hn::Lt(product, least));
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
      [](hn::Mask<D> less) { return less; });
  const int longer = s.count_max[0] > s.count_max[1] ? 0 : 1;
  consider_edges(
      both, s.count_max[longer], [&](int k, int element) { return of(longer, k, element); },
      [&](hn::Mask<D> less) {
        return longer == 0 ? hn::And(less, incident_is_a) : hn::AndNot(incident_is_a, less);
      });
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
