// Where two cores with faces are nearest, one pair a lane: clipping/nearest.hpp, step by step, as
// far as rounding leaves no doubt.

#if defined(MANIFUZZ_KERNEL_CORES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_CORES_INL
#undef MANIFUZZ_KERNEL_CORES_INL
#else
#define MANIFUZZ_KERNEL_CORES_INL
#endif

#include "kernel/clip-inl.hpp"
#include "kernel/round-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The other polygon's vertices, as seen from a face.
template <class D>
struct BeforeFace {
  hn::Vec<DInt<D>> deepest;       ///< the first of equals
  hn::Mask<D> deepest_is_before;  ///< it lies between the face's ends
  hn::Mask<D> has_vertex;         ///< some vertex does, no farther in front than the deepest and
                                  ///< `roundoff` (`clipping::places_at_face`)
  hn::Vec<DInt<D>> vertex;        ///< the first of these
  Lanes2<D> position;             ///< its
  hn::Vec<D> separation;          ///< its
};

/// `face` is a corner of `polygon`, where the face of greatest separation begins.
template <class D>
HWY_INLINE void look_before_face(D d, const Strip<D>& s, int polygon, const LaneCorner<D>& face,
                                 hn::Vec<D> greatest, hn::Vec<D> roundoff, BeforeFace<D>& seen) {
  const DInt<D> di;
  const auto zero = hn::Zero(d);
  const auto limit = hn::Add(greatest, roundoff);
  const int other = 1 - polygon;
  auto least = hn::Set(d, std::numeric_limits<hn::TFromD<D>>::infinity());
  seen.deepest = seen.vertex = hn::Zero(di);
  seen.position = s.load2(s.corner(other, 0));
  seen.separation = zero;
  seen.deepest_is_before = seen.has_vertex = hn::Lt(zero, zero);
  const Lanes2<D> along = along_face(face.normal);
  for (int j = 0; j < s.count_max[other]; ++j) {
    const Lanes2<D> vertex = s.load2(s.corner(other, j));
    const Lanes2<D> from_first = subtract(vertex, face.vertex);
    const auto separation = dot(face.normal, from_first);
    const auto is_before = hn::And(hn::Gt(dot(along, from_first), zero),
                                   hn::Gt(dot(along, subtract(face.after, vertex)), zero));
    const auto is_less = hn::Lt(separation, least);
    least = hn::IfThenElse(is_less, separation, least);
    seen.deepest = hn::IfThenElse(hn::RebindMask(di, is_less), hn::Set(di, j), seen.deepest);
    seen.deepest_is_before =
        hn::Or(hn::And(is_less, is_before), hn::AndNot(is_less, seen.deepest_is_before));
    const auto is_new =
        hn::AndNot(seen.has_vertex, hn::AndNot(hn::Gt(separation, limit), is_before));
    seen.has_vertex = hn::Or(seen.has_vertex, is_new);
    seen.vertex = hn::IfThenElse(hn::RebindMask(di, is_new), hn::Set(di, j), seen.vertex);
    seen.position = select<D>(is_new, vertex, seen.position);
    seen.separation = hn::IfThenElse(is_new, separation, seen.separation);
  }
}

/// Where each lane's cores are nearest, and the normal there.
template <class D>
struct LaneNearest {
  hn::Mask<D> face_of[2];   ///< A's face is nearest to a vertex of B, or B's to one of A
  LaneCorner<D> corner[2];  ///< the vertex, or where the face begins
  Lanes2<D> on[2];
  Lanes2<D> apart;        ///< from A's place to B's
  Lanes2<D> normal;       ///< from A to B, unit
  hn::Vec<D> distance;    ///< no more than the cores' own, but for rounding
  hn::Mask<D> is_unsure;  ///< rounding hides where they are nearest, or the normal
};

/// One step of `clipping::walk_nearer` for one vertex, towards a place.
template <class D>
HWY_INLINE hn::Vec<DInt<D>> nearer_vertex(D d, const LaneCorner<D>& at, const Lanes2<D>& place) {
  const DInt<D> di;
  const auto zero = hn::Zero(d);
  const auto is_past = [&](const Lanes2<D>& neighbour, const Lanes2<D>& along) {
    return hn::RebindMask(di, hn::And(hn::Gt(dot(along, subtract(place, at.vertex)), zero),
                                      hn::Le(dot(along, subtract(neighbour, place)), zero)));
  };
  const auto previous = is_past(at.before, opposite(along_face(at.normal_before)));
  const auto next = is_past(at.after, along_face(at.normal));
  return hn::IfThenElse(previous, at.index_before, hn::IfThenElse(next, at.index_after, at.index));
}

/// The walk from vertex to vertex, until the line between them is normal to both shapes; `walks`
/// keeps the lanes that have not arrived.
template <class D>
HWY_INLINE void walk_nearer(D d, const Strip<D>& s, hn::Mask<D>& walks,
                            LaneCorner<D> (&corner)[2]) {
  constexpr int kSteps =
      3;  // two of a vertex each are common, and the clean code takes four or more
  for (int step = 0;; ++step) {
    const Lanes2<D> apart = subtract(corner[1].vertex, corner[0].vertex);
    const Lanes2<D> back = opposite(apart);
    const auto are_nearest =
        hn::And(is_normal_at(d, corner[0], apart), is_normal_at(d, corner[1], back));
    walks = hn::AndNot(are_nearest, walks);
    if (step == kSteps || hn::AllFalse(d, walks)) return;
    const auto walks_int = hn::RebindMask(DInt<D>(), walks);
    const auto nearer_a = nearer_vertex(d, corner[0], corner[1].vertex);
    const auto nearer_b = nearer_vertex(d, corner[1], corner[0].vertex);
    find_corner(d, s, 0, hn::IfThenElse(walks_int, nearer_a, corner[0].index), corner[0]);
    find_corner(d, s, 1, hn::IfThenElse(walks_int, nearer_b, corner[1].index), corner[1]);
  }
}

/// The places of a vertex before the inside of a face, where some are nearest.
template <class D>
HWY_INLINE void take_face(int polygon, hn::Mask<D> where, const LaneCorner<D>& face,
                          const BeforeFace<D>& seen, LaneNearest<D>& nearest) {
  const Lanes2<D> out = scaled<D>(seen.separation, face.normal);
  const Lanes2<D> foot = subtract(seen.position, out);
  const bool is_a = polygon == 0;
  nearest.on[polygon] = select<D>(where, foot, nearest.on[polygon]);
  nearest.on[1 - polygon] = select<D>(where, seen.position, nearest.on[1 - polygon]);
  nearest.apart = select<D>(where, is_a ? out : opposite(out), nearest.apart);
  nearest.normal = select<D>(where, is_a ? face.normal : opposite(face.normal), nearest.normal);
}

/// `faces` are where the faces of greatest separation begin; lanes that do not `matter` may be
/// anything.
template <class D>
HWY_INLINE void find_nearest(D d, const Strip<D>& s, const LaneSearch<D>& found,
                             const LaneCorner<D> (&faces)[2], const BeforeFace<D> (&seen)[2],
                             hn::Vec<D> roundoff, hn::Mask<D> matter, LaneNearest<D>& nearest) {
  using VI = hn::Vec<DInt<D>>;
  const DInt<D> di;
  const auto zero = hn::Zero(d);
  const auto a_first = hn::Ge(found.of[0], found.of[1]);
  const auto greatest = hn::Max(found.of[0], found.of[1]);
  const auto least = hn::Sub(hn::Min(greatest, zero), roundoff);
  const auto may = [&](int p) {
    return hn::AndNot(hn::Lt(found.of[p], least), seen[p].has_vertex);
  };
  const auto by_a = hn::And(may(0), hn::Or(a_first, hn::Not(may(1))));
  const auto by_b = hn::AndNot(by_a, may(1));
  const auto choose = [&](const VI& of_face_a, const VI& of_face_b, const VI& first_a,
                          const VI& first_b) {
    const VI walk = hn::IfThenElse(hn::RebindMask(di, a_first), first_a, first_b);
    return hn::IfThenElse(hn::RebindMask(di, by_a), of_face_a,
                          hn::IfThenElse(hn::RebindMask(di, by_b), of_face_b, walk));
  };
  nearest.face_of[0] = by_a;
  nearest.face_of[1] = by_b;
  find_corner(d, s, 0, choose(found.face[0], seen[1].vertex, found.face[0], seen[1].deepest),
              nearest.corner[0]);
  find_corner(d, s, 1, choose(seen[0].vertex, found.face[1], seen[0].deepest, found.face[1]),
              nearest.corner[1]);
  const auto by_vertices = hn::AndNot(hn::Or(by_a, by_b), matter);
  nearest.distance = greatest;
  nearest.is_unsure = by_vertices;
  if (!hn::AllFalse(d, by_vertices)) {
    walk_nearer(d, s, nearest.is_unsure, nearest.corner);
    for (const int p : {0, 1}) nearest.on[p] = nearest.corner[p].vertex;
    nearest.apart = subtract(nearest.on[1], nearest.on[0]);
    LaneDirection<D> direction;
    find_direction(d, nearest.apart, zero, direction);
    nearest.normal = direction.unit;
    const auto is_short = hn::Le(direction.length, hn::Set(d, kShortest<hn::TFromD<D>>));
    const auto is_sure = hn::AndNot(nearest.is_unsure, by_vertices);
    nearest.distance = hn::IfThenElse(is_sure, direction.length, greatest);
    nearest.is_unsure = hn::Or(nearest.is_unsure, hn::And(by_vertices, is_short));
  } else {
    nearest.on[0] = nearest.on[1] = nearest.apart = nearest.normal = {zero, zero};
  }
  take_face(0, by_a, faces[0], seen[0], nearest);
  take_face(1, by_b, faces[1], seen[1], nearest);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
