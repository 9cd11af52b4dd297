#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "generating/in_lanes.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <bit>
#include <cmath>
#include <hwy/highway.h>
#include <limits>

#include "generating/in_lanes.hpp"
#include "geometry/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::HWY_NAMESPACE {

constexpr double kRoundoff = 0x1p-53;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Whether each corner of a closed chain of edges turns left by more than rounding, and the chain
/// goes round once: as often as edges start to climb. See `find_defect`.
HWY_INLINE bool is_plainly_convex(const LanePoints& edges, int count) {
  const LanePoints before = previous(edges, count);
  const Lanes left = before.x * edges.y;
  const Lanes right = before.y * edges.x;
  const Lanes error = in_every_lane((3 + 16 * kRoundoff) * kRoundoff) *
                      (magnitude(left) + magnitude(right));  // Shewchuk's ccwerrboundA
  const unsigned all = (1U << count) - 1;
  const unsigned climbing = bits(edges.y > in_every_lane(0)) & all;
  const unsigned climbed_before = 2 * climbing | climbing >> (count - 1);
  return (bits(left - right > error) & all) == all &&
         std::popcount(climbing & ~climbed_before) == 1;
}

/// Takes and gives x and y by turns, of kMaxVertices corners and faces.
HWY_INLINE bool find_plain_normals(const float* vertices, int count, float* normals) {
  const LanePoints corners = load_points(vertices);
  const LanePoints edges = next(corners, count) - corners;
  if (!is_plainly_convex(edges, count)) return false;
  // The quotients are off by up to 5 roundoffs from what make_polygon rounds to floats.
  constexpr double off = 0x1p-50;
  const LanePoints unit = clockwise_quarter(edges / root(dot(edges, edges)));
  const LanePoints rounded = store_rounded(unit * in_every_lane(1 + off), normals);
  const LaneMask is_unsure = differ(rounded_to_floats(unit * in_every_lane(1 - off)), rounded);
  return (bits(is_unsure) & ((1U << count) - 1)) == 0;
}

bool plain_normals(const float* vertices, int count, float* normals) {
  return find_plain_normals(vertices, count, normals);
}

HWY_INLINE bool round_one(const Outline& outline, ConvexPolygon<float>& polygon) {
  float* const vertices = polygon.vertices[0].data();
  round_to_floats(outline.vertices[0].data(), vertices);
  return find_plain_normals(vertices, polygon.count, polygon.normals[0].data());
}

bool round_both(const Outline& a, const Outline& b, PairCase& pair) {
  const bool is_a_plain = round_one(a, pair.a.polygon);
  return round_one(b, pair.b.polygon) && is_a_plain;
}

/// A polygon's corners, turned as in the world about its own origin.
HWY_INLINE LanePoints standing(const Body& body) {
  return turned(static_cast<double>(body.pose.rotation.x()),
                static_cast<double>(body.pose.rotation.y()),
                load_points(body.polygon.vertices[0].data()));
}

/// `FacesOf`, while it is computed with.
struct HalfPlanes {
  LanePoints normals;
  Lanes offsets;
};

/// The faces of one polygon; `sign` is -1 for B's, whose outward is towards A. All faces at once
/// meet each corner of the other.
HWY_INLINE HalfPlanes half_planes(const LanePoints& from, int count, const LanePoints& to,
                                  int count_of_to, double sign) {
  const LanePoints edges = next(from, count) - from;
  const LanePoints normals = clockwise_quarter(edges / root(dot(edges, edges)));
  double x[kMaxVertices];
  double y[kMaxVertices];
  store(to.x, x);
  store(to.y, y);
  Lanes least = in_every_lane(kInfinity);
  for (int j = 0; j < count_of_to; ++j) {
    least = lesser(dot(normals, in_every_lane(x[j], y[j])), least);
  }
  const LaneMask used = first_lanes(count);
  const Lanes signs = in_every_lane(sign);
  return {{select(used, signs * normals.x, in_every_lane(0)),
           select(used, signs * normals.y, in_every_lane(0))},
          select(used, dot(normals, from) - least, in_every_lane(kInfinity))};
}

struct HalfPlanesOfBoth {
  HalfPlanes a;
  HalfPlanes b;
};

HWY_INLINE HalfPlanesOfBoth half_planes_of(const PairCase& pair) {
  const int count_a = pair.a.polygon.count;
  const int count_b = pair.b.polygon.count;
  const LanePoints a = standing(pair.a);
  const LanePoints b = standing(pair.b);
  return {half_planes(a, count_a, b, count_b, 1), half_planes(b, count_b, a, count_a, -1)};
}

HWY_INLINE void store(const HalfPlanes& from, int count, FacesOf& faces) {
  faces.count = count;
  store(from.normals.x, faces.normals_x.data());
  store(from.normals.y, faces.normals_y.data());
  store(from.offsets, faces.offsets.data());
}

HWY_INLINE HalfPlanes load(const FacesOf& faces) {
  return {{load(faces.normals_x.data()), load(faces.normals_y.data())}, load(faces.offsets.data())};
}

void store_faces(const PairCase& pair, Faces& faces) {
  const HalfPlanesOfBoth all = half_planes_of(pair);
  store(all.a, pair.a.polygon.count, faces.a);
  store(all.b, pair.b.polygon.count, faces.b);
}

/// What a way along `direction` meets of the faces of one polygon.
struct Meetings {
  Lanes last;         ///< where each face ahead lets go
  Lanes minus_first;  ///< minus where each face behind begins to hold
  LaneMask blocked;   ///< by faces that the way runs along
};

HWY_INLINE Meetings meet(const HalfPlanes& planes, const double* start, const double* direction,
                         double target) {
  const Lanes infinity = in_every_lane(kInfinity);
  const Lanes speed = dot(planes.normals, in_every_lane(direction[0], direction[1]));
  const Lanes separation = dot(planes.normals, in_every_lane(start[0], start[1])) - planes.offsets;
  const Lanes room = in_every_lane(target) - separation;
  const Lanes until = room / speed;
  const LaneMask ahead = speed > in_every_lane(1e-12);
  const LaneMask behind = in_every_lane(-1e-12) > speed;
  return {select(ahead, until, infinity), select(behind, -until, infinity),
          without(ahead | behind, in_every_lane(0) > room)};
}

/// How far along `direction`; NaN where there is no such place.
HWY_INLINE double way(const HalfPlanesOfBoth& all, const double* start, const double* direction,
                      double target) {
  const Meetings a = meet(all.a, start, direction, target);
  const Meetings b = meet(all.b, start, direction, target);
  const double until = least_of(lesser(b.last, a.last));
  const double first = -least_of(lesser(b.minus_first, a.minus_first));
  const bool is_none = bits(a.blocked | b.blocked) != 0 || first > until;
  return is_none ? std::numeric_limits<double>::quiet_NaN() : until;
}

double way_by_faces(const Faces& faces, const double* start, const double* direction,
                    double target) {
  return way({load(faces.a), load(faces.b)}, start, direction, target);
}

double way_of_pair(const PairCase& pair, const double* start, const double* direction,
                   double target) {
  return way(half_planes_of(pair), start, direction, target);
}

}  // namespace manifuzz::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz {

HWY_EXPORT(plain_normals);
HWY_EXPORT(round_both);
HWY_EXPORT(store_faces);
HWY_EXPORT(way_by_faces);
HWY_EXPORT(way_of_pair);

bool set_plain_normals(ConvexPolygon<float>& polygon) {
  return polygon.count >= kMinVertices &&
         HWY_DYNAMIC_DISPATCH(plain_normals)(polygon.vertices[0].data(), polygon.count,
                                             polygon.normals[0].data());
}

bool round_plainly(const Outline& a, const Outline& b, PairCase& pair) {
  const bool is_plain = HWY_DYNAMIC_DISPATCH(round_both)(a, b, pair);
  return is_plain && a.count >= kMinVertices && b.count >= kMinVertices;
}

Faces faces_of(const PairCase& pair) {
  Faces faces;
  HWY_DYNAMIC_DISPATCH(store_faces)(pair, faces);
  return faces;
}

namespace {

Vector2<double> moved_along(double until, const Vector2<double>& start,
                            const Vector2<double>& direction) {
  return std::isnan(until) ? start : start + until * direction;
}

}  // namespace

Vector2<double> slide(const Faces& faces, const Vector2<double>& start,
                      const Vector2<double>& direction, double target) {
  return moved_along(
      HWY_DYNAMIC_DISPATCH(way_by_faces)(faces, start.data(), direction.data(), target), start,
      direction);
}

Vector2<double> slide(const PairCase& pair, const Vector2<double>& start,
                      const Vector2<double>& direction, double target) {
  return moved_along(
      HWY_DYNAMIC_DISPATCH(way_of_pair)(pair, start.data(), direction.data(), target), start,
      direction);
}

}  // namespace manifuzz
#endif
