#pragma once

#include <vector>

#include "measure/contender.hpp"

namespace manifuzz {

/// Everything that `bench` times, Box2D first.
std::vector<Contender> contenders();

}  // namespace manifuzz
