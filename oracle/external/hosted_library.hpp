#pragma once

#include <string>

#include "collider/collider.hpp"

namespace manifuzz {

/// A shared library after manifuzz_collider.h as a collider in a process of its own: one that
/// crashes, hangs longer than `seconds_max` over a case or scribbles over its memory loses that
/// case. Throws UserError where the library cannot be loaded.
Collider collider_in_own_process(const std::string& path, double seconds_max);

}  // namespace manifuzz
