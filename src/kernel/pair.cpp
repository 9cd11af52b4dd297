#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/pair.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <bit>
#include <cmath>
#include <hwy/highway.h>

#include "kernel/deepest_contact.hpp"
#include "kernel/pair-inl.hpp"
#include "kernel/pair.hpp"
#include "kernel/pair_clip-inl.hpp"
#include "kernel/round_pairs.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// How far the other polygon lies in front of the hinted face, where it still separates. Which of
/// the two poses is the trivial one is chosen without a branch: it would be taken at random.
struct HintedFace {
  bool separates = false;
  FaceLanes separation[kParts];
};

HWY_INLINE HintedFace try_hint(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                               const FaceHint* hint) {
  HintedFace result;
  if (hint == nullptr || hint->face < 0) return result;
  static constexpr float kAtHome[4] = {0, 0, 1, 0};
  const bool is_a = hint->side == Side::a;
  const ShapeRows& shape = is_a ? a : b;
  const ShapeRows& other = is_a ? b : a;
  if (hint->face >= shape.count) return result;
  const float* const of_b = b_in_a.position.data();
  const LanePose<Faces> pose = lane_pose(is_a ? kAtHome : of_b);
  const LanePose<Faces> pose_of_other = lane_pose(is_a ? of_b : kAtHome);
  const int k = hint->face;
  const FaceLanes2 origin = transformed(pose, in_every_lane(shape.x[k], shape.y[k]));
  const FaceLanes2 normal =
      turned<Faces>(pose.rotation, in_every_lane(shape.normal_x[k], shape.normal_y[k]));
  const FaceLanes limit = hn::Set(Faces(), a.radius + b.radius);
  result.separates = true;
  for (int p = 0; p < kParts; ++p) {
    const FaceLanes2 corner = transformed(pose_of_other, vertices(other, p * kPart));
    result.separation[p] = dot<Faces>(normal, subtract<Faces>(corner, origin));
    result.separates =
        result.separates && hn::AllTrue(Faces(), hn::Gt(result.separation[p], limit));
  }
  return result;
}

/// A's or B's, without a branch: it would go either way at random.
HWY_INLINE int chosen(bool is_b, int of_a, int of_b) {
  return of_a ^ ((of_a ^ of_b) & -static_cast<int>(is_b));
}

HWY_INLINE float chosen(bool is_b, float of_a, float of_b) {
  return std::bit_cast<float>(
      chosen(is_b, std::bit_cast<std::int32_t>(of_a), std::bit_cast<std::int32_t>(of_b)));
}

/// Both polygons' faces of greatest separation; `of_b` is set where A's does not separate.
struct Separations {
  Extreme of_a;
  Extreme of_b;
  PairSeparation found;
};

/// `placed` becomes B in A's frame.
HWY_INLINE Separations separate(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                                ShapeRows& placed) {
  const float total_radius = a.radius + b.radius;
  place(b, lane_pose(b_in_a.position.data()), placed);
  Separations s;
  s.of_a = greatest(face_separations(a, placed));
  s.found = {false, s.of_a.value, {Side::a, s.of_a.face}};
  if (s.of_a.value > total_radius) return s;
  s.of_b = greatest(face_separations(placed, a));
  const bool b_leads = s.of_b.value > s.of_a.value;
  s.found.touches = !(s.of_b.value > total_radius);
  s.found.separation = std::max(s.of_a.value, s.of_b.value);
  s.found.face = {static_cast<Side>(b_leads), chosen(b_leads, s.of_a.face, s.of_b.face)};
  return s;
}

PairSeparation separation(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                          FaceHint* hint) {
  const HintedFace hinted = try_hint(a, b, b_in_a, hint);
  if (hinted.separates) {
    FaceLanes least = hinted.separation[0];
    for (int p = 1; p < kParts; ++p) least = hn::Min(hinted.separation[p], least);
    return {false, hn::GetLane(hn::MinOfLanes(Faces(), least)), *hint};
  }
  ShapeRows placed;
  const PairSeparation found = separate(a, b, b_in_a, placed).found;
  if (hint != nullptr) *hint = found.face;
  return found;
}

bool touches(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a, FaceHint* hint) {
  if (try_hint(a, b, b_in_a, hint).separates) return false;
  ShapeRows placed;
  const PairSeparation found = separate(a, b, b_in_a, placed).found;
  if (hint != nullptr) *hint = found.face;
  return found.touches;
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void clear(Manifold<float>& manifold) {
  manifold = {};
}

HWY_INLINE void clip_touching(const ShapeRows& a, const ShapeRows& placed, const Separations&,
                              float tie_bias, Manifold<float>& manifold) {
  manifold = collide_cleanly(a, placed, tie_bias);
}

#else

/// In parts as wide as those in which it is read back: anything else would stall.
HWY_INLINE void clear(Manifold<float>& manifold) {
  for (int k = 0; k < 12; k += 4) {
    hn::StoreU(hn::Zero(Ends()), Ends(), reinterpret_cast<float*>(&manifold) + k);
  }
}

/// The edge of `incident` whose normal is most opposed to that of the reference face.
HWY_INLINE int incident_edge(const ShapeRows& reference, int face, const ShapeRows& incident) {
  return least(dots(incident, reference.normal_x[face], reference.normal_y[face])).face;
}

/// The manifold of polygons that no face separates. Nearly always an end is kept that is as deep as
/// the overlap.
HWY_INLINE void clip_touching(const ShapeRows& a, const ShapeRows& placed, const Separations& s,
                              float tie_bias, Manifold<float>& manifold) {
  const float total_radius = a.radius + placed.radius;
  const bool take_b = s.of_b.value > s.of_a.value + tie_bias;
  const ShapeRows* const polygons[2] = {&a, &placed};
  const ShapeRows& reference = *polygons[take_b];
  const ShapeRows& incident = *polygons[!take_b];
  // Both polygons' edges are sought: the first of them before B's faces are compared.
  const int face = chosen(take_b, s.of_a.face, s.of_b.face);
  const int edge =
      chosen(take_b, incident_edge(a, s.of_a.face, placed), incident_edge(placed, s.of_b.face, a));
  const float separation = chosen(take_b, s.of_a.value, s.of_b.value);
  const PairFeatures features{reference, incident, take_b, face, edge};
  const ClippedEdge clipped = clip_to_slab(features, total_radius);
  const KeptEnds kept = keep_behind_face(features, clipped, total_radius, manifold);
  if (HWY_UNLIKELY(!do_signs_tell(kept, total_radius))) {
    manifold = collide_cleanly(a, placed, tie_bias);
    return;
  }
  const Ends d;
  const float depth = total_radius - separation;
  if (HWY_LIKELY(!hn::AllFalse(d, hn::Ge(kept.depth, hn::Set(d, depth))))) return;
  if (tie_bias > 0 && manifold.count > 0) return;
  const float missing = depth - hn::GetLane(hn::MaxOfLanes(d, kept.depth));
  if (!might_miss_deepest(features, missing, s.found.separation)) return;
  manifold = with_deepest_contact(a, placed, manifold, separation, s.found.separation);
}

#endif  // HWY_TARGET == HWY_SCALAR

void place_shape(const ShapeRows& shape, const Pose<float>& pose, ShapeRows& placed) {
  place(shape, lane_pose(pose.position.data()), placed);
}

/// The faces of greatest separation of cores, A's and B's, B becoming `placed` in A's frame;
/// whether one separates by more than the total radius.
bool separate_cores(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                    ShapeRows& placed, int (&face)[2]) {
  const float reach = a.radius + b.radius;
  place_shape(b, b_in_a, placed);
  const ShapeRows* const shapes[2] = {&a, &placed};
  for (const int p : {0, 1}) {
    const Extreme of_face = greatest(face_separations(*shapes[p], *shapes[1 - p]));
    if (of_face.value > reach) return true;
    face[p] = of_face.face;
  }
  return false;
}

void collide_pair(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a, float tie_bias,
                  FaceHint* hint, Manifold<float>& manifold) {
  if (try_hint(a, b, b_in_a, hint).separates) return clear(manifold);
  ShapeRows placed;
  const Separations s = separate(a, b, b_in_a, placed);
  if (hint != nullptr) *hint = s.found.face;
  if (!s.found.touches) return clear(manifold);
  clip_touching(a, placed, s, tie_bias, manifold);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::kernel {

HWY_EXPORT(collide_pair);
HWY_EXPORT(place_shape);
HWY_EXPORT(separate_cores);
HWY_EXPORT(separation);
HWY_EXPORT(touches);

namespace {

/// A bit, or none: `Rounding::mitre` is 0.
bool are_round(const ShapeRows& a, const ShapeRows& b) {
  return (static_cast<unsigned>(a.rounding) | static_cast<unsigned>(b.rounding)) != 0;
}

bool has_circle(const ShapeRows& a, const ShapeRows& b) {
  return a.count == 1 || b.count == 1;
}

/// The manifold of a circle and another shape.
Manifold<float> collide_circle(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a) {
  return a.count == b.count ? collide_circles(a, b, b_in_a) : collide_circle_and_core(a, b, b_in_a);
}

Manifold<float> collide_sharp(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                              float tie_bias, FaceHint* hint) {
  Manifold<float> manifold;  // of one name, so that it is made where it is returned
  HWY_DYNAMIC_DISPATCH(collide_pair)(a, b, b_in_a, tie_bias, hint, manifold);
  return manifold;
}

/// The manifold of a pair with a round shape; `placed` becomes B in A's frame, unless one of them
/// is a circle.
Manifold<float> collide_round(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                              float tie_bias, ShapeRows& placed) {
  if (has_circle(a, b)) return collide_circle(a, b, b_in_a);
  int face[2] = {0, 0};
  if (HWY_DYNAMIC_DISPATCH(separate_cores)(a, b, b_in_a, placed, face)) return {};
  return contact_of_cores(a, placed, face, tie_bias);
}

/// Apart from `collide`, so that the stack frame for sharp polygons does not hold this shape.
[[gnu::noinline]] Manifold<float> collide_round(const ShapeRows& a, const ShapeRows& b,
                                                const Pose<float>& b_in_a, float tie_bias) {
  ShapeRows placed;
  return collide_round(a, b, b_in_a, tie_bias, placed);
}

[[gnu::noinline]] PairSeparation separation_of_round(const ShapeRows& a, const ShapeRows& b,
                                                     const Pose<float>& b_in_a) {
  ShapeRows placed;
  const Manifold<float> m = collide_round(a, b, b_in_a, 0, placed);
  const float reach = a.radius + b.radius;  // of both skins
  if (m.count > 0) {
    float depth = m.points[0].depth;
    if (m.count > 1) depth = std::max(depth, m.points[1].depth);
    return {true, reach - depth, {}};
  }
  if (has_circle(a, b)) HWY_DYNAMIC_DISPATCH(place_shape)(b, b_in_a, placed);
  return {false,
          std::max(between_outlines(a, placed),
                   std::nextafter(reach, std::numeric_limits<float>::infinity())),
          {}};
}

}  // namespace

Manifold<float> collide(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                        float tie_bias, FaceHint* hint) {
  if (HWY_UNLIKELY(are_round(a, b))) {
    return has_circle(a, b) ? collide_circle(a, b, b_in_a) : collide_round(a, b, b_in_a, tie_bias);
  }
  return collide_sharp(a, b, b_in_a, tie_bias, hint);
}

bool touches(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a, FaceHint* hint) {
  if (HWY_UNLIKELY(are_round(a, b))) return collide_round(a, b, b_in_a, 0).count > 0;
  return HWY_DYNAMIC_DISPATCH(touches)(a, b, b_in_a, hint);
}

PairSeparation separation(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                          FaceHint* hint) {
  if (HWY_UNLIKELY(are_round(a, b))) return separation_of_round(a, b, b_in_a);
  return HWY_DYNAMIC_DISPATCH(separation)(a, b, b_in_a, hint);
}

}  // namespace manifuzz::kernel
#endif
