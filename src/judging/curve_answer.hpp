#pragma once

#include <optional>
#include <vector>

#include "exact/witness.hpp"
#include "judging/by_curve.hpp"
#include "judging/round_contact.hpp"

namespace manifuzz {

/// An answer in the curve's terms: what it says of the pair as a whole.
struct Said {
  bool touches = false;
  std::optional<Vector2<double>> normal;
  double depth = 0;  ///< of the deepest point, or of the pair
  const Manifold<double>* manifold = nullptr;
};

/// What an answer says; it must outlive that.
Said said_by(const Answer& answer);

/// The index of the deepest point.
inline int deepest_of(const Manifold<double>& manifold) {
  return manifold.count > 1 && manifold.points[1].depth > manifold.points[0].depth ? 1 : 0;
}

/// Where points lie that are claimed to lie there, as shares of A's top and B's bottom. A clip's
/// are on the incident core, of round shapes on the incident surface.
std::vector<exact::Height> heights_of(PointsAt points, const PairCase& pair);

/// The bounds of an answer with this normal, where faces' normals are taken from rounded world
/// vertices: what the face of that normal may be turned by, and what that lets the collider prefer.
CurveBounds with_turned_faces(const exact::Truth& truth, const Said& said,
                              const CurveBounds& bounds);

/// What the penetration curve says of the parts of an answer, each within the bounds and the
/// tolerance of its collider. All that it is made from must outlive it.
class CurveAnswer {
 public:
  /// `tolerance`: how far the collider may stop short of the least depth, a world length.
  CurveAnswer(const exact::Truth& truth, const Declaration& declaration, const Said& said,
              const CurveBounds& bounds, double tolerance = 0)
      : truth_(truth),
        declaration_(declaration),
        said_(said),
        bounds_(with_turned_faces(truth, said, bounds)),
        tolerance_(tolerance),
        curve_(truth, exact::skin_of(truth)),
        nearest_(truth, curve_, bounds_.touching, bounds_.direction) {}

  const exact::Truth& truth() const { return truth_; }
  const Declaration& declaration() const { return declaration_; }
  const Said& said() const { return said_; }
  const CurveBounds& within() const { return bounds_; }
  double tolerance() const { return tolerance_; }
  const exact::PenetrationCurve& curve() const { return curve_; }
  const NearestNormal& nearest() const { return nearest_; }
  bool is_round() const { return is_round_; }

  /// Whether it says that the pair touches, or does not, as it may.
  bool touches_as_it_should() const;
  /// Whether its normal, turned about, would have the least depth, and the depth that it gives.
  bool is_reversed() const;
  /// Whether no other normal has clearly less depth.
  bool is_minimal(const exact::Along& along) const;
  /// Whether the depth along the normal is the least.
  bool is_least(const exact::Along& along) const { return is_least(curve_, along); }
  /// Whether a depth is the curve's along that normal.
  bool is_depth(const exact::Along& along, double depth) const;
  /// By how much the depth that it gives is not, a world length.
  double depth_error(const exact::Along& along) const;
  /// How much of its bound the depth takes, if it is right; 0 where corners may have passed each
  /// other.
  double depth_share(const exact::Along& along) const;
  /// How much of its bound the normal takes or, where its excess is judged, the depth along it.
  double normal_share(const exact::Along& along) const;
  /// Whether each of its points lies where it claims, and overlaps there by what it claims.
  bool has_witnesses(const exact::Along& along) const;
  bool is_where_claimed(const ContactPoint<double>& point) const;

 private:
  bool may_be_missed() const;
  bool is_gap_claimed(const exact::Along& along) const;
  bool is_gap_steady(const exact::Along& along) const;
  double slide() const { return 2 * (bounds_.along + tolerance_); }
  bool is_least(const exact::PenetrationCurve& curve, const exact::Along& along) const;
  bool is_distance(double depth) const;
  bool may_be_apart() const;
  double reach() const;

  const exact::Truth& truth_;
  const Declaration& declaration_;
  const Said& said_;
  CurveBounds bounds_;
  double tolerance_;
  exact::PenetrationCurve curve_;
  NearestNormal nearest_;
  bool is_round_ = manifuzz::is_round(truth_.pair());
};

}  // namespace manifuzz
