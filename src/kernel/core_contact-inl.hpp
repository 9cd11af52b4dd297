// The manifolds of a strip of round shapes with faces: `clipping::contact_of_cores`, step by step,
// one pair a lane. Lanes in which rounding decides are left to the clean code.

#if defined(MANIFUZZ_KERNEL_CORE_CONTACT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_CORE_CONTACT_INL
#undef MANIFUZZ_KERNEL_CORE_CONTACT_INL
#else
#define MANIFUZZ_KERNEL_CORE_CONTACT_INL
#endif

#include "kernel/collide-inl.hpp"
#include "kernel/cores-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The edge that a shape gives at its nearest place (`clipping::edge_at`).
template <class D>
struct GivenEdge {
  LaneEdge<D> edge;
  hn::Vec<DInt<D>> second;  ///< the index of its second vertex
  hn::Vec<D> flatness;      ///< of its normal along `outward`; below 0: there is none
};

template <class D>
HWY_INLINE GivenEdge<D> given_edge(const LaneCorner<D>& corner, hn::Mask<D> is_face,
                                   const Lanes2<D>& outward) {
  const DInt<D> di;
  const auto of_previous = dot(corner.normal_before, outward);
  const auto of_next = dot(corner.normal, outward);
  const auto previous = hn::AndNot(is_face, hn::Gt(of_previous, of_next));
  const auto previous_int = hn::RebindMask(di, previous);
  return {{hn::IfThenElse(previous_int, corner.index_before, corner.index),
           select<D>(previous, corner.before, corner.vertex),
           select<D>(previous, corner.vertex, corner.after)},
          hn::IfThenElse(previous_int, corner.index, corner.index_after),
          hn::IfThenElse(previous, of_previous, of_next)};
}

/// The lanes that get a second point, the other end of what the clip of both edges keeps
/// (`clipping::add_second_point`), as point 1 of `m`. `f` has both edges and, as its normal, the
/// contact's out of the reference; `on` the place on the reference and the incident one.
template <class D>
HWY_INLINE hn::Mask<D> add_second_point(D d, const LaneFeatures<D>& f, const Lanes2<D> (&on)[2],
                                        hn::Vec<D> roundoff, hn::Vec<D> total_radius,
                                        hn::Mask<D> among, LaneManifolds<D>& m) {
  const DInt<D> di;
  const Lanes2<D> along = along_face(f.normal);
  const Lanes2<D> whole = subtract(f.face.second, f.face.first);
  const auto run = dot(along, whole);
  auto kept = hn::And(among, hn::Gt(run, roundoff));
  ClipEnds<D> edge[2];
  clip_to_slab(d, f, hn::Zero(d), edge, kept);
  const auto distance = [&](const ClipEnds<D>& end) {
    return hn::Abs(dot(along, subtract(end.position, on[1])));
  };
  const auto distance0 = distance(edge[0]);
  const auto distance1 = distance(edge[1]);
  const auto second = hn::Gt(distance1, distance0);
  const Lanes2<D> position = select<D>(second, edge[1].position, edge[0].position);
  const auto features =
      hn::IfThenElse(hn::RebindMask(di, second), edge[1].features, edge[0].features);
  kept = hn::And(kept, hn::Gt(hn::IfThenElse(second, distance1, distance0), roundoff));

  // A crossing is level with the reference edge's end, of which it has the index.
  const auto low_byte = hn::Set(di, 0xFF);
  const auto is_crossing = hn::RebindMask(d, hn::Eq(hn::And(features, low_byte), hn::Zero(di)));
  const auto is_at_second =
      hn::RebindMask(d, hn::Eq(hn::And(hn::ShiftRight<8>(features), low_byte), f.face_second));
  const Lanes2<D> end = select<D>(is_at_second, f.face.second, f.face.first);
  const Lanes2<D> level = select<D>(is_crossing, end, on[0]);
  const auto slope = hn::IfThenZeroElse(is_crossing, hn::Div(dot(f.normal, whole), run));
  const Lanes2<D> from_level = subtract(position, level);
  const auto separation =
      hn::Sub(dot(f.normal, from_level), hn::Mul(slope, dot(along, from_level)));
  m.position[1] = {position.x, position.y};
  m.depth[1] = hn::Sub(total_radius, separation);
  m.features[1] = hn::IfThenElse(hn::RebindMask(di, f.take_b), halves_swapped(features), features);
  return hn::AndNot(hn::Gt(separation, total_radius), kept);
}

/// Moves points from the incident core to its surface (`clipping::put_on_surface`).
template <class D>
HWY_INLINE void put_on_surface(const Strip<D>& s, hn::Mask<D> reference_is_b, LaneManifolds<D>& m) {
  const auto towards = towards_b(s, hn::Not(reference_is_b));
  for (Lanes2<D>& position : m.position) {
    position.x = hn::Add(position.x, hn::Mul(towards, m.normal.x));
    position.y = hn::Add(position.y, hn::Mul(towards, m.normal.y));
  }
}

/// `order_points` of geometry/manifold.hpp.
template <class D>
HWY_INLINE void order_points(D d, hn::Mask<D> reference_is_b, hn::Mask<D> has_both,
                             LaneManifolds<D>& m) {
  const Lanes2<D> from_a = along_face(m.normal);
  const Lanes2<D> along = select<D>(reference_is_b, opposite(from_a), from_a);
  const auto swaps =
      hn::And(has_both, hn::Lt(dot(along, subtract(m.position[1], m.position[0])), hn::Zero(d)));
  const auto swap = [](auto mask, auto& first, auto& second) {
    const auto was_first = first;
    first = hn::IfThenElse(mask, second, first);
    second = hn::IfThenElse(mask, was_first, second);
  };
  swap(swaps, m.position[0].x, m.position[1].x);
  swap(swaps, m.position[0].y, m.position[1].y);
  swap(swaps, m.depth[0], m.depth[1]);
  swap(hn::RebindMask(DInt<D>(), swaps), m.features[0], m.features[1]);
}

/// Where cores are nearest (`clipping::nearest_contact`); `among` are the lanes that may touch.
/// Lanes in which a place has no edge that faces the other become unsure.
template <class D>
HWY_INLINE void nearest_contact(D d, const Strip<D>& s, const LaneNearest<D>& nearest,
                                hn::Vec<D> roundoff, hn::Vec<D> total_radius, hn::Mask<D> among,
                                LaneManifolds<D>& m, hn::Mask<D>& is_unsure) {
  const DInt<D> di;
  const auto zero = hn::Zero(d);
  const auto separation = dot(nearest.normal, nearest.apart);
  const auto touches = hn::AndNot(hn::Gt(separation, total_radius), among);
  const GivenEdge<D> a = given_edge(nearest.corner[0], nearest.face_of[0], nearest.normal);
  const GivenEdge<D> b =
      given_edge(nearest.corner[1], nearest.face_of[1], opposite(nearest.normal));
  const auto has_a = hn::Ge(a.flatness, zero);
  const auto has_b = hn::Ge(b.flatness, zero);
  const auto has_both = hn::And(has_a, has_b);
  // At a vertex none faces the other shape only by rounding; a vertex before a face is no other.
  is_unsure = hn::Or(is_unsure, hn::AndNot(has_both, touches));
  const auto take_b = hn::Or(hn::Not(has_a), hn::And(has_both, hn::Gt(b.flatness, a.flatness)));
  const auto take_b_int = hn::RebindMask(di, take_b);
  const auto kinds = [&](int p, int bit) {
    return hn::IfThenElseZero(hn::RebindMask(di, nearest.face_of[p]), hn::Set(di, bit));
  };
  m.reference = flag(di, take_b);
  m.normal = {nearest.normal.x, nearest.normal.y};
  m.position[0] = select<D>(take_b, nearest.on[0], nearest.on[1]);
  m.depth[0] = hn::Sub(total_radius, separation);
  m.features[0] = hn::Or(hn::Or(kinds(0, kFace), kinds(1, kFace << 16)),
                         hn::Or(hn::ShiftLeft<8>(nearest.corner[0].index),
                                hn::ShiftLeft<24>(nearest.corner[1].index)));
  LaneFeatures<D> f;
  f.take_b = take_b;
  f.face = select<D>(take_b, b.edge, a.edge);
  f.incident = select<D>(take_b, a.edge, b.edge);
  f.face_second = hn::IfThenElse(take_b_int, b.second, a.second);
  f.incident_second = hn::IfThenElse(take_b_int, a.second, b.second);
  f.normal = select<D>(take_b, opposite(nearest.normal), nearest.normal);
  const Lanes2<D> on[2] = {select<D>(take_b, nearest.on[1], nearest.on[0]), m.position[0]};
  const auto has_second =
      add_second_point(d, f, on, roundoff, total_radius, hn::And(touches, has_both), m);
  m.count = hn::Add(flag(di, touches), flag(di, has_second));
  put_on_surface(s, take_b, m);
  order_points(d, take_b, has_second, m);
}

/// Cores that overlap have their faces clipped (`clipping::contact_of_faces`, then
/// `overlapping_contact`); `is_unsure` becomes the lanes whose clip misses the overlap.
template <class D>
HWY_INLINE void overlapping_contact(D d, const Strip<D>& s, const LaneSearch<D>& found,
                                    const LaneCorner<D> (&corner)[2], hn::TFromD<D> tie_bias,
                                    hn::Vec<D> total_radius, hn::Mask<D> among, LaneManifolds<D>& m,
                                    hn::Mask<D>& is_unsure) {
  const DInt<D> di;
  const auto take_b = reference_is_b(d, found, tie_bias);
  const LaneFace<D> reference{
      {hn::IfThenElse(hn::RebindMask(di, take_b), corner[1].index, corner[0].index),
       select<D>(take_b, corner[1].vertex, corner[0].vertex),
       select<D>(take_b, corner[1].after, corner[0].after)},
      select<D>(take_b, corner[1].normal, corner[0].normal)};
  const LaneFeatures<D> f = choose_features(d, s, take_b, reference);
  auto kept = among;
  ClipEnds<D> edge[2];
  clip_to_slab(d, f, hn::Zero(d), edge, kept);
  m = keep_behind_face<D>(f, total_radius, edge, kept);
  const auto empty = hn::RebindMask(d, hn::Eq(m.count, hn::Zero(di)));
  const auto may_miss = tie_bias > 0 ? empty : among;
  // An edge of the incident polygon that faces away gives no second point.
  const auto faces_away = hn::Gt(f.product, hn::Zero(d));
  is_unsure = hn::And(
      among, hn::Or(hn::Or(empty, faces_away), misses_deepest(d, s, m, found, take_b, total_radius,
                                                              hn::And(among, may_miss))));
  put_on_surface(s, f.take_b, m);
}

/// Takes the manifolds of some lanes.
template <class D>
HWY_INLINE void take(hn::Mask<D> where, const LaneManifolds<D>& there, LaneManifolds<D>& here) {
  const auto where_int = hn::RebindMask(DInt<D>(), where);
  here.count = hn::IfThenElse(where_int, there.count, here.count);
  here.reference = hn::IfThenElse(where_int, there.reference, here.reference);
  here.normal = select<D>(where, there.normal, here.normal);
  for (const int i : {0, 1}) {
    here.position[i] = select<D>(where, there.position[i], here.position[i]);
    here.depth[i] = hn::IfThenElse(where, there.depth[i], here.depth[i]);
    here.features[i] = hn::IfThenElse(where_int, there.features[i], here.features[i]);
  }
}

/// The manifolds of a strip whose B stands in A's frame.
template <class D>
HWY_INLINE void collide_cores(D d, const Strip<D>& s, hn::TFromD<D> tie_bias,
                              ManifoldBlock<hn::TFromD<D>>& out) {
  using T = hn::TFromD<D>;
  const DInt<D> di;
  const auto total_radius = s.load(s.rows[kTotalRadius]);
  const auto roundoff =
      hn::Mul(hn::Set(d, 2 * std::numeric_limits<T>::epsilon()), reach_of_both(d, s));
  LaneSearch<D> found;
  search_faces(d, s, found);
  LaneCorner<D> corner[2];
  BeforeFace<D> seen[2];
  for (const int p : {0, 1}) {
    find_corner(d, s, p, found.face[p], corner[p]);
    look_before_face(d, s, p, corner[p], found.of[p], roundoff, seen[p]);
  }
  const auto greatest = hn::Max(found.of[0], found.of[1]);
  const auto touching = hn::Not(hn::Gt(greatest, total_radius));
  const auto is_deep = hn::And(touching, hn::Lt(greatest, hn::Neg(roundoff)));
  const auto a_first = hn::Ge(found.of[0], found.of[1]);
  const auto faces_decide = hn::Or(hn::And(a_first, seen[0].deepest_is_before),
                                   hn::AndNot(a_first, seen[1].deepest_is_before));
  const auto overlaps = hn::And(is_deep, faces_decide);
  const auto is_finite =
      hn::Lt(hn::Add(hn::Abs(greatest), roundoff), hn::Set(d, std::numeric_limits<T>::infinity()));
  auto left = hn::And(touching, hn::Or(hn::Not(is_finite), hn::AndNot(faces_decide, is_deep)));

  LaneNearest<D> nearest;
  find_nearest(d, s, found, corner, seen, roundoff, hn::Not(is_deep), nearest);
  const auto gap = hn::Min(hn::Sub(total_radius, nearest.distance), hn::Zero(d));
  const auto between = face_between(found, hn::Gt(found.of[1], found.of[0]));
  if (hn::AllFalse(d, touching)) {
    hn::Store(hn::Zero(di), di, out.count.column + s.column);
    hn::Store(gap, d, out.depth[0].column + s.column);
    hn::Store(between, di, out.features[0].column + s.column);
    return;
  }
  LaneManifolds<D> m;
  const auto is_near = hn::AndNot(is_deep, touching);
  nearest_contact(d, s, nearest, roundoff, total_radius, is_near, m, nearest.is_unsure);
  left = hn::Or(left, hn::And(is_near, nearest.is_unsure));
  if (HWY_UNLIKELY(!hn::AllFalse(d, overlaps))) {
    LaneManifolds<D> clipped;
    auto is_unsure = overlaps;
    overlapping_contact(d, s, found, corner, tie_bias, total_radius, overlaps, clipped, is_unsure);
    take(overlaps, clipped, m);
    left = hn::Or(left, is_unsure);
  }
  m.count = hn::IfThenZeroElse(hn::RebindMask(di, left), m.count);
  const auto empty = hn::RebindMask(d, hn::Eq(m.count, hn::Zero(di)));
  m.depth[0] = hn::IfThenElse(empty, gap, m.depth[0]);
  m.features[0] = hn::IfThenElse(hn::RebindMask(di, empty), between, m.features[0]);
  store(d, m, s.column, out);
  if (HWY_UNLIKELY(!hn::AllFalse(d, left))) collide_left(d, s, left, tie_bias, out);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
