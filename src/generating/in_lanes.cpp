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
template <int n>
HWY_INLINE bool is_plainly_convex(const LanePoints<n>& edges, int count) {
  const LanePoints<n> before = previous(edges, count);
  const Lanes<n> left = before.x * edges.y;
  const Lanes<n> right = before.y * edges.x;
  const Lanes<n> error = in_every_lane<n>((3 + 16 * kRoundoff) * kRoundoff) *
                         (magnitude(left) + magnitude(right));  // Shewchuk's ccwerrboundA
  const unsigned all = (1U << count) - 1;
  const unsigned climbing = bits(edges.y > in_every_lane<n>(0)) & all;
  const unsigned climbed_before = 2 * climbing | climbing >> (count - 1);
  return (bits(left - right > error) & all) == all &&
         std::popcount(climbing & ~climbed_before) == 1;
}

/// Takes and gives x and y by turns.
template <int n>
HWY_INLINE bool find_plain_normals(const float* vertices, int count, float* normals) {
  const LanePoints<n> corners = load_points<n>(vertices, count);
  const LanePoints<n> edges = next(corners, count) - corners;
  if (!is_plainly_convex(edges, count)) return false;
  // The quotients are off by up to 5 roundoffs from what make_polygon rounds to floats.
  constexpr double off = 0x1p-50;
  const LanePoints<n> unit = clockwise_quarter(edges / root(dot(edges, edges)));
  const LanePoints<n> rounded = store_rounded(unit * in_every_lane<n>(1 + off), normals);
  const LaneMask<n> is_unsure =
      differ(rounded_to_floats(unit * in_every_lane<n>(1 - off)), rounded);
  return (bits(is_unsure) & ((1U << count) - 1)) == 0;
}

bool plain_normals(const float* vertices, int count, float* normals) {
  return find_plain_normals<kParts>(vertices, count, normals);
}

template <int n>
HWY_INLINE bool round_parts(const Outline& outline, ConvexPolygon<float>& polygon) {
  float* const vertices = polygon.vertices[0].data();
  round_to_floats<n>(outline.vertices[0].data(), outline.count, vertices);
  return find_plain_normals<n>(vertices, polygon.count, polygon.normals[0].data());
}

HWY_INLINE bool round_one(const Outline& outline, ConvexPolygon<float>& polygon) {
  return fits_half(polygon.count) ? round_parts<kHalf>(outline, polygon)
                                  : round_parts<kParts>(outline, polygon);
}

bool round_both(const Outline& a, const Outline& b, PairCase& pair) {
  const bool is_a_plain = round_one(a, pair.a.polygon);
  return round_one(b, pair.b.polygon) && is_a_plain;
}

/// A polygon's corners, turned as in the world about its own origin, and the first once more.
struct Standing {
  double x[kMaxVertices + 1];
  double y[kMaxVertices + 1];
  int count = 0;
};

HWY_INLINE void stand(const Body& body, Standing& standing) {
  const LanePoints<> corners = turned(
      static_cast<double>(body.pose.rotation.x()), static_cast<double>(body.pose.rotation.y()),
      load_points(body.polygon.vertices[0].data(), body.polygon.count));
  store(corners.x, standing.x);
  store(corners.y, standing.y);
  // Left unset, a lane might hold a denormal, and its normal be infinite.
  standing.x[kMaxVertices] = standing.y[kMaxVertices] = 0;
  standing.count = body.polygon.count;
  standing.x[standing.count] = standing.x[0];
  standing.y[standing.count] = standing.y[0];
}

/// `FacesOf`, while it is computed with.
template <int n>
struct HalfPlanes {
  LanePoints<n> normals;
  Lanes<n> offsets;
};

/// The faces of one polygon; `sign` is -1 for B's, whose outward is towards A. All faces at once
/// meet each corner of the other.
template <int n>
HWY_INLINE HalfPlanes<n> half_planes(const Standing& from, const Standing& to, double sign) {
  const LanePoints<n> corners{load<n>(from.x), load<n>(from.y)};
  const LanePoints<n> edges = LanePoints<n>{load<n>(from.x + 1), load<n>(from.y + 1)} - corners;
  const LanePoints<n> normals = clockwise_quarter(edges / root(dot(edges, edges)));
  Lanes<n> least = in_every_lane<n>(kInfinity);
  for (int j = 0; j < to.count; ++j) {
    least = lesser(dot(normals, in_every_lane<n>(to.x[j], to.y[j])), least);
  }
  const LaneMask<n> used = first_lanes<n>(from.count);
  return {normals * in_every_lane<n>(sign),
          select(used, dot(normals, corners) - least, in_every_lane<n>(kInfinity))};
}

HWY_INLINE void store(const HalfPlanes<kParts>& from, int count, FacesOf& faces) {
  faces.count = count;
  store(from.normals.x, faces.normals_x.data());
  store(from.normals.y, faces.normals_y.data());
  store(from.offsets, faces.offsets.data());
}

HWY_INLINE HalfPlanes<kParts> load(const FacesOf& faces) {
  return {{load(faces.normals_x.data()), load(faces.normals_y.data())}, load(faces.offsets.data())};
}

void store_faces(const PairCase& pair, Faces& faces) {
  Standing a;
  Standing b;
  stand(pair.a, a);
  stand(pair.b, b);
  store(half_planes<kParts>(a, b, 1), a.count, faces.a);
  store(half_planes<kParts>(b, a, -1), b.count, faces.b);
}

/// What a way along `direction` meets of the faces of one polygon.
struct Meetings {
  Lanes<1> last;         ///< where faces ahead let go
  Lanes<1> minus_first;  ///< minus where faces behind begin to hold
  LaneMask<1> blocked;   ///< by faces that the way runs along
};

template <int n>
HWY_INLINE Meetings meet(const HalfPlanes<n>& planes, const double* start, const double* direction,
                         double target) {
  const Lanes<n> infinity = in_every_lane<n>(kInfinity);
  const Lanes<n> speed = dot(planes.normals, in_every_lane<n>(direction[0], direction[1]));
  const Lanes<n> separation =
      dot(planes.normals, in_every_lane<n>(start[0], start[1])) - planes.offsets;
  const Lanes<n> room = in_every_lane<n>(target) - separation;
  const Lanes<n> until = room / speed;
  const LaneMask<n> ahead = speed > in_every_lane<n>(1e-12);
  const LaneMask<n> behind = in_every_lane<n>(-1e-12) > speed;
  return {least_of_parts(select(ahead, until, infinity)),
          least_of_parts(select(behind, -until, infinity)),
          any_of_parts(without(ahead | behind, in_every_lane<n>(0) > room))};
}

HWY_INLINE Meetings meet_one(const Standing& from, const Standing& to, double sign,
                             const double* start, const double* direction, double target) {
  return fits_half(from.count)
             ? meet(half_planes<kHalf>(from, to, sign), start, direction, target)
             : meet(half_planes<kParts>(from, to, sign), start, direction, target);
}

/// How far along `direction`; NaN where there is no such place.
HWY_INLINE double way(const Meetings& a, const Meetings& b) {
  const double until = least_of(lesser(b.last, a.last));
  const double first = -least_of(lesser(b.minus_first, a.minus_first));
  const bool is_none = bits(a.blocked | b.blocked) != 0 || first > until;
  return is_none ? std::numeric_limits<double>::quiet_NaN() : until;
}

double way_by_faces(const Faces& faces, const double* start, const double* direction,
                    double target) {
  return way(meet(load(faces.a), start, direction, target),
             meet(load(faces.b), start, direction, target));
}

double way_of_pair(const PairCase& pair, const double* start, const double* direction,
                   double target) {
  Standing a;
  Standing b;
  stand(pair.a, a);
  stand(pair.b, b);
  return way(meet_one(a, b, 1, start, direction, target),
             meet_one(b, a, -1, start, direction, target));
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
