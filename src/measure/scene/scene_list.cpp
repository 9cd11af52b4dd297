#include "measure/scene/scene_recordings.hpp"
#include "measure/scene/scene_scripts.hpp"
#include "measure/scene/trajectory.hpp"

namespace manifuzz {
namespace {

constexpr SceneSpec kSpecs[] = {
    {"pile", "polygons that fall onto each other between walls, recorded", make_pile},
    {"resting_pile", "a pile at rest, a tenth of it nudged in each step", make_resting_pile},
    {"pyramid", "boxes in pyramids that settle, recorded", make_pyramid},
    {"rain", "polygons that fall far from each other, recorded", make_rain},
    {"sparse_drift", "polygons far from each other, all on their way", make_sparse_drift},
    {"spinning_grid", "boxes in a grid, each turning on the spot", make_spinning_grid},
    {"one_mover", "one polygon on its way through a field that rests", make_one_mover},
    {"slivers", "a crowd of needles, all moving", make_slivers},
    {"still", "a field in which all touch and nothing moves", make_still},
};

}  // namespace

std::span<const SceneSpec> scene_specs() {
  return kSpecs;
}

}  // namespace manifuzz
