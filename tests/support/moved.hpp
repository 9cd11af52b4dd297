#pragma once

#include "base/random.hpp"
#include "collider/collider.hpp"

namespace manifuzz {

/// An answer as it is, or moved in one of the ways in which answers are wrong, by about as much as
/// the bounds allow or by much more.
Answer moved(const Answer& answer, const PairCase& pair, const Declaration& declaration,
             Random& random);

/// A policy of the second point, most often the default.
SecondPoint any_policy(Random& random);

}  // namespace manifuzz
