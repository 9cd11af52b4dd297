#pragma once

#include <cstdint>
#include <vector>

#include "canary/planted.hpp"

namespace manifuzz::canary {

/// One case of each regime of polygons, and one that takes the deepest contact.
const std::vector<PairCase>& companions();

/// The pair among others, at both ends and in the middle: more than a block, no whole number of
/// them; now and then more than the kernels group at once. With a round shape in it the others are,
/// in turn, itself, so that it fills whole batches; pairs of every kind; and those that are
/// collided alike, circles as circles and cores as cores.
template <class Scalar>
std::vector<Placed<Scalar>> company(std::uint64_t number, const Placed<Scalar>& pair);

}  // namespace manifuzz::canary
