#pragma once

#include <optional>
#include <string>

#include "judging/admissible.hpp"

namespace manifuzz {

/// A collider's answer with its declaration, by reference.
struct ColliderAnswer {
  const Declaration& declaration;
  const Answer& answer;
};

/// In words, what it says that no manifold can say; none of 0 to 2 points, finite figures, no depth
/// below zero, features that exist.
std::optional<std::string> why_malformed(const PairCase& pair, const Manifold<double>& manifold);
/// What is malformed in any answer or in the shapes that it used; one that says nothing is well
/// formed. Depths below zero are allowed to a collider that reports points across gaps.
std::optional<std::string> why_malformed(const PairCase& pair, const ColliderAnswer& given);
/// Why the answer is malformed, or what became of it where it was lost.
std::optional<std::string> why_lost(const PairCase& pair, const ColliderAnswer& given);

/// A verdict that needs no judging of manifolds, if it is one.
std::optional<Bucket> without_judging(const exact::Truth& truth, const ColliderAnswer& subject,
                                      const ColliderAnswer& oracle);

/// Whether floats cannot say more of answers that are within bound than that they are: the bound of
/// either collider, or the tolerance that it declares, exceeds a set share of the size.
bool hides_all(const exact::Truth& truth, const ColliderAnswer& subject,
               const ColliderAnswer& oracle);

/// Whether they match each other within the sum of both bounds, on the cheap: what it says is so,
/// but it leaves to `judge` every case in which anything has to be decided.
bool plainly_agree(const exact::Truth& truth, const ColliderAnswer& subject,
                   const ColliderAnswer& oracle);

/// Whether both match one candidate within their own bounds, hence each other within the sum. Of
/// manifolds that are right.
bool agree_within_bounds(const Manifold<double>& subject, const Admissible& right_for_subject,
                         const Manifold<double>& oracle, const Admissible& right_for_oracle);

/// The tie of what is right for two colliders: the first decision that lies within the wider of
/// both bounds.
TieClass tie_class(const Admissible& subject, const Admissible& oracle);

/// How the subject's manifold differs from the oracle's, both being right: `from_contact` is the
/// magnitude where only one of them has a contact.
Mismatch difference(const Manifold<double>& subject, const Manifold<double>& oracle,
                    double from_contact);

}  // namespace manifuzz
