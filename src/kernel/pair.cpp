#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/pair.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <hwy/highway.h>

#include "clipping/collide.hpp"
#include "kernel/lanes-inl.hpp"
#include "kernel/pair.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

using D = hn::CappedTag<float, kMaxVertices>;
using V = hn::Vec<D>;
using P = Lanes2<D>;
inline constexpr int kPart = static_cast<int>(hn::MaxLanes(D()));  // a polygon is 8 / kPart vectors

/// Corners x, y of `from`, kPart of them, one a lane.
HWY_INLINE P load_part(const Vector2<float>* from) {
  P lanes;
#if HWY_TARGET == HWY_SCALAR
  lanes = {hn::Set(D(), from->x()), hn::Set(D(), from->y())};
#else
  hn::LoadInterleaved2(D(), from->data(), lanes.x, lanes.y);
#endif
  return lanes;
}

HWY_INLINE void store_part(const P& lanes, Vector2<float>* to) {
#if HWY_TARGET == HWY_SCALAR
  *to = {hn::GetLane(lanes.x), hn::GetLane(lanes.y)};
#else
  hn::StoreInterleaved2(lanes.x, lanes.y, D(), to->data());
#endif
}

HWY_INLINE P broadcast(const Vector2<float>& v) {
  return {hn::Set(D(), v.x()), hn::Set(D(), v.y())};
}

HWY_INLINE void place_vertices(const ConvexPolygon<float>& b, const Pose<float>& b_in_a,
                               ConvexPolygon<float>& placed) {
  const P rotation = broadcast(b_in_a.rotation);
  const P position = broadcast(b_in_a.position);
  placed.count = b.count;
  placed.radius = b.radius;
  for (int k = 0; k < b.count; k += kPart) {
    const P v = turned<D>(rotation, load_part(&b.vertices[k]));
    store_part({hn::Add(v.x, position.x), hn::Add(v.y, position.y)}, &placed.vertices[k]);
  }
}

HWY_INLINE void place_normals(const ConvexPolygon<float>& b, const Pose<float>& b_in_a,
                              ConvexPolygon<float>& placed) {
  const P rotation = broadcast(b_in_a.rotation);
  for (int k = 0; k < b.count; k += kPart) {
    store_part(turned<D>(rotation, load_part(&b.normals[k])), &placed.normals[k]);
  }
}

/// The lanes of part `k` that hold a corner of a polygon of so many.
HWY_INLINE hn::Mask<D> corners_in(int k, int count) {
  return hn::FirstN(D(), static_cast<std::size_t>(count - k));
}

struct Best {
  float value;
  int index;  ///< the first of equals; -1 where all are NaN
};

/// The greatest of `value(k)`'s lanes over a polygon of `count` corners.
template <class Value>
HWY_INLINE Best greatest_of(int count, const Value& value) {
  const V none = hn::Set(D(), -std::numeric_limits<float>::infinity());
  V parts[kMaxVertices / kPart];
  V most = none;
  for (int k = 0; k < count; k += kPart) {
    V& part = parts[k / kPart];
    part = hn::IfThenElse(corners_in(k, count), value(k), none);
    most = hn::Max(part, most);
  }
  most = hn::MaxOfLanes(D(), most);
  Best best{hn::GetLane(most), -1};
  for (int k = 0; k < count && best.index < 0; k += kPart) {
    const auto at = hn::FindFirstTrue(D(), hn::Eq(parts[k / kPart], most));
    if (at >= 0) best.index = k + static_cast<int>(at);
  }
  return best;
}

/// `clipping::greatest_separation`, which has no need to stop early.
HWY_INLINE Best greatest_separation(const ConvexPolygon<float>& polygon,
                                    const ConvexPolygon<float>& other) {
  return greatest_of(polygon.count, [&](int k) {
    const P origin = load_part(&polygon.vertices[k]);
    const P normal = load_part(&polygon.normals[k]);
    V least = hn::Set(D(), std::numeric_limits<float>::infinity());
    for (const Vector2<float>& corner : other.corners()) {
      least = hn::Min(dot<D>(normal, subtract<D>(broadcast(corner), origin)), least);
    }
    return least;
  });
}

/// `clipping::incident_edge`: the greatest of the opposite products.
HWY_INLINE int incident_edge(const ConvexPolygon<float>& polygon,
                             const Vector2<float>& reference_normal) {
  const P normal = broadcast(reference_normal);
  return greatest_of(polygon.count,
                     [&](int k) { return hn::Neg(dot<D>(normal, load_part(&polygon.normals[k]))); })
      .index;
}

/// Whether a face has every corner in front of it by more than `limit`: corners k, k + 1, ... of
/// `count` being `corners(k)`.
template <class Corners>
HWY_INLINE bool face_separates(const Vector2<float>& origin, const Vector2<float>& normal,
                               float limit, int count, const Corners& corners) {
  const P from = broadcast(origin);
  const P along = broadcast(normal);
  for (int k = 0; k < count; k += kPart) {
    const V distance = dot<D>(along, subtract<D>(corners(k), from));
    const auto is_near = hn::Not(hn::Gt(distance, hn::Set(D(), limit)));
    if (!hn::AllFalse(D(), hn::And(corners_in(k, count), is_near))) return false;
  }
  return true;
}

/// Whether the hinted face separates still. Nothing is stored on the way to an answer.
HWY_INLINE bool hint_separates(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                               const Pose<float>& b_in_a, const FaceHint* hint) {
  if (hint == nullptr || hint->face < 0) return false;
  const int face = hint->face;
  const float limit = a.radius + b.radius;
  if (hint->side == Side::a) {
    const P rotation = broadcast(b_in_a.rotation);
    const P position = broadcast(b_in_a.position);
    return face < a.count &&
           face_separates(a.vertices[face], a.normals[face], limit, b.count, [&](int k) -> P {
             const P v = turned<D>(rotation, load_part(&b.vertices[k]));
             return {hn::Add(v.x, position.x), hn::Add(v.y, position.y)};
           });
  }
  return face < b.count &&
         face_separates(transform(b_in_a, b.vertices[face]),
                        rotate<float>(b_in_a.rotation, b.normals[face]), limit, a.count,
                        [&](int k) { return load_part(&a.vertices[k]); });
}

/// What queries and manifolds begin with; `of_b` is set where A does not separate.
struct Separated {
  PairSeparation found;
  Best of_a{};
  Best of_b{};
};

/// `placed` becomes B in A's frame, its normals only where A does not separate.
HWY_INLINE Separated separate(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                              const Pose<float>& b_in_a, ConvexPolygon<float>& placed) {
  const float total_radius = a.radius + b.radius;
  Separated s;
  place_vertices(b, b_in_a, placed);
  s.of_a = greatest_separation(a, placed);
  s.found = {false, s.of_a.value, {Side::a, s.of_a.index}};
  if (s.of_a.value > total_radius) return s;
  place_normals(b, b_in_a, placed);
  s.of_b = greatest_separation(placed, a);
  const bool b_separates = s.of_b.value > total_radius;
  if (b_separates || s.of_b.value > s.of_a.value) {
    s.found = {false, s.of_b.value, {Side::b, s.of_b.index}};
  }
  s.found.touches = !b_separates;
  return s;
}

PairSeparation separation(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                          const Pose<float>& b_in_a, FaceHint* hint) {
  ConvexPolygon<float> placed;
  if (hint_separates(a, b, b_in_a, hint)) {
    const bool is_a = hint->side == Side::a;
    placed = transform(b_in_a, b);
    return {false,
            clipping::face_separation(is_a ? a : placed, hint->face, is_a ? placed : a).separation,
            *hint};
  }
  const PairSeparation found = separate(a, b, b_in_a, placed).found;
  if (hint != nullptr) *hint = found.face;
  return found;
}

bool touches(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
             const Pose<float>& b_in_a, FaceHint* hint) {
  if (hint_separates(a, b, b_in_a, hint)) return false;
  ConvexPolygon<float> placed;
  const PairSeparation found = separate(a, b, b_in_a, placed).found;
  if (hint != nullptr) *hint = found.face;
  return found.touches;
}

Manifold<float> collide_pair(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                             const Pose<float>& b_in_a, float tie_bias, FaceHint* hint) {
  if (hint_separates(a, b, b_in_a, hint)) return {};
  ConvexPolygon<float> placed;
  const auto [found, of_a, of_b] = separate(a, b, b_in_a, placed);
  if (hint != nullptr) *hint = found.face;
  if (!found.touches) return {};
  const bool has_overflowed = of_a.index < 0 || of_b.index < 0;
  if (HWY_UNLIKELY(has_overflowed)) return clipping::collide_in_frame(a, placed, tie_bias);
  const bool take_b = of_b.value > of_a.value + tie_bias;
  const Best& chosen = take_b ? of_b : of_a;
  const ConvexPolygon<float>& reference = take_b ? placed : a;
  const int incident = incident_edge(take_b ? a : placed, reference.normals[chosen.index]);
  const Manifold<float> manifold = clipping::clip_features<float>(
      a, placed, {take_b ? Side::b : Side::a, chosen.index, incident});
  if (tie_bias > 0 && manifold.count > 0) return manifold;
  return clipping::misses_deepest(a, placed, manifold, chosen.value, found.separation)
             ? clipping::deepest_contact(a, placed)
             : manifold;
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::kernel {

HWY_EXPORT(collide_pair);
HWY_EXPORT(separation);
HWY_EXPORT(touches);

Manifold<float> collide(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                        const Pose<float>& b_in_a, float tie_bias, FaceHint* hint) {
  return HWY_DYNAMIC_DISPATCH(collide_pair)(a, b, b_in_a, tie_bias, hint);
}

bool touches(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
             const Pose<float>& b_in_a, FaceHint* hint) {
  return HWY_DYNAMIC_DISPATCH(touches)(a, b, b_in_a, hint);
}

PairSeparation separation(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                          const Pose<float>& b_in_a, FaceHint* hint) {
  return HWY_DYNAMIC_DISPATCH(separation)(a, b, b_in_a, hint);
}

}  // namespace manifuzz::kernel
#endif
