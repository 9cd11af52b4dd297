#include "oracle/exact/witness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace manifuzz::exact {
namespace {

// Everything is multiplied by |n|: places on the tangent, heights and gaps are then rational, and
// lengths are rational times |n|, so that all lies in Q(|n|). In doubles the same, for a first
// look.

/// rational + root |n|.
template <class Number>
struct Scaled;

template <>
struct Scaled<Rational> {
  using type = Quadratic;
  static Quadratic of(const Rational& rational, double root, const Rational& squared) {
    return {rational, Rational(root), squared};
  }
  static Quadratic over(const Quadratic& value, const Rational& divisor) {
    return {value.rational / divisor, value.root / divisor, value.radicand};
  }
};

template <>
struct Scaled<double> {
  using type = double;
  static double of(double rational, double root, double squared) {
    return rational + root * std::sqrt(squared);
  }
  static double over(double value, double divisor) { return value / divisor; }
};

int sign_of(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}
int sign_of(const Rational& value) {
  return value.sign();
}
int sign_of(const Quadratic& value) {
  return *sign(value);
}

/// One edge of the boundary that faces the other side: the height at a place is at_from + slope
/// (place - from).
template <class Number>
struct Edge {
  Number from;
  Number to;
  Number at_from;
  Number slope;

  Number height(const Number& place) const { return at_from + slope * (place - from); }
};

/// Tangent places, heights and lengths, as they are along one normal.
template <class Number>
struct Frame {
  using E = typename Scaled<Number>::type;

  const PairCase& pair;
  Point<Number> normal;
  Number squared;  ///< |n|^2

  Frame(const Truth& truth, const Along& along)
      : pair(truth.pair()), normal(along.normal<Number>()), squared(dot(normal, normal)) {}

  Number place(const Point<Number>& p) const { return normal.x * p.y - normal.y * p.x; }
  Number height(const Point<Number>& p) const { return dot(normal, p); }
  E element(const Number& number) const { return Scaled<Number>::of(number, 0, squared); }
  E length(double world) const { return Scaled<Number>::of(Number(0.0), world, squared); }
  E radii() const {
    return length(static_cast<double>(pair.a.polygon.radius)) +
           length(static_cast<double>(pair.b.polygon.radius));
  }

  /// A's upper edges run along the tangent, B's lower ones against it.
  std::vector<Edge<Number>> facing(Side side) const {
    std::vector<Edge<Number>> edges;
    const auto& polygon = pair[side].polygon;
    for (int i = 0; i < polygon.count; ++i) {
      Point<Number> first = vertex<Number>(pair, side, i);
      Point<Number> second = vertex<Number>(pair, side, polygon.next(i));
      if (side == Side::b) std::swap(first, second);
      const Number run = place(second) - place(first);
      if (sign_of(run) <= 0) continue;
      edges.push_back(
          {place(first), place(second), height(first), (height(second) - height(first)) / run});
    }
    return edges;
  }
};

/// Places from an origin on, as far as conditions leave them.
template <class Number>
class Stretch {
 public:
  using E = typename Scaled<Number>::type;

  Stretch(E zero, E to) : zero_(zero), from_(std::move(zero)), to_(std::move(to)) {}

  /// What is `excess` at the origin, and grows by `slope` from there, is not negative.
  void keep(const E& excess, const Number& slope) {
    const int direction = sign_of(slope);
    if (direction == 0) {
      is_empty_ = is_empty_ || sign_of(excess) < 0;
      return;
    }
    const E root = Scaled<Number>::over(zero_ - excess, slope);
    if (direction > 0 && sign_of(root - from_) > 0) from_ = root;
    if (direction < 0 && sign_of(to_ - root) > 0) to_ = root;
  }
  /// What is `value` at the origin, and grows by `slope` from there, is between both.
  void keep_between(const E& value, const Number& slope, const E& least, const E& most) {
    keep(value - least, slope);
    keep(most - value, -slope);
  }
  bool is_empty() const { return is_empty_ || sign_of(to_ - from_) < 0; }

 private:
  E zero_;
  E from_;
  E to_;
  bool is_empty_ = false;
};

/// Whether there is a line that meets both of these edges.
template <class Number>
bool finds_line(const Frame<Number>& frame, const Along& along, const PointClaim& claim,
                const Edge<Number>& top, const Edge<Number>& bottom) {
  using E = typename Scaled<Number>::type;
  const Number from = std::max<Number>(top.from, bottom.from);
  const Number to = std::min<Number>(top.to, bottom.to);
  if (to < from) return false;
  const Point<Number> at =
      turned(frame.pair.a, Point<Number>{Number(claim.position.x()), Number(claim.position.y())});
  const E place = frame.element(frame.place(at) - from);
  const E height = frame.element(frame.height(at));
  const E gap = frame.element(top.height(from) - bottom.height(from)) + frame.radii();
  const Number gap_slope = top.slope - bottom.slope;
  return std::ranges::any_of(claim.heights, [&](const Height& claimed) {
    const Number of_top(claimed.of_top);
    const Number of_bottom(claimed.of_bottom);
    Stretch<Number> stretch(frame.element(Number(0.0)), frame.element(to - from));
    stretch.keep_between(frame.element(Number(0.0)), Number(1.0), place - frame.length(claim.along),
                         place + frame.length(claim.along));
    stretch.keep_between(
        frame.element(of_top * top.height(from) + of_bottom * bottom.height(from)) +
            frame.length(claimed.offset),
        of_top * top.slope + of_bottom * bottom.slope, height - frame.length(claim.across),
        height + frame.length(claim.across));
    stretch.keep_between(gap, gap_slope, frame.length(claim.gap_least) - frame.length(claim.slack),
                         frame.length(claim.gap_most) + frame.length(claim.slack));
    if (claim.shortfall) {
      const E depth = frame.element(along.scaled_support<Number>()) + frame.radii();
      stretch.keep(gap - depth + frame.length(*claim.shortfall), gap_slope);
    }
    return !stretch.is_empty();
  });
}

template <class Number>
bool finds_line(const Truth& truth, const Along& along, const PointClaim& claim) {
  const Frame<Number> frame(truth, along);
  const auto bottoms = frame.facing(Side::b);
  for (const Edge<Number>& top : frame.facing(Side::a)) {
    for (const Edge<Number>& bottom : bottoms) {
      if (finds_line(frame, along, claim, top, bottom)) return true;
    }
  }
  return false;
}

/// With every allowance wider by so much.
PointClaim widened(PointClaim claim, double by) {
  for (const auto of : {&PointClaim::along, &PointClaim::across, &PointClaim::slack})
    claim.*of += by;
  if (claim.shortfall) *claim.shortfall += by;
  return claim;
}

/// Whether doubles can tell which way an edge runs.
bool has_steep_edges(const Truth& truth, const Along& along, double doubt) {
  const Frame<double> frame(truth, along);
  for (const Side side : {Side::a, Side::b}) {
    const auto& polygon = truth.pair()[side].polygon;
    for (int i = 0; i < polygon.count; ++i) {
      const double run = frame.place(vertex<double>(truth.pair(), side, polygon.next(i))) -
                         frame.place(vertex<double>(truth.pair(), side, i));
      if (std::abs(run) < doubt * std::sqrt(frame.squared)) return true;
    }
  }
  return false;
}

}  // namespace

bool is_witness(const Truth& truth, const Along& along, const PointClaim& claim) {
  // In doubles, vertices are as if moved by some ulps of the extent: by far less than this.
  const double doubt = 0x1p-44 * truth.extent();
  if (!has_steep_edges(truth, along, doubt)) {
    if (!finds_line<double>(truth, along, widened(claim, doubt))) return false;
    if (finds_line<double>(truth, along, widened(claim, -doubt))) return true;
  }
  return finds_line<Rational>(truth, along, claim);
}

}  // namespace manifuzz::exact
