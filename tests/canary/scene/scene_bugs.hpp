#pragma once

#include <vector>

#include "canary/acting.hpp"
#include "unit/scene/any_scene.hpp"

namespace manifuzz::canary {

/// Registers for each bug planted into the scene the test that it is caught. To be called before
/// main.
bool add_scenes(const std::vector<Bug>& bugs, test::MakeScene make);

}  // namespace manifuzz::canary
