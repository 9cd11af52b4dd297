#pragma once

#include "unit/scene/any_scene.hpp"

namespace manifuzz::test {

/// A property: whatever commands a scene of at most 16 bodies gets, drawn by rc::state, each
/// step equals its pairs afresh.
void check_commands(MakeScene make);

}  // namespace manifuzz::test
