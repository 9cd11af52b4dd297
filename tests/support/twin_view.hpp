#pragma once

#include <algorithm>
#include <optional>

#include "support/twin_facts.hpp"

namespace manifuzz::twin {

/// From one real number to another; empty where the first is greater.
struct Span {
  Real low;
  Real high;

  bool is_empty() const { return high < low; }
  Span within(const Span& other) const {
    return {greater(low, other.low), lesser(high, other.high)};
  }
};

/// Both cores along a direction of any length: places and heights are times that length, and so
/// rational; a world length is times it too, to be held against them.
class View {
 public:
  View(const Outline& a, const Outline& b, const Exact& direction)
      : a_(a), b_(b), direction_(direction), length_(square_root(direction * direction)) {}

  const Real& length() const { return length_; }
  Real scaled(const Real& world) const { return world * length_; }
  Ratio height(const Exact& p) const { return direction_ * p; }
  Ratio place(const Exact& p) const { return Exact{-direction_.y, direction_.x} * p; }
  /// The cosine of the angle with another direction, of that length.
  Real cosine(const Exact& other, const Real& length) const {
    return Real(direction_ * other) / (length_ * length);
  }
  /// The largest height of A's core, or with -1 the least of B's.
  Ratio farthest(const Outline& core, int sign) const {
    Ratio most = height(core.corners[0]);
    for (const Exact& corner : core.corners) {
      if (sign * (height(corner) - most) > 0) most = height(corner);
    }
    return most;
  }
  /// The largest height of A's core over B's.
  Ratio overlap() const { return farthest(a_, 1) - farthest(b_, -1); }
  /// The heights of A's top, or with -1 of B's bottom, at these places, and of all corners there if
  /// the core is no wider than `narrow`; none beside the core.
  std::optional<Span> heights(const Outline& core, int sign, const Span& places,
                              const Real& narrow) const {
    std::vector<Real> all{places.low, places.high};
    for (const Exact& corner : core.corners) {
      const Real at = place(corner);
      if (places.low <= at && at <= places.high) all.push_back(at);
    }
    std::optional<Span> found;
    for (const Real& at : all) {
      const auto here = height_at(core, sign, at);
      if (!here) continue;
      if (!found) found = Span{*here, *here};
      found = Span{lesser(found->low, *here), greater(found->high, *here)};
    }
    if (!found || narrow < Real(width(core))) return found;
    for (const Exact& corner : core.corners) {
      const Real at(place(corner));
      if (at < places.low || places.high < at) continue;
      const Real here(height(corner));
      found = Span{lesser(found->low, here), greater(found->high, here)};
    }
    return found;
  }

 private:
  /// Along the tangent.
  Ratio width(const Outline& core) const {
    Ratio low = place(core.corners[0]);
    Ratio high = low;
    for (const Exact& corner : core.corners) {
      low = std::min<Ratio>(low, place(corner));
      high = std::max<Ratio>(high, place(corner));
    }
    return high - low;
  }
  std::optional<Real> height_at(const Outline& core, int sign, const Real& at) const {
    std::optional<Real> most;
    const auto consider = [&](const Real& found) {
      if (!most) most = found;
      most = sign > 0 ? greater(*most, found) : lesser(*most, found);
    };
    for (int i = 0; i < core.size(); ++i) {
      const Ratio from = place(core.corner(i));
      const Ratio run = place(core.corner(i + 1)) - from;
      const Ratio rise = height(core.corner(i + 1)) - height(core.corner(i));
      if (at.rational() && *at.rational() == from) consider(height(core.corner(i)));
      if (run == 0) continue;
      const Real share = (at - Real(from)) / Real(run);
      if (share < Real(0.0) || Real(1.0) < share) continue;
      consider(Real(height(core.corner(i))) + share * Real(rise));
    }
    return most;
  }

  const Outline& a_;
  const Outline& b_;
  Exact direction_;
  Real length_;
};

/// Whether a direction is that of `other`, so long, within a bound.
inline bool is_towards(const Exact& direction, const Exact& other, const Real& length,
                       const Real& bound) {
  const Real own = square_root(direction * direction);
  const Real x = Real(direction.x) / own - Real(other.x) / length;
  const Real y = Real(direction.y) / own - Real(other.y) / length;
  return x * x + y * y <= bound * bound;
}

}  // namespace manifuzz::twin
