#pragma once

#include <vector>

#include "judging/admissible.hpp"

namespace manifuzz {

/// What a report shows as right for a collider with this declaration: `right_manifolds`; of round
/// shapes, which have a range of right answers, the contact along each normal of the least depth,
/// in doubles, with the second point of the clip of both edges where the declaration has one.
std::vector<Manifold<double>> manifolds_to_show(const Admissible& right,
                                                const Declaration& declaration);

/// The contact along one unit normal, in A's frame, `depth` deep there: as a collider with this
/// declaration gives it.
Manifold<double> contact_along(const PairCase& pair, const Vector2<double>& normal, double depth,
                               const Declaration& declaration);

}  // namespace manifuzz
