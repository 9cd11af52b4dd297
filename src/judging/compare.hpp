#pragma once

#include "judging/admissible.hpp"

namespace manifuzz {

/// A collider's answer with its declaration, by reference.
struct ColliderAnswer {
  const Declaration& declaration;
  const Answer& answer;
};

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
