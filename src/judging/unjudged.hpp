#pragma once

#include <optional>
#include <string>

#include "judging/compare.hpp"

namespace manifuzz {

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

}  // namespace manifuzz
