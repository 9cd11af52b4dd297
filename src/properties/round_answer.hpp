#pragma once

#include <functional>

#include "judging/round_contact.hpp"
#include "properties/properties.hpp"

namespace manifuzz {

// What properties of round shapes are written with: what an answer says of the least depth, as an
// interval that holds it if the answer is right. bounds.md derives the bounds.

/// A collider's answer to one round pair, beside the truth. Of pairs without an answer all figures
/// are open.
class RoundAnswer {
 public:
  RoundAnswer(AskedCollider& ask, const PairCase& pair);
  RoundAnswer(const RoundAnswer&) = delete;
  RoundAnswer& operator=(const RoundAnswer&) = delete;

  bool is_given() const { return manifold_.has_value(); }
  /// Whether it names a contact.
  bool touches() const { return manifold_ && manifold_->count > 0; }
  const Manifold<double>& manifold() const { return *manifold_; }
  /// Its deepest point; of an answer with a contact.
  const ContactPoint<double>& deepest() const;

  /// D* is between these if the answer is right: world lengths.
  double least() const { return least_; }
  double most() const { return most_; }
  /// Half of what is between; infinite of an answer that leaves an end open.
  double half_width() const { return (most_ - least_) / 2; }

  /// Whether the contact's normal is told, within `normal_bound`; a length of unit vectors.
  bool tells_normal() const { return touches() && nearest_.must_be_near(); }
  double normal_bound() const { return nearest_.bound(); }
  /// Whether it is one of those that rounding cannot tell from the nearest, of which there may be
  /// several.
  bool has_right_normal() const { return nearest_.is_near(manifold_->normal); }
  /// How far the cores are apart, less the bound of that: at least so far they are.
  double distance() const;

  const exact::PenetrationCurve& curve() const { return curve_; }
  const Bounds& within() const { return bounds_; }
  /// By how much D at a right normal may exceed D*.
  double minimality() const { return minimality_; }

 private:
  void read_depth(const Declaration& declaration);

  exact::Truth truth_;
  exact::PenetrationCurve curve_;
  Bounds bounds_;
  NearestNormal nearest_;
  double minimality_;
  std::optional<Manifold<double>> manifold_;
  double least_;
  double most_;
};

/// How much a difference takes of the bounds that it is within, which are so wide together: it
/// would exceed them by `beyond`, which is at most 0. 0 where they are open.
double taken_within(double width, double beyond);

/// Whether a pair and that pair moved get one contact: depths, and where they are told normals and
/// the place of a circle's contact. `back` takes an answer of the moved pair to the pair's frame.
PropertyOutcome same_round_contact(
    AskedCollider& ask, const PairCase& pair, const PairCase& moved,
    const std::function<Manifold<double>(const Manifold<double>&)>& back);

// What properties.hpp says of any pair, for round pairs.
PropertyOutcome round_depth_is_least(AskedCollider& ask, const PairCase& pair);
PropertyOutcome round_depth_moves_apart(AskedCollider& ask, const PairCase& pair);
PropertyOutcome round_overlap_is_never_empty(AskedCollider& ask, const PairCase& pair);
/// Also of polygons, where the collider is judged by the curve.
PropertyOutcome manifold_is_right_by_curve(AskedCollider& ask, const PairCase& pair);

}  // namespace manifuzz
