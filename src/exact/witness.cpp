#include "exact/witness.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace manifuzz::exact {
namespace {

// Everything is multiplied by |n|: places on the tangent, heights and gaps are then rational, and
// lengths are rational times |n|, so that all lies in Q(|n|). In pairs of doubles the same, which
// proves most witnesses.

/// rational + root |n|, and that divided by a number.
Quadratic scaled(const Rational& rational, double root, const Rational& squared) {
  return {rational, Rational(root), squared};
}
DoubleDouble scaled(const DoubleDouble& rational, double root, const DoubleDouble& squared) {
  return rational + DoubleDouble(root) * sqrt(squared);
}
Quadratic times(const Quadratic& value, const Rational& factor) {
  return {value.rational * factor, value.root * factor, value.radicand};
}
DoubleDouble times(const DoubleDouble& value, const DoubleDouble& factor) {
  return value * factor;
}

int sign_of(const DoubleDouble& value) {
  return value.high > 0 ? 1 : value.high < 0 ? -1 : 0;
}
int sign_of(const Rational& value) {
  return value.sign();
}
int sign_of(const Quadratic& value) {
  return *sign(value);
}

template <class Number>
using ElementOfPlace = decltype(scaled(Number(0.0), 0.0, Number(0.0)));

/// From `low` to `high`; empty where that is not so.
template <class E>
struct Interval {
  E low;
  E high;

  bool is_empty() const { return sign_of(high - low) < 0; }
  void narrow(const E& least, const E& most) {
    if (sign_of(least - low) > 0) low = least;
    if (sign_of(high - most) > 0) high = most;
  }
  void widen_to(const E& value) {
    if (sign_of(low - value) > 0) low = value;
    if (sign_of(value - high) > 0) high = value;
  }
};

/// Begins an interval with a value, or widens it to that.
template <class E>
void add(const E& value, std::optional<Interval<E>>& all) {
  if (!all) all = Interval<E>{value, value};
  all->widen_to(value);
}

/// Tangent places, heights and lengths, as they are along one normal.
template <class Number>
class Frame {
 public:
  using E = ElementOfPlace<Number>;

  Frame(const Truth& truth, const Along& along)
      : pair_(truth.stored()), normal_(along.normal<Number>()), squared_(dot(normal_, normal_)) {}

  Number place(const Point<Number>& p) const { return cross(normal_, p); }
  Number height(const Point<Number>& p) const { return dot(normal_, p); }
  E element(const Number& number) const { return scaled(number, 0, squared_); }
  E length(double world) const { return scaled(Number(0.0), world, squared_); }
  E radii() const { return length(pair_.a.polygon.radius) + length(pair_.b.polygon.radius); }

  /// The heights of a side's edges that face the other, where they lie at these places, and of all
  /// vertices there if the core is no wider than `narrow`; none where nothing lies there. Of edges
  /// steeper than `steepest`, none are seen.
  std::optional<Interval<E>> heights(Side side, const Interval<E>& places, const E& narrow,
                                     std::optional<double> steepest) const {
    std::optional<Interval<E>> all;
    const auto& polygon = pair_[side].polygon;
    for (int i = 0; i < polygon.count; ++i) {
      // A's upper edges run along the tangent, B's lower ones against it.
      Point<Number> from = vertex<Number>(pair_, side, i);
      Point<Number> to = vertex<Number>(pair_, side, polygon.next(i));
      if (side == Side::b) std::swap(from, to);
      add_heights(from, to, places, steepest, all);
    }
    if (is_no_wider(side, narrow)) add_vertices(side, places, all);
    return all;
  }

 private:
  static bool is_within(const E& value, const E& most) { return sign_of(most - value) >= 0; }
  /// Whether the core takes no more than that along the tangent.
  bool is_no_wider(Side side, const E& most) const {
    std::optional<Interval<E>> all;
    for (int i = 0; i < pair_[side].polygon.count; ++i) {
      add(element(place(vertex<Number>(pair_, side, i))), all);
      if (!is_within(all->high - all->low, most)) return false;
    }
    return true;
  }
  void add_vertices(Side side, const Interval<E>& places, std::optional<Interval<E>>& all) const {
    for (int i = 0; i < pair_[side].polygon.count; ++i) {
      const Point<Number> corner = vertex<Number>(pair_, side, i);
      const E at = element(place(corner));
      if (!is_within(places.low, at) || !is_within(at, places.high)) continue;
      add(element(height(corner)), all);
    }
  }
  void add_heights(const Point<Number>& from, const Point<Number>& to, const Interval<E>& places,
                   std::optional<double> steepest, std::optional<Interval<E>>& all) const {
    const Number run = place(to) - place(from);
    if (sign_of(run) <= 0) return;
    const Number rise = height(to) - height(from);
    if (steepest) {
      const Number most = run * Number(*steepest);
      if (sign_of(most - rise) <= 0 || sign_of(most + rise) <= 0) return;
    }
    Interval<E> seen{element(place(from)), element(place(to))};
    seen.narrow(places.low, places.high);
    if (seen.is_empty()) return;
    for (const E& at : {seen.low, seen.high}) {
      add(element(height(from)) + times(at - element(place(from)), Number(rise / run)), all);
    }
  }

  const StoredPair& pair_;
  Point<Number> normal_;
  Number squared_;  ///< |n|^2
};

/// From A's position, in the world: a point of A's frame.
template <class Number>
Point<Number> seen_in_world(const StoredPair& pair, const Vector2<double>& local) {
  return turned(pair.a, Point<Number>{Number(local.x()), Number(local.y())});
}

/// Whether some top and bottom of these have that difference, and lie so that the point has one of
/// its heights.
template <class E>
bool fits(Interval<E> top, Interval<E> bottom, const Height& claimed, const Interval<E>& height,
          Interval<E> difference) {
  if (claimed.of_bottom == 0) {
    top.narrow(height.low, height.high);
  } else if (claimed.of_top == 0) {
    bottom.narrow(height.low, height.high);
  } else {
    // Halfway: the sum of both is twice the height. Twice the top less the sum is the difference,
    // and so is the sum less twice the bottom.
    const Interval<E> sum{height.low + height.low, height.high + height.high};
    difference.narrow(sum.low - bottom.high - bottom.high, sum.high - bottom.low - bottom.low);
    difference.narrow(top.low + top.low - sum.high, top.high + top.high - sum.low);
  }
  if (top.is_empty() || bottom.is_empty() || height.is_empty()) return false;
  difference.narrow(top.low - bottom.high, top.high - bottom.low);
  return !difference.is_empty();
}

template <class Number>
bool finds_places(const Truth& truth, const Along& along, const PointClaim& claim,
                  std::optional<double> steepest = {}) {
  const Frame<Number> frame(truth, along);
  using E = typename Frame<Number>::E;
  const auto at = seen_in_world<Number>(truth.stored(), claim.position);
  const E place = frame.element(frame.place(at));
  const Interval<E> near{place - frame.length(claim.along), place + frame.length(claim.along)};
  if (near.is_empty()) return false;
  const E narrow = frame.length(claim.narrow);
  const auto top = frame.heights(Side::a, near, narrow, steepest);
  const auto bottom = frame.heights(Side::b, near, narrow, steepest);
  if (!top || !bottom) return false;
  Interval<E> difference{frame.length(claim.gap_least) - frame.length(claim.slack) - frame.radii(),
                         frame.length(claim.gap_most) + frame.length(claim.slack) - frame.radii()};
  if (claim.shortfall) {
    const E least = frame.element(along.scaled_support<Number>()) - frame.length(*claim.shortfall);
    difference.narrow(least, difference.high);
  }
  return std::ranges::any_of(claim.heights, [&](const Height& claimed) {
    const E height = frame.element(frame.height(at)) - frame.length(claimed.offset);
    const E across = frame.length(claim.across);
    return fits(*top, *bottom, claimed, {height - across, height + across}, difference);
  });
}

/// With every allowance less by so much.
PointClaim narrowed(PointClaim claim, double by) {
  for (const auto of :
       {&PointClaim::along, &PointClaim::across, &PointClaim::slack, &PointClaim::narrow}) {
    claim.*of -= by;
  }
  if (claim.shortfall) *claim.shortfall -= by;
  return claim;
}

/// Places that pairs of doubles find, well inside of what is allowed, are there. With v = 2^-101,
/// the roundoff of such a pair, and E the extent, places, widths and heights are off by less than
/// 2^4 v E; on an edge of slope m heights by less than 2^5 v E (m + 1). Where m is less than 2^20
/// all stays below 2^-74 E, and what lies so far outside of an edge has a place on it as near.
bool surely_finds_places(const Truth& truth, const Along& along, const PointClaim& claim) {
  return finds_places<DoubleDouble>(truth, along, narrowed(claim, 0x1p-70 * truth.extent()),
                                    0x1p20);
}

}  // namespace

bool is_witness(const Truth& truth, const Along& along, const PointClaim& claim) {
  return surely_finds_places(truth, along, claim) || finds_places<Rational>(truth, along, claim);
}

bool is_at_vertex(const Truth& truth, const Vector2<double>& position, double bound) {
  const StoredPair& pair = truth.stored();
  const auto at = seen_in_world<Rational>(pair, position);
  const Rational reach = Rational(bound) * Rational(bound);
  return std::ranges::any_of(std::array{Side::a, Side::b}, [&](Side side) {
    for (int i = 0; i < pair[side].polygon.count; ++i) {
      const auto corner = vertex<Rational>(pair, side, i);
      const Point<Rational> off{at.x - corner.x, at.y - corner.y};
      if (dot(off, off) <= reach) return true;
    }
    return false;
  });
}

}  // namespace manifuzz::exact
