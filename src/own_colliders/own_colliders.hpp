#pragma once

#include "collider/collider.hpp"

namespace manifuzz {

/// The article in float: transposes for inverses, so the rotation's defect is part of its error.
Collider make_clip(double tie_bias = 0);

/// The article in double, on the same floats: divides where a rotation is not quite unit.
Collider make_clip64(double tie_bias = 0);

/// The kernel for one pair: `clip`'s manifolds, bit for bit.
Collider make_pair(double tie_bias = 0);

/// The kernel for many pairs, asked one at a time: `clip`'s manifolds, bit for bit.
Collider make_batch(double tie_bias = 0);

/// The same in double: `clip64`'s.
Collider make_batch64(double tie_bias = 0);

}  // namespace manifuzz
