#pragma once

#include <string>

#include "unit/scene/any_scene.hpp"

namespace manifuzz::test {

/// What is wrong with a scene larger than rc::state's, that lasts longer, by the project's own
/// generator: bodies drift, turn, rest, vanish and get other shapes. Nothing, if it is sound.
std::optional<std::string> crowd_complaint(MakeScene make, std::uint64_t seed);

/// Likewise of few steps of so many bodies, in as little space, that more pairs are to be collided
/// than a scene keeps waiting.
std::optional<std::string> dense_crowd_complaint(MakeScene make);

}  // namespace manifuzz::test
