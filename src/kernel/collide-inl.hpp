// The manifolds of a strip of pairs: clipping/collide.hpp, step by step, one pair a lane.

#if defined(MANIFUZZ_KERNEL_COLLIDE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_COLLIDE_INL
#undef MANIFUZZ_KERNEL_COLLIDE_INL
#else
#define MANIFUZZ_KERNEL_COLLIDE_INL
#endif

#include "kernel/clip-inl.hpp"
#include "kernel/deepest_contact.hpp"
#include "kernel/packed.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The features of a contact, in every lane.
template <class D>
struct LaneFeatures {
  hn::Mask<D> take_b;  ///< the reference is B's face
  LaneEdge<D> face;    ///< the reference
  LaneEdge<D> incident;
  hn::Vec<DInt<D>> face_second;  ///< the index of each edge's second vertex
  hn::Vec<DInt<D>> incident_second;
  Lanes2<D> normal;    ///< the reference face's own
  hn::Vec<D> product;  ///< of both edges' normals
};

template <class D>
HWY_INLINE LaneFeatures<D> choose_features(D d, const Strip<D>& s, hn::Mask<D> take_b,
                                           const LaneFace<D>& reference) {
  const DInt<D> di;
  const auto take_b_int = hn::RebindMask(di, take_b);
  const auto count_a = s.count(0);
  const auto count_b = s.count(1);
  LaneFeatures<D> f;
  f.take_b = take_b;
  // One by one: g++ 12 copies structures of vectors in parts too small to be read back at once.
  f.face = {reference.edge.index,
            {reference.edge.first.x, reference.edge.first.y},
            {reference.edge.second.x, reference.edge.second.y}};
  f.normal = {reference.normal.x, reference.normal.y};
  f.incident = incident_edge(d, s, f.take_b, f.normal, f.product);
  f.face_second = next_corner(di, f.face.index, hn::IfThenElse(take_b_int, count_b, count_a));
  f.incident_second =
      next_corner(di, f.incident.index, hn::IfThenElse(take_b_int, count_a, count_b));
  return f;
}

/// A feature of the reference polygon and one of the incident polygon, in a `FeaturePair`'s bytes.
template <class DI, class VI>
HWY_INLINE VI feature_bytes(DI di, int reference_kind, VI reference, int incident_kind,
                            VI incident) {
  const auto kinds = hn::Set(di, reference_kind | incident_kind << 16);
  return hn::Or(kinds, hn::Or(hn::ShiftLeft<8>(reference), hn::ShiftLeft<24>(incident)));
}

/// The incident polygon's feature first.
template <class VI>
HWY_INLINE VI halves_swapped(VI features) {
  return hn::Or(hn::ShiftLeft<16>(features), hn::ShiftRight<16>(features));
}

/// The clipped edge; `kept` loses the lanes whose edge misses the slab.
template <class D>
HWY_INLINE void clip_to_slab(D d, const LaneFeatures<D>& f, hn::Vec<D> total_radius,
                             ClipEnds<D> (&edge)[2], hn::Mask<D>& kept) {
  const DInt<D> di;
  edge[0] = {f.incident.first, feature_bytes(di, kFace, f.face.index, 0, f.incident.index)};
  edge[1] = {f.incident.second, feature_bytes(di, kFace, f.face.index, 0, f.incident_second)};
  const auto clip_at = [&](const Lanes2<D>& corner, hn::Vec<DInt<D>> index,
                           const Lanes2<D>& inward) {
    const auto offset = [&](const Lanes2<D>& end) {
      return hn::Add(dot(inward, subtract(end, corner)), total_radius);
    };
    clip(d, edge, f.incident, offset(f.incident.first), offset(f.incident.second),
         feature_bytes(di, 0, index, kFace, f.incident.index), kept);
  };
  clip_at(f.face.first, f.face.index, {hn::Neg(f.normal.y), f.normal.x});
  clip_at(f.face.second, f.face_second, {f.normal.y, hn::Neg(f.normal.x)});
}

/// The features of a pair without points: the reference face, and vertex 0 of the other polygon.
template <class D>
HWY_INLINE hn::Vec<DInt<D>> face_between(const LaneSearch<D>& found, hn::Mask<D> take_b) {
  const DInt<D> di;
  const auto is_b = hn::RebindMask(di, take_b);
  const auto face = hn::IfThenElse(is_b, found.face[1], found.face[0]);
  const auto of_a = feature_bytes(di, kFace, face, 0, hn::Zero(di));
  return hn::IfThenElse(is_b, halves_swapped(of_a), of_a);
}

/// A strip's manifolds, as a `ManifoldBlock` holds them.
template <class D>
struct LaneManifolds {
  hn::Vec<DInt<D>> count;
  hn::Vec<DInt<D>> reference;
  Lanes2<D> normal;
  Lanes2<D> position[2];
  hn::Vec<D> depth[2];
  hn::Vec<DInt<D>> features[2];
};

/// Keeps the ends behind the face, the second one first, and puts A's features first.
template <class D>
HWY_INLINE LaneManifolds<D> keep_behind_face(const LaneFeatures<D>& f, hn::Vec<D> total_radius,
                                             const ClipEnds<D> (&edge)[2], hn::Mask<D> kept) {
  const DInt<D> di;
  const auto one = hn::Set(di, 1);
  const auto take_b = hn::RebindMask(di, f.take_b);
  hn::Vec<D> depth[2];
  hn::Mask<D> keep[2];
  hn::Vec<DInt<D>> features[2];
  for (const int i : {0, 1}) {
    const auto separation = dot(f.normal, subtract(edge[i].position, f.face.first));
    depth[i] = hn::Sub(total_radius, separation);
    keep[i] = hn::AndNot(hn::Gt(separation, total_radius), kept);
    features[i] = hn::IfThenElse(take_b, halves_swapped(edge[i].features), edge[i].features);
  }
  LaneManifolds<D> m;
  const auto keeps = [&](int i) { return hn::IfThenElseZero(hn::RebindMask(di, keep[i]), one); };
  m.count = hn::Add(keeps(0), keeps(1));
  m.reference = hn::IfThenElseZero(take_b, one);
  m.normal = {hn::IfThenElse(f.take_b, hn::Neg(f.normal.x), f.normal.x),
              hn::IfThenElse(f.take_b, hn::Neg(f.normal.y), f.normal.y)};
  m.position[0] = select<D>(keep[1], edge[1].position, edge[0].position);
  m.depth[0] = hn::IfThenElse(keep[1], depth[1], depth[0]);
  m.features[0] = hn::IfThenElse(hn::RebindMask(di, keep[1]), features[1], features[0]);
  m.position[1] = edge[0].position;
  m.depth[1] = depth[0];
  m.features[1] = features[0];
  return m;
}

/// |x| + |y| of each polygon's farthest vertex, summed (`clipping::reach_in_frame`).
template <class D>
HWY_INLINE hn::Vec<D> reach_of_both(D d, const Strip<D>& s) {
  auto sum = hn::Zero(d);
  for (const int p : {0, 1}) {
    auto reach = hn::Zero(d);
    for (int k = 0; k < s.count_max[p]; ++k) {
      const Lanes2<D> v = s.load2(s.corner(p, k));
      reach = hn::Max(hn::Add(hn::Abs(v.x), hn::Abs(v.y)), reach);
    }
    sum = hn::Add(sum, reach);
  }
  return sum;
}

/// The lanes whose manifold misses the overlap (`clipping::misses_deepest`).
template <class D>
HWY_INLINE hn::Mask<D> misses_deepest(D d, const Strip<D>& s, const LaneManifolds<D>& m,
                                      const LaneSearch<D>& found, hn::Mask<D> take_b,
                                      hn::Vec<D> total_radius, hn::Mask<D> among) {
  using T = hn::TFromD<D>;
  const DInt<D> di;
  const auto has = [&](int count) {
    return hn::RebindMask(d, hn::Gt(m.count, hn::Set(di, count - 1)));
  };
  auto deepest = hn::IfThenElse(has(1), m.depth[0], total_radius);
  deepest = hn::IfThenElse(has(2), hn::Max(m.depth[1], deepest), deepest);
  const auto separation = hn::IfThenElse(take_b, found.of[1], found.of[0]);
  const auto greatest = hn::Max(found.of[0], found.of[1]);
  const auto missing = hn::Sub(hn::Sub(total_radius, separation), deepest);
  const auto overlap = hn::Neg(greatest);
  const auto might = hn::And(among, hn::Gt(hn::Min(overlap, missing), hn::Zero(d)));
  if (HWY_LIKELY(hn::AllFalse(d, might))) return might;
  constexpr T u = std::numeric_limits<T>::epsilon() / 2;
  const auto four_u = hn::Set(d, 4 * u);
  const auto roundoff = hn::Mul(four_u, reach_of_both(d, s));
  const auto of_sums = hn::IfThenElseZero(has(1), hn::Mul(four_u, total_radius));
  const auto is_missing = hn::Gt(missing, hn::Add(roundoff, of_sums));
  return hn::And(might, hn::And(hn::Gt(overlap, roundoff), is_missing));
}

template <class D>
HWY_INLINE void store(D d, const LaneManifolds<D>& m, int column,
                      ManifoldBlock<hn::TFromD<D>>& out) {
  const DInt<D> di;
  hn::Store(m.count, di, out.count.column + column);
  hn::Store(m.reference, di, out.reference.column + column);
  hn::Store(m.normal.x, d, out.normal[0].column + column);
  hn::Store(m.normal.y, d, out.normal[1].column + column);
  for (const int i : {0, 1}) {
    hn::Store(m.position[i].x, d, out.position[i][0].column + column);
    hn::Store(m.position[i].y, d, out.position[i][1].column + column);
    hn::Store(m.depth[i], d, out.depth[i].column + column);
    hn::Store(m.features[i], di, out.features[i].column + column);
  }
}

/// Replaces the manifolds of the lanes that need it by the clean code's last step.
template <class D>
HWY_NOINLINE void put_deepest_contacts(D d, const Strip<D>& s, hn::Mask<D> needs,
                                       ManifoldBlock<hn::TFromD<D>>& out) {
  using T = hn::TFromD<D>;
  for_each_lane(d, needs, [&](std::size_t lane) {
    const int column = s.column + static_cast<int>(lane);
    const auto at = [&](int row) { return s.rows[row].column[column]; };
    const Manifold<T> deepest =
        deepest_contact_or<T>({{s.corners[0], s.corners[1]},
                               column,
                               {static_cast<int>(at(kCountA)), static_cast<int>(at(kCountB))},
                               {at(kTotalRadius), 0}},
                              manifold(out, column));
    if (deepest.count > 0) put(deepest, out, column);  // else the gap stays there
  });
}

/// The manifolds of a strip whose B stands in A's frame.
template <class D>
HWY_INLINE void collide_placed(D d, const Strip<D>& s, hn::TFromD<D> tie_bias,
                               ManifoldBlock<hn::TFromD<D>>& out) {
  const DInt<D> di;
  const auto total_radius = s.load(s.rows[kTotalRadius]);
  LaneSearch<D> found;
  search_faces(d, s, found);
  const auto separated =
      hn::Or(hn::Gt(found.of[0], total_radius), hn::Gt(found.of[1], total_radius));
  const auto gap = hn::Sub(hn::Max(found.of[0], found.of[1]), total_radius);
  const auto take_b = reference_is_b(d, found, tie_bias);
  const auto between = face_between(found, take_b);
  if (hn::AllTrue(d, separated)) {
    hn::Store(hn::Zero(di), di, out.count.column + s.column);
    hn::Store(hn::Neg(gap), d, out.depth[0].column + s.column);
    hn::Store(between, di, out.features[0].column + s.column);
    return;
  }
  const LaneFeatures<D> features = choose_features(d, s, take_b, reference_face(s, found, take_b));
  const auto touching = hn::Not(separated);
  auto kept = touching;
  ClipEnds<D> edge[2];
  clip_to_slab(d, features, total_radius, edge, kept);
  LaneManifolds<D> m = keep_behind_face<D>(features, total_radius, edge, kept);
  const auto empty = hn::RebindMask(d, hn::Eq(m.count, hn::Zero(di)));
  m.depth[0] = hn::IfThenElse(empty, hn::Min(hn::Neg(gap), hn::Zero(d)), m.depth[0]);
  m.features[0] = hn::IfThenElse(hn::RebindMask(di, empty), between, m.features[0]);
  store(d, m, s.column, out);
  const auto among = tie_bias > 0 ? hn::And(touching, empty) : touching;
  const auto needs = misses_deepest(d, s, m, found, take_b, total_radius, among);
  if (HWY_UNLIKELY(!hn::AllFalse(d, needs))) put_deepest_contacts(d, s, needs, out);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
