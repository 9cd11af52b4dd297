#pragma once

#include "collider/collider.hpp"

namespace manifuzz {

/// The kernel for one pair: `clip`'s manifolds, bit for bit.
Collider make_pair(double tie_bias = 0);

/// The kernel for many pairs, asked one at a time: `clip`'s manifolds, bit for bit.
Collider make_batch(double tie_bias = 0);

/// The same in double: `clip64`'s.
Collider make_batch64(double tie_bias = 0);

}  // namespace manifuzz
