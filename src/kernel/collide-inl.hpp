// The manifolds of a strip of pairs: clipping/collide.hpp, step by step, one pair a lane.

#if defined(MANIFUZZ_KERNEL_COLLIDE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_COLLIDE_INL
#undef MANIFUZZ_KERNEL_COLLIDE_INL
#else
#define MANIFUZZ_KERNEL_COLLIDE_INL
#endif

#include "kernel/clip-inl.hpp"
#include "kernel/cure.hpp"
#include "kernel/packed.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The features of a contact, in every lane; places are `CornerFetch`'s.
template <class D>
struct LaneFeatures {
  hn::Mask<D> take_b;     ///< the reference is B's face
  hn::Vec<DInt<D>> face;  ///< the reference face, and its second vertex
  hn::Vec<DInt<D>> face_second;
  hn::Vec<DInt<D>> edge;  ///< the incident edge, and its second vertex
  hn::Vec<DInt<D>> edge_second;
  Lanes2<D> corner[2];  ///< the reference face's ends
  Lanes2<D> normal;     ///< the reference face's own
  Lanes2<D> end[2];     ///< the incident edge's ends
};

template <class D>
HWY_INLINE LaneFeatures<D> choose_features(D d, const Strip<D>& s, const BothSeparations<D>& found,
                                           hn::Mask<D> take_b) {
  const DInt<D> di;
  const auto take_b_int = hn::RebindMask(di, take_b);
  const auto one = hn::Set(di, 1);
  const auto reference = hn::IfThenElseZero(take_b_int, one);
  const auto incident = hn::Sub(one, reference);
  const auto count_a = hn::Load(di, s.count[0]);
  const auto count_b = hn::Load(di, s.count[1]);
  const auto next = [&](auto index, auto count) {
    const auto after = hn::Add(index, one);
    return hn::IfThenZeroElse(hn::Eq(after, count), after);
  };
  const CornerFetch<D> fetch(d, s);
  LaneFeatures<D> f;
  f.take_b = take_b;
  f.face = hn::IfThenElse(take_b_int, found.of_b.face, found.of_a.face);
  f.face_second = next(f.face, hn::IfThenElse(take_b_int, count_b, count_a));
  const auto at_face = fetch.at(reference, f.face);
  f.normal = fetch.normal(at_face);
  f.corner[0] = fetch.vertex(at_face);
  f.corner[1] = fetch.vertex(fetch.at(reference, f.face_second));
  f.edge = incident_edges(d, s, take_b, f.normal);
  f.edge_second = next(f.edge, hn::IfThenElse(take_b_int, count_a, count_b));
  f.end[0] = fetch.vertex(fetch.at(incident, f.edge));
  f.end[1] = fetch.vertex(fetch.at(incident, f.edge_second));
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
  edge[0] = {f.end[0], feature_bytes(di, kFace, f.face, 0, f.edge)};
  edge[1] = {f.end[1], feature_bytes(di, kFace, f.face, 0, f.edge_second)};
  const auto offset = [&](const Lanes2<D>& end, const Lanes2<D>& corner, auto inward_x,
                          auto inward_y) {
    return hn::Add(dot(inward_x, inward_y, hn::Sub(end.x, corner.x), hn::Sub(end.y, corner.y)),
                   total_radius);
  };
  const auto minus_x = hn::Neg(f.normal.x);
  const auto minus_y = hn::Neg(f.normal.y);
  clip(d, edge, offset(edge[0].position, f.corner[0], minus_y, f.normal.x),
       offset(edge[1].position, f.corner[0], minus_y, f.normal.x),
       feature_bytes(di, 0, f.face, kFace, f.edge), kept);
  clip(d, edge, offset(edge[0].position, f.corner[1], f.normal.y, minus_x),
       offset(edge[1].position, f.corner[1], f.normal.y, minus_x),
       feature_bytes(di, 0, f.face_second, kFace, f.edge), kept);
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
    const auto separation = dot(f.normal.x, f.normal.y, hn::Sub(edge[i].position.x, f.corner[0].x),
                                hn::Sub(edge[i].position.y, f.corner[0].y));
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
  const auto choose = [&](auto of_second, auto of_first) {
    return hn::IfThenElse(keep[1], of_second, of_first);
  };
  m.position[0] = {choose(edge[1].position.x, edge[0].position.x),
                   choose(edge[1].position.y, edge[0].position.y)};
  m.depth[0] = choose(depth[1], depth[0]);
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
      const Lanes2<D> v = load2(d, s.corner[p][k][0], s.corner[p][k][1]);
      reach = hn::Max(hn::Add(hn::Abs(v.x), hn::Abs(v.y)), reach);
    }
    sum = hn::Add(sum, reach);
  }
  return sum;
}

/// The lanes whose manifold misses the overlap (`clipping::misses_deepest`).
template <class D>
HWY_INLINE hn::Mask<D> misses_deepest(D d, const Strip<D>& s, const LaneManifolds<D>& m,
                                      const BothSeparations<D>& found, hn::Mask<D> take_b,
                                      hn::Vec<D> total_radius, hn::Mask<D> among) {
  using T = hn::TFromD<D>;
  const DInt<D> di;
  const auto has = [&](int count) {
    return hn::RebindMask(d, hn::Gt(m.count, hn::Set(di, count - 1)));
  };
  auto deepest = hn::IfThenElse(has(1), m.depth[0], total_radius);
  deepest = hn::IfThenElse(has(2), hn::Max(m.depth[1], deepest), deepest);
  const auto separation = hn::IfThenElse(take_b, found.of_b.separation, found.of_a.separation);
  const auto greatest = hn::Max(found.of_a.separation, found.of_b.separation);
  const auto missing = hn::Sub(hn::Sub(total_radius, separation), deepest);
  const auto least = hn::Min(hn::Neg(greatest), missing);
  const auto might = hn::And(among, hn::Gt(least, hn::Zero(d)));
  if (HWY_LIKELY(hn::AllFalse(d, might))) return might;
  constexpr T u = std::numeric_limits<T>::epsilon() / 2;
  return hn::And(might, hn::Gt(least, hn::Mul(hn::Set(d, 4 * u), reach_of_both(d, s))));
}

template <class D>
HWY_INLINE void store(D d, const LaneManifolds<D>& m, ManifoldBlock<hn::TFromD<D>>& block,
                      int column) {
  const DInt<D> di;
  hn::Store(m.count, di, block.count.column + column);
  hn::Store(m.reference, di, block.reference.column + column);
  hn::Store(m.normal.x, d, block.normal[0].column + column);
  hn::Store(m.normal.y, d, block.normal[1].column + column);
  for (const int i : {0, 1}) {
    hn::Store(m.position[i].x, d, block.position[i][0].column + column);
    hn::Store(m.position[i].y, d, block.position[i][1].column + column);
    hn::Store(m.depth[i], d, block.depth[i].column + column);
    hn::Store(m.features[i], di, block.features[i].column + column);
  }
}

/// Replaces the manifolds of the lanes that need it by the clean code's last step.
template <class D>
HWY_NOINLINE void cure(D d, const Strip<D>& s, hn::Mask<D> needs,
                       ManifoldBlock<hn::TFromD<D>>& block, int column) {
  using T = hn::TFromD<D>;
  constexpr std::size_t kLanes = Strip<D>::kLanes;
  alignas(64) T flags[kLanes];
  hn::Store(hn::IfThenElseZero(needs, hn::Set(d, T{1})), d, flags);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (flags[lane] == 0) continue;
    const LanePair<T> pair{&s.corner[0][0][0][lane],
                           kLanes,
                           {static_cast<int>(s.count[0][lane]), static_cast<int>(s.count[1][lane])},
                           s.total_radius[lane]};
    put(deepest_contact(pair), block, column + static_cast<int>(lane));
  }
}

/// The manifolds of a strip whose B stands in A's frame already, into a block's columns.
template <class D>
HWY_INLINE void collide_strip(D d, const Strip<D>& s, hn::TFromD<D> tie_bias,
                              ManifoldBlock<hn::TFromD<D>>& block, int column) {
  const DInt<D> di;
  const auto total_radius = hn::Load(d, s.total_radius);
  const BothSeparations<D> found = greatest_separations(d, s);
  const auto separated = hn::Or(hn::Gt(found.of_a.separation, total_radius),
                                hn::Gt(found.of_b.separation, total_radius));
  if (hn::AllTrue(d, separated)) {
    hn::Store(hn::Zero(di), di, block.count.column + column);
    return;
  }
  const auto take_b =
      hn::Gt(found.of_b.separation, hn::Add(found.of_a.separation, hn::Set(d, tie_bias)));
  const LaneFeatures<D> features = choose_features(d, s, found, take_b);
  auto kept = hn::Not(separated);
  const auto touching = kept;
  ClipEnds<D> edge[2];
  clip_to_slab(d, features, total_radius, edge, kept);
  const LaneManifolds<D> m = keep_behind_face<D>(features, total_radius, edge, kept);
  store(d, m, block, column);
  const auto empty = hn::RebindMask(d, hn::Eq(m.count, hn::Zero(di)));
  const auto among = tie_bias > 0 ? hn::And(touching, empty) : touching;
  const auto needs = misses_deepest(d, s, m, found, take_b, total_radius, among);
  if (HWY_UNLIKELY(!hn::AllFalse(d, needs))) cure(d, s, needs, block, column);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
