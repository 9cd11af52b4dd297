#pragma once

#include <optional>

#include "exact/witness.hpp"
#include "support/twin_facts.hpp"

// The penetration curve written a second time, by its definitions alone: over every pair of
// vertices, every direction in which it may be least, and every line along the normal that meets a
// vertex.

namespace manifuzz::twin {

class TwinCurve {
 public:
  TwinCurve(const PairCase& pair, bool is_round);

  /// D(n), for a normal in A's frame.
  Real depth(const Vector2<double>& normal) const { return along(turned(normal)); }
  /// G(n); none where no line along the normal meets both cores.
  std::optional<Real> gap(const Vector2<double>& normal) const;
  // A normal's length is rational, where A's rotation is unit: lengths are then rational too.

  /// G(n) at its largest, and at its least, where B is slid by up to so much along the tangent;
  /// none where no line meets both cores: with any such slide, with one of the two.
  std::optional<Real> most_gap(const Vector2<double>& normal, double slide) const;
  std::optional<Real> least_gap(const Vector2<double>& normal, double slide) const;
  /// Whether places of both cores bear the claim out.
  bool has_witness(const Vector2<double>& normal, const exact::PointClaim& claim) const;
  /// D*.
  const Real& least() const { return least_; }
  /// The least over one side's faces.
  Real least_of(Side side) const;

 private:
  Exact turned(const Vector2<double>& normal) const;
  Real along(const Exact& direction) const;
  Real least_of(const std::vector<Exact>& directions) const;

  Exact turn_of_a_;
  Outline a_;
  Outline b_;
  Ratio radius_;
  Real least_;
};

}  // namespace manifuzz::twin
