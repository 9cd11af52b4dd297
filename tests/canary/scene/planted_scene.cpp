// Copied for each bug planted into the scene, and compiled under the bug's namespace.
#include "canary/scene/scene_bugs.hpp"
#include "scene/body.cpp"
#include "scene/broad_phase.cpp"
#include "scene/pair_cache.cpp"
#include "scene/scene.cpp"
#include "scene/shape_table.cpp"
#include "scene/step.cpp"

namespace manifuzz {
namespace {

struct Api {
  using Scene = scene::Scene;
  using BodyHandle = scene::BodyHandle;
  using Move = scene::Move;
};

[[maybe_unused]] const bool planted = canary::add_scene("PLANTED_BUG", test::Adapted<Api>::make);

}  // namespace
}  // namespace manifuzz
