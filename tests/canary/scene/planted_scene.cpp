// Copied with the bugs planted into the scene, and compiled under a namespace of theirs.
#include "canary/one_target.hpp"
// before Highway
#include "afresh/boxes.cpp"
#include "afresh/cell_level.cpp"
#include "afresh/cells.cpp"
#include "afresh/defect.cpp"
#include "afresh/shape_table.cpp"
#include "canary/scene/scene_bugs.hpp"
#include "scene/candidates.cpp"
#include "scene/collide.cpp"
#include "scene/division.cpp"
#include "scene/faces.cpp"
#include "scene/large_pages.cpp"
#include "scene/look.cpp"
#include "scene/out_of_memory.cpp"
#include "scene/partners.cpp"
#include "scene/parts.cpp"
#include "scene/placing.cpp"
#include "scene/recycled.cpp"
#include "scene/rows.cpp"
#include "scene/scene.cpp"
#include "scene/search.cpp"
#include "scene/step.cpp"

namespace manifuzz {
namespace {

struct Api {
  using Scene = scene::Scene;
  using BodyHandle = scene::BodyHandle;
  using Move = scene::Move;
  using BodyPart = scene::BodyPart;
  using Filter = scene::Filter;
  using Rules = scene::Rules;
};

[[maybe_unused]] const bool planted = canary::add_scenes({PLANTED_BUGS}, test::Adapted<Api>::make);

}  // namespace
}  // namespace manifuzz
