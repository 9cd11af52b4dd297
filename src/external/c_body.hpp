#pragma once

#include "external/manifuzz_collider.h"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A body as manifuzz_collider.h has it.
manifuzz_body c_body(const Body& body);

}  // namespace manifuzz
