#pragma once

#include "scene/scene.hpp"
#include "unit/scene/any_scene.hpp"

namespace manifuzz::test {

/// The project's own scene, for `Adapted`.
struct OwnScene {
  using Scene = scene::Scene;
  using BodyHandle = scene::BodyHandle;
  using Move = scene::Move;
  using BodyPart = scene::BodyPart;
  using Filter = scene::Filter;
  using Rules = scene::Rules;
};

}  // namespace manifuzz::test
