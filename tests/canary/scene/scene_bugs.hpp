#pragma once

#include <string>

#include "unit/scene/any_scene.hpp"

namespace manifuzz::canary {

/// Registers the tests that a bug planted into the scene is caught. To be called before main.
bool add_scene(const std::string& bug, test::MakeScene make);

}  // namespace manifuzz::canary
