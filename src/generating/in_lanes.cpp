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
bool plain_normals(const float* vertices, int count, float* normals) {
  const LanePoints corners = load_points(vertices);
  const LanePoints edges = next(corners, count) - corners;
  if (!is_plainly_convex(edges, count)) return false;
  // The quotients are off by up to 5 roundoffs from what make_polygon rounds to floats.
  constexpr double off = 0x1p-50;
  const LanePoints unit = clockwise_quarter(edges / root(dot(edges, edges)));
  const LanePoints rounded = store_rounded(unit * in_every_lane(1 + off), normals);
  const LanePoints differs = store_rounded(unit * in_every_lane(1 - off), normals) - rounded;
  const Lanes unsure = magnitude(differs.x) + magnitude(differs.y);
  return (bits(unsure > in_every_lane(0)) & ((1U << count) - 1)) == 0;
}

/// A polygon's corners, turned as in the world about its own origin.
HWY_INLINE LanePoints standing(const Body& body) {
  return turned(static_cast<double>(body.pose.rotation.x()),
                static_cast<double>(body.pose.rotation.y()),
                load_points(body.polygon.vertices[0].data()));
}

/// The faces of one polygon; `sign` is -1 for B's, whose outward is towards A. All faces at once
/// meet each corner of the other.
HWY_INLINE void fill_faces(const LanePoints& from, int count, const LanePoints& to, int count_of_to,
                           double sign, FacesOf& faces) {
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
  faces.count = count;
  store(select(used, in_every_lane(sign) * normals.x, in_every_lane(0)), faces.normals_x.data());
  store(select(used, in_every_lane(sign) * normals.y, in_every_lane(0)), faces.normals_y.data());
  store(select(used, dot(normals, from) - least, in_every_lane(kInfinity)), faces.offsets.data());
}

void fill_all_faces(const PairCase& pair, Faces& faces) {
  const LanePoints a = standing(pair.a);
  const LanePoints b = standing(pair.b);
  fill_faces(a, pair.a.polygon.count, b, pair.b.polygon.count, 1, faces.a);
  fill_faces(b, pair.b.polygon.count, a, pair.a.polygon.count, -1, faces.b);
}

/// How far along `direction`; NaN where there is no such place.
double way(const Faces& faces, const double* start, const double* direction, double target) {
  const Lanes parallel = in_every_lane(1e-12);
  const Lanes minus_parallel = in_every_lane(-1e-12);
  const Lanes infinity = in_every_lane(kInfinity);
  Lanes last = infinity;
  Lanes minus_first = infinity;
  unsigned blocked = 0;
  for (const FacesOf* const of : {&faces.a, &faces.b}) {
    const LanePoints normals{load(of->normals_x.data()), load(of->normals_y.data())};
    const Lanes speed = dot(normals, in_every_lane(direction[0], direction[1]));
    const Lanes separation =
        dot(normals, in_every_lane(start[0], start[1])) - load(of->offsets.data());
    const Lanes room = in_every_lane(target) - separation;
    const Lanes until = room / speed;
    const LaneMask ahead = speed > parallel;
    const LaneMask behind = minus_parallel > speed;
    last = lesser(select(ahead, until, infinity), last);
    minus_first = lesser(select(behind, -until, infinity), minus_first);
    blocked |= bits(in_every_lane(0) > room) & ~(bits(ahead) | bits(behind));
  }
  const double until = least_of(last);
  const bool is_none = blocked != 0 || -least_of(minus_first) > until;
  return is_none ? std::numeric_limits<double>::quiet_NaN() : until;
}

}  // namespace manifuzz::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz {

HWY_EXPORT(plain_normals);
HWY_EXPORT(fill_all_faces);
HWY_EXPORT(way);

bool set_plain_normals(ConvexPolygon<float>& polygon) {
  return polygon.count >= kMinVertices &&
         HWY_DYNAMIC_DISPATCH(plain_normals)(polygon.vertices[0].data(), polygon.count,
                                             polygon.normals[0].data());
}

Faces faces_of(const PairCase& pair) {
  Faces faces;
  HWY_DYNAMIC_DISPATCH(fill_all_faces)(pair, faces);
  return faces;
}

Vector2<double> slide(const Faces& faces, const Vector2<double>& start,
                      const Vector2<double>& direction, double target) {
  const double until = HWY_DYNAMIC_DISPATCH(way)(faces, start.data(), direction.data(), target);
  return std::isnan(until) ? start : start + until * direction;
}

}  // namespace manifuzz
#endif
