#include "oracle/exact/witness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace manifuzz::exact {
namespace {

// Everything is multiplied by |n|: places on the tangent, heights and gaps are then rational, and
// lengths are rational times |n|, so that all lies in Q(|n|). In pairs of doubles the same, which
// proves most witnesses.

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
struct Scaled<DoubleDouble> {
  using type = DoubleDouble;
  static DoubleDouble of(const DoubleDouble& rational, double root, const DoubleDouble& squared) {
    return rational + DoubleDouble(root) * sqrt(squared);
  }
  static DoubleDouble over(const DoubleDouble& value, const DoubleDouble& divisor) {
    return value / divisor;
  }
};

int sign_of(const DoubleDouble& value) {
  return value.high > 0 ? 1 : value.high < 0 ? -1 : 0;
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

template <class Number>
bool is_less_steep(const Number& run, const Number& rise, double steepest) {
  const Number most = run * Number(steepest);
  return sign_of(most - rise) > 0 && sign_of(most + rise) > 0;
}

/// Tangent places, heights and lengths, as they are along one normal.
template <class Number>
struct Frame {
  using E = typename Scaled<Number>::type;

  const StoredPair& pair;
  Point<Number> normal;
  Number squared;  ///< |n|^2

  Frame(const Truth& truth, const Along& along)
      : pair(truth.stored()), normal(along.normal<Number>()), squared(dot(normal, normal)) {}

  Number place(const Point<Number>& p) const { return normal.x * p.y - normal.y * p.x; }
  Number height(const Point<Number>& p) const { return dot(normal, p); }
  E element(const Number& number) const { return Scaled<Number>::of(number, 0, squared); }
  E length(double world) const { return Scaled<Number>::of(Number(0.0), world, squared); }
  E radii() const { return length(pair.a.polygon.radius) + length(pair.b.polygon.radius); }

  /// A's upper edges run along the tangent, B's lower ones against it; those less steep than
  /// `steepest` alone, where one is given.
  std::vector<Edge<Number>> facing(Side side, std::optional<double> steepest) const {
    std::vector<Edge<Number>> edges;
    const auto& polygon = pair[side].polygon;
    for (int i = 0; i < polygon.count; ++i) {
      Point<Number> first = vertex<Number>(pair, side, i);
      Point<Number> second = vertex<Number>(pair, side, polygon.next(i));
      if (side == Side::b) std::swap(first, second);
      const Number run = place(second) - place(first);
      if (sign_of(run) <= 0) continue;
      const Number rise = height(second) - height(first);
      if (steepest && !is_less_steep(run, rise, *steepest)) continue;
      edges.push_back({place(first), place(second), height(first), rise / run});
    }
    return edges;
  }
};

/// Places from an origin on, as far as conditions leave them.
template <class Number>
class Stretch {
 public:
  using E = typename Scaled<Number>::type;

  Stretch(E from, E to) : from_(std::move(from)), to_(std::move(to)) {}

  /// What is `excess` at the origin, and grows by `slope` from there, is not negative.
  void keep(const E& excess, const Number& slope) {
    const int direction = sign_of(slope);
    if (direction == 0) {
      is_empty_ = is_empty_ || sign_of(excess) < 0;
      return;
    }
    const E root = Scaled<Number>::over(excess, Number(0.0) - slope);
    if (direction > 0 && sign_of(root - from_) > 0) from_ = root;
    if (direction < 0 && sign_of(to_ - root) > 0) to_ = root;
  }
  /// What is `value` at the origin, and grows by `slope` from there, is between both.
  void keep_between(const E& value, const Number& slope, const E& least, const E& most) {
    keep(value - least, slope);
    keep(most - value, Number(0.0) - slope);
  }
  bool is_empty() const { return is_empty_ || sign_of(to_ - from_) < 0; }

 private:
  E from_;
  E to_;
  bool is_empty_ = false;
};

/// Whether there is a line that meets both of these edges, `inside` of their ends.
template <class Number>
bool finds_line(const Frame<Number>& frame, const Along& along, const PointClaim& claim,
                double inside, const Edge<Number>& top, const Edge<Number>& bottom) {
  using E = typename Scaled<Number>::type;
  const Number from = sign_of(top.from - bottom.from) > 0 ? top.from : bottom.from;
  const Number to = sign_of(top.to - bottom.to) > 0 ? bottom.to : top.to;
  if (sign_of(to - from) < 0) return false;
  const Point<Number> at =
      turned(frame.pair.a, Point<Number>{Number(claim.position.x()), Number(claim.position.y())});
  const E place = frame.element(frame.place(at) - from);
  const E height = frame.element(frame.height(at));
  const E gap = frame.element(top.height(from) - bottom.height(from)) + frame.radii();
  const Number gap_slope = top.slope - bottom.slope;
  return std::ranges::any_of(claim.heights, [&](const Height& claimed) {
    const Number of_top(claimed.of_top);
    const Number of_bottom(claimed.of_bottom);
    Stretch<Number> stretch(frame.length(inside), frame.element(to - from) - frame.length(inside));
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
bool finds_line(const Truth& truth, const Along& along, const PointClaim& claim, double inside = 0,
                std::optional<double> steepest = {}) {
  const Frame<Number> frame(truth, along);
  const auto bottoms = frame.facing(Side::b, steepest);
  for (const Edge<Number>& top : frame.facing(Side::a, steepest)) {
    for (const Edge<Number>& bottom : bottoms) {
      if (finds_line(frame, along, claim, inside, top, bottom)) return true;
    }
  }
  return false;
}

/// With every allowance less by so much.
PointClaim narrowed(PointClaim claim, double by) {
  for (const auto of : {&PointClaim::along, &PointClaim::across, &PointClaim::slack})
    claim.*of -= by;
  if (claim.shortfall) *claim.shortfall -= by;
  return claim;
}

/// A line that pairs of doubles find, well inside of what is allowed, is one. With v = 2^-101, the
/// roundoff of such a pair, and E the extent, places and heights are off by less than 2^4 v E; on
/// an edge of slope m, within its ends, heights by less than 2^5 v E (m + 1). Where m is less than
/// 2^20 all stays below 2^-74 E.
bool surely_finds_line(const Truth& truth, const Along& along, const PointClaim& claim) {
  const double doubt = 0x1p-70 * truth.extent();
  return finds_line<DoubleDouble>(truth, along, narrowed(claim, doubt), doubt, 0x1p20);
}

}  // namespace

bool is_witness(const Truth& truth, const Along& along, const PointClaim& claim) {
  return surely_finds_line(truth, along, claim) || finds_line<Rational>(truth, along, claim);
}

}  // namespace manifuzz::exact
