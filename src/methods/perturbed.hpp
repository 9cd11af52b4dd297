#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "clipping/deepest_contact.hpp"

// The article's third way without clipping: a detection that finds one point is asked again with
// one shape turned a little, each way.
//
//   turn      about the point found first, by the chord from there to the farthest place along the
//             contact where both shapes are in front of each other, and lifted by the point's
//             depth: at both ends of the chord the shapes then just touch
//   map back  what the turned shapes have for a point to where the shape stands
//   measure   how deep both shapes overlap there, anew, along the normal found first
//
// The chord is what decides the angle. Shapes are convex, so their overlap over the contact's
// places is concave: between the chord's ends it is above the chord, and what is most above it the
// turned shapes have for their deepest point. If that place does not touch as the shapes stand, the
// contact ends before it, and the next chord goes there. If the chord's own end touches, the chord
// goes to no depth instead, and the end is above it. So both ends are found, however short an edge
// is, unless it is tilted by more than turns go: a turn is not a shear, and by more than an eighth
// of a half turn (Bullet's limit, too) other faces of the turned shapes come into play. To turn A
// or to turn B back is the same question: both are asked in A's frame, and the pose alone is
// turned, no vertex.

namespace manifuzz::methods {

/// A place on a core's outline.
template <class Scalar>
struct OutlinePlace {
  Vector2<Scalar> position{0, 0};  ///< in the core's frame
  Feature feature;                 ///< the vertex, or the face that it is inside of
};

/// Where the line of places that lie `at` along a unit direction leaves a core, in the direction
/// `out`: of the outline's places on that line, and of vertices within `near` of it, a length, the
/// farthest. The line meets the core. An edge all but along `out` may have either end on the line,
/// as rounding has it; the farther one is on the side that looks there.
template <class Scalar>
OutlinePlace<Scalar> outermost_place(const ConvexPolygon<Scalar>& core, const Vector2<Scalar>& out,
                                     const Vector2<Scalar>& along, Scalar at, Scalar near) {
  OutlinePlace<Scalar> outermost;
  Scalar greatest = -std::numeric_limits<Scalar>::infinity();
  const auto look = [&](const Vector2<Scalar>& position, Feature feature) {
    const Scalar height = out.dot(position);
    if (height <= greatest) return;
    greatest = height;
    outermost = {position, feature};
  };
  for (int i = 0; i < core.count; ++i) {
    const Vector2<Scalar>& from = core.vertices[i];
    const Vector2<Scalar>& to = core.vertices[core.next(i)];
    const Scalar since = at - along.dot(from);
    const Scalar until = along.dot(to) - at;
    if (std::abs(since) <= near) look(from, clipping::vertex(i));
    if ((since > 0 && until > 0) || (since < 0 && until < 0)) {
      look(from + since / (since + until) * (to - from), clipping::face(i));
    }
  }
  return outermost;
}

/// Both shapes as a contact's normal sees them: places along the tangent, and how deep the shapes
/// overlap there.
template <class Scalar>
class Alongside {
 public:
  /// In one frame; both must outlive it. The normal is unit, from A to B.
  Alongside(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
            const Manifold<Scalar>& contact)
      : a_(a),
        b_(b),
        normal_(contact.normal),
        along_(counter_clockwise_quarter(contact.normal)),
        reference_(contact.reference) {
    const auto [low_a, high_a] = ends_of(a);
    const auto [low_b, high_b] = ends_of(b);
    low_ = std::max(low_a, low_b);
    high_ = std::min(high_a, high_b);
  }

  /// The contact's normal.
  const Vector2<Scalar>& normal() const { return normal_; }
  /// Whose face the normal is of.
  Side reference() const { return reference_; }
  /// The tangent: the normal turned by a quarter counter-clockwise.
  const Vector2<Scalar>& along() const { return along_; }
  /// How far along the tangent a point lies.
  Scalar place(const Vector2<Scalar>& point) const { return along_.dot(point); }
  /// The last place in front of both cores along the tangent, or against it.
  Scalar last(bool is_along) const { return is_along ? high_ : low_; }

  /// How deep the cores overlap at a place, with both radii, or at a vertex within `off` of it, a
  /// length; none where no core is in front of the other.
  std::optional<Scalar> depth_at(Scalar place, Scalar off) const {
    if (low_ > high_) return std::nullopt;
    return depth_of(overlap_at(place, off));
  }
  /// The contact point at a place: a vertex's own where one is within `off`, a length, and no
  /// farther out than both cores reach. On the incident core. None where they are apart there.
  std::optional<ContactPoint<Scalar>> point_at(Scalar place, Scalar off) const {
    if (low_ > high_) return std::nullopt;
    const Overlap overlap = overlap_at(place, off);
    const Scalar depth = depth_of(overlap);
    if (depth < 0) return std::nullopt;
    const OutlinePlace<Scalar>& incident = reference_ == Side::a ? overlap.on_b : overlap.on_a;
    return ContactPoint<Scalar>{
        incident.position, depth, {overlap.on_a.feature, overlap.on_b.feature}};
  }

 private:
  /// Where a line along the normal leaves A's core, and where it enters B's.
  struct Overlap {
    OutlinePlace<Scalar> on_a;
    OutlinePlace<Scalar> on_b;
  };
  Overlap overlap_at(Scalar place, Scalar off) const {
    const Scalar at = std::clamp(nearest_vertex(place, off), low_, high_);
    // Both ends of an edge are placed within 6 u E.
    const Scalar near = 2 * clipping::separation_roundoff(a_, b_);
    return {outermost_place<Scalar>(a_, normal_, along_, at, near),
            outermost_place<Scalar>(b_, -normal_, along_, at, near)};
  }

  Scalar depth_of(const Overlap& overlap) const {
    return a_.radius + b_.radius - normal_.dot(overlap.on_b.position - overlap.on_a.position);
  }

  struct Ends {
    Scalar low = std::numeric_limits<Scalar>::infinity();
    Scalar high = -std::numeric_limits<Scalar>::infinity();
  };
  Ends ends_of(const ConvexPolygon<Scalar>& core) const {
    Ends ends;
    for (const Vector2<Scalar>& corner : core.corners()) {
      ends.low = std::min(ends.low, place(corner));
      ends.high = std::max(ends.high, place(corner));
    }
    return ends;
  }
  Scalar nearest_vertex(Scalar to, Scalar off) const {
    Scalar nearest = to;
    Scalar least = off;
    for (const ConvexPolygon<Scalar>* const core : {&a_, &b_}) {
      for (const Vector2<Scalar>& corner : core->corners()) {
        const Scalar distance = std::abs(place(corner) - to);
        if (distance > least) continue;
        least = distance;
        nearest = place(corner);
      }
    }
    return nearest;
  }

  const ConvexPolygon<Scalar>& a_;
  const ConvexPolygon<Scalar>& b_;
  Vector2<Scalar> normal_;
  Vector2<Scalar> along_;
  Side reference_;
  Scalar low_ = 0;
  Scalar high_ = 0;
};

/// A turn about a pivot, and a shift.
template <class Scalar>
struct TurnAbout {
  Vector2<Scalar> pivot{0, 0};     ///< what is turned about
  Vector2<Scalar> rotation{1, 0};  ///< (cos, sin)
  Vector2<Scalar> shift{0, 0};     ///< after the turn

  /// A pose that is turned.
  Pose<Scalar> turned(const Pose<Scalar>& pose) const {
    return {pivot + shift + rotate<Scalar>(rotation, pose.position - pivot),
            rotate(rotation, pose.rotation)};
  }
  /// Where a point was before.
  Vector2<Scalar> back(const Vector2<Scalar>& point) const {
    return pivot + rotate_back<Scalar>(rotation, point - shift - pivot);
  }
};

/// The tangent of an eighth of a half turn, the largest turn.
inline constexpr double kSteepestChord = 0.41421356237309503;

/// The turn of B after which the shapes just touch both at a contact's point and at a place that is
/// `run` away from it along the tangent, a length with a sign, where they overlap by `depth`, a
/// length; if that is more than 0, or too far below, at the point alone.
template <class Scalar>
TurnAbout<Scalar> turn_by_chord(const Alongside<Scalar>& seen, const ContactPoint<Scalar>& point,
                                Scalar run, Scalar depth) {
  const Scalar steepest = static_cast<Scalar>(kSteepestChord) * std::abs(run);
  const Scalar rise = std::min(point.depth - std::min(depth, Scalar(0)), steepest);
  const Scalar length = std::hypot(run, rise);
  const Scalar sine = std::copysign(rise / length, run);
  const Vector2<Scalar> rotation(std::abs(run) / length, sine);
  // Away from the reference face, which has been turned where it is B's.
  const bool is_turned = seen.reference() == Side::b;
  const Vector2<Scalar> up = is_turned ? rotate(rotation, seen.normal()) : seen.normal();
  return {point.position, rotation, point.depth * up};
}

/// The other end of a contact, along the tangent from the point found first or against it; none
/// where no place is found that touches, deeper than `roundoff`, and is farther away than `off`,
/// lengths both. `detect_turned(turn)` is the detection with B turned.
template <class Scalar, class Detect>
std::optional<ContactPoint<Scalar>> end_of_contact(const Alongside<Scalar>& seen,
                                                   const ContactPoint<Scalar>& first, bool is_along,
                                                   Scalar roundoff, Scalar off,
                                                   const Detect& detect_turned) {
  const Scalar from = seen.place(first.position);
  const Scalar way = is_along ? 1 : -1;
  Scalar run = way * (seen.last(is_along) - from);
  while (run > off) {
    const auto depth = seen.depth_at(from + way * run, Scalar(0));
    if (!depth) return std::nullopt;
    const TurnAbout<Scalar> turn = turn_by_chord(seen, first, way * run, *depth);
    const Manifold<Scalar> found = detect_turned(turn);
    if (found.count == 0 || found.points[0].depth <= roundoff) return std::nullopt;
    const Vector2<Scalar>& position = found.points[0].position;
    // What lies on A has not been turned.
    const bool is_on_b = found.reference == Side::a;
    const Scalar found_run = way * (seen.place(is_on_b ? turn.back(position) : position) - from);
    const bool is_beyond = found_run > off;
    if (const auto point = seen.point_at(from + way * found_run, off); point && is_beyond) {
      return point;
    }
    if (!is_beyond || found_run >= run - off) return std::nullopt;
    run = found_run;
  }
  return std::nullopt;
}

/// Keeps two points of those found: the first, which is the deepest, and the farther of the two on
/// either side of it along the tangent; or these two, where one of them is as deep but for
/// `roundoff`, a length. Places within `off` of each other are one.
template <class Scalar>
void keep_two(const Alongside<Scalar>& seen, const ContactPoint<Scalar>& low,
              const ContactPoint<Scalar>& high, Scalar roundoff, Scalar off,
              Manifold<Scalar>& manifold) {
  const ContactPoint<Scalar> first = manifold.points[0];
  const auto distance = [&](const ContactPoint<Scalar>& point) {
    return std::abs(seen.place(point.position) - seen.place(first.position));
  };
  const bool is_low_farther = distance(low) > distance(high);
  const ContactPoint<Scalar>& farther = is_low_farther ? low : high;
  const ContactPoint<Scalar>& nearer = is_low_farther ? high : low;
  if (distance(farther) <= off) return;
  manifold.count = 2;
  manifold.points[1] = farther;
  const Scalar least = first.depth - roundoff;
  if (farther.depth >= least || nearer.depth >= least) manifold.points[0] = nearer;
  order_points(manifold);
}

/// The manifold of two shapes by a detection that finds one point: `detect(a, b, b_in_a)` gives a
/// manifold of 0 or 1 points in A's frame, B standing at `b_in_a`, and is asked once more for each
/// turn: one each way at least where the contact may go on. The article's way of shapes that are
/// perturbed, each point measured on the shapes as they stand. Polygons that are sharp or mitred:
/// points are on cores. `detection_roundoff`, a length, is how much of a separation may be rounding
/// in a detection that rounds more than the scalar does.
template <class Scalar, class Detect>
Manifold<Scalar> contact_by_perturbing(const ConvexPolygon<Scalar>& a,
                                       const ConvexPolygon<Scalar>& b, const Pose<Scalar>& b_in_a,
                                       const Detect& detect, Scalar detection_roundoff = 0) {
  Manifold<Scalar> manifold = detect(a, b, b_in_a);
  // What only touches has no end that is deeper than rounding.
  if (manifold.count == 0 || !(manifold.points[0].depth > 0)) return manifold;
  const ConvexPolygon<Scalar> placed = transform(b_in_a, b);
  const Alongside<Scalar> seen(a, placed, manifold);
  const Scalar roundoff = std::max(clipping::separation_roundoff(a, placed), detection_roundoff);
  // A detection's point is off by 10 u E, turned and mapped back by three rotations and the sums
  // with the pivot: less than 32 u E in all.
  const Scalar off = 8 * roundoff;
  const ContactPoint<Scalar> first = manifold.points[0];
  const auto detect_turned = [&](const TurnAbout<Scalar>& turn) {
    return detect(a, b, turn.turned(b_in_a));
  };
  const auto end = [&](bool is_along) {
    return end_of_contact(seen, first, is_along, roundoff, off, detect_turned).value_or(first);
  };
  const ContactPoint<Scalar> high = end(true);
  const ContactPoint<Scalar> low = end(false);
  keep_two(seen, low, high, roundoff, off, manifold);
  return manifold;
}

}  // namespace manifuzz::methods
