#pragma once

#include <string>

#include "unit/scene/any_scene.hpp"

namespace manifuzz::test {

/// What is wrong with a scene larger than rc::state's, that lasts longer, by the project's own
/// generator: bodies drift, turn, rest, vanish and get other shapes. Nothing, if it is sound.
std::optional<std::string> crowd_complaint(MakeScene make, std::uint64_t seed);

}  // namespace manifuzz::test
