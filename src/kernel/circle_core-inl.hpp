// A circle and a core with faces, one pair a lane: `clipping::contact_of_circle`, step by step.

#if defined(MANIFUZZ_KERNEL_CIRCLE_CORE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_CIRCLE_CORE_INL
#undef MANIFUZZ_KERNEL_CIRCLE_CORE_INL
#else
#define MANIFUZZ_KERNEL_CIRCLE_CORE_INL
#endif

#include "kernel/round-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The core's place that is nearest to the circle's centre.
template <class D>
struct LanePlace {
  Lanes2<D> on_core;
  Lanes2<D> apart;           ///< from the core to the centre
  Lanes2<D> outward;         ///< out of the core, unit
  hn::Vec<DInt<D>> feature;  ///< its half of a `FeaturePair`'s bytes
  hn::Vec<DInt<D>> face;     ///< that half, of the face of greatest separation
  hn::Vec<D> distance;       ///< no more than how far the core is from the centre, but for rounding
  hn::Mask<D> has_edge;      ///< `clipping::edge_at` gives one
  hn::Mask<D> is_far;        ///< too far, which is known before the root
  hn::Mask<D> is_rare;       ///< left to the clean code
};

/// The face of greatest separation from the centre, the first of equals.
template <class D>
HWY_INLINE hn::Vec<DInt<D>> greatest_face(D d, const Strip<D>& s, int core, const Lanes2<D>& centre,
                                          hn::Vec<D>& greatest) {
  const DInt<D> di;
  auto face = hn::Zero(di);
  greatest = hn::Set(d, -std::numeric_limits<hn::TFromD<D>>::infinity());
  for (int k = 0; k < s.count_max[core]; ++k) {
    const auto* const row = s.corner(core, k);
    const auto separation = dot(s.load2(row + 2), subtract(centre, s.load2(row)));
    const auto is_greater = hn::Gt(separation, greatest);
    greatest = hn::IfThenElse(is_greater, separation, greatest);
    face = hn::IfThenElse(hn::RebindMask(di, is_greater), hn::Set(di, k), face);
  }
  return face;
}

/// Where the centre is past an end of the face, that end takes the face's place.
template <class D>
HWY_INLINE void take_end(D d, const Strip<D>& s, int core, const LaneCorner<D>& face,
                         hn::Mask<D> is_past, const Lanes2<D>& centre, hn::Vec<D> total_radius,
                         LanePlace<D>& place) {
  const DInt<D> di;
  const auto zero = hn::Zero(d);
  const auto is_second = hn::Gt(dot(along_face(face.normal), subtract(centre, face.vertex)), zero);
  LaneCorner<D> end;
  find_corner(d, s, core,
              hn::IfThenElse(hn::RebindMask(di, is_second), face.index_after, face.index), end);
  const Lanes2<D> apart = subtract(centre, end.vertex);
  LaneDirection<D> direction;
  find_direction(d, apart, total_radius, direction);
  const auto is_end = hn::And(is_past, is_normal_at(d, end, apart));
  const auto is_short = hn::Le(direction.length, hn::Set(d, kShortest<hn::TFromD<D>>));
  const auto is_outside = hn::Gt(place.distance, zero);
  // Past a face in front of which it is, and yet not at its end: the face beside may have it. At an
  // end and behind the face it may be inside.
  const auto is_behind = hn::Lt(dot(face.normal, apart), zero);
  place.is_rare = hn::Or(hn::And(is_end, hn::Or(is_short, is_behind)),
                         hn::AndNot(is_end, hn::And(is_past, is_outside)));
  place.is_far = hn::Or(place.is_far, hn::And(is_end, hn::Gt(direction.is_beyond, zero)));
  place.on_core = select<D>(is_end, end.vertex, place.on_core);
  place.apart = select<D>(is_end, apart, place.apart);
  place.outward = select<D>(is_end, direction.unit, place.outward);
  place.distance = hn::IfThenElse(is_end, direction.length, place.distance);
  place.feature =
      hn::IfThenElse(hn::RebindMask(di, is_end), hn::ShiftLeft<8>(end.index), place.feature);
  const auto flatness =
      hn::Max(dot(end.normal_before, direction.unit), dot(end.normal, direction.unit));
  place.has_edge = hn::Or(hn::Not(is_end), hn::Ge(flatness, zero));
}

template <class D>
HWY_INLINE void find_place(D d, const Strip<D>& s, int core, const Lanes2<D>& centre,
                           hn::Vec<D> total_radius, LanePlace<D>& place) {
  const DInt<D> di;
  LaneCorner<D> face;
  find_corner(d, s, core, greatest_face(d, s, core, centre, place.distance), face);
  place.outward = {face.normal.x, face.normal.y};
  place.apart = scaled<D>(place.distance, face.normal);
  place.on_core = subtract(centre, place.apart);
  place.face = hn::Or(hn::Set(di, 1), hn::ShiftLeft<8>(face.index));
  place.feature = place.face;
  place.has_edge = hn::Eq(centre.x, centre.x);
  place.is_far = hn::Gt(place.distance, total_radius);
  place.is_rare = hn::Not(place.has_edge);
  const auto is_past = hn::Not(is_before_face(d, face.vertex, face.after, face.normal, centre));
  if (!hn::AllFalse(d, is_past)) {
    take_end(d, s, core, face, is_past, centre, total_radius, place);
  }
}

/// The manifolds of a strip whose polygon `core` has faces; the other is a circle.
template <class D>
HWY_INLINE void collide_circle_and_core(D d, const Strip<D>& s, int core,
                                        ManifoldBlock<hn::TFromD<D>>& out) {
  using T = hn::TFromD<D>;
  const DInt<D> di;
  const auto total_radius = s.load(s.rows[kTotalRadius]);
  const Lanes2<D> centre = s.load2(s.corner(1 - core, 0));
  LanePlace<D> place;
  find_place(d, s, core, centre, total_radius, place);
  const bool core_is_a = core == 0;
  const Lanes2<D> normal = core_is_a ? place.outward : opposite(place.outward);
  const Lanes2<D> apart = core_is_a ? place.apart : opposite(place.apart);
  const auto separation = dot(normal, apart);
  const auto touches = hn::AndNot(place.is_far, hn::Le(separation, total_radius));
  const auto reference_is_a = core_is_a ? place.has_edge : hn::Not(hn::Eq(centre.x, centre.x));
  const Lanes2<D> incident =
      core_is_a ? select<D>(reference_is_a, centre, place.on_core) : Lanes2<D>{centre.x, centre.y};
  const auto towards = towards_b(s, reference_is_a);
  const auto gap = hn::Min(hn::Sub(total_radius, place.distance), hn::Zero(d));
  hn::Store(flag(di, touches), di, out.count.column + s.column);
  hn::Store(flag(di, hn::Not(reference_is_a)), di, out.reference.column + s.column);
  hn::Store(normal.x, d, out.normal[0].column + s.column);
  hn::Store(normal.y, d, out.normal[1].column + s.column);
  hn::Store(hn::Add(incident.x, hn::Mul(towards, normal.x)), d,
            out.position[0][0].column + s.column);
  hn::Store(hn::Add(incident.y, hn::Mul(towards, normal.y)), d,
            out.position[0][1].column + s.column);
  hn::Store(hn::IfThenElse(touches, hn::Sub(total_radius, separation), gap), d,
            out.depth[0].column + s.column);
  const auto feature = hn::IfThenElse(hn::RebindMask(di, touches), place.feature, place.face);
  hn::Store(core_is_a ? feature : hn::ShiftLeft<16>(feature), di,
            out.features[0].column + s.column);
  if (HWY_UNLIKELY(!hn::AllFalse(d, place.is_rare))) {
    collide_left(d, s, place.is_rare, T{0}, out);
  }
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
