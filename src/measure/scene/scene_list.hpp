#pragma once

/// The one list of scenes: a name, and a line for `list scenes`. Each is made by a function
/// make_NAME of scene_scripts.cpp.
#define MANIFUZZ_SCENES(SCENE)                                                  \
  SCENE(pile, "polygons that fall onto each other between walls, recorded")     \
  SCENE(stirred, "a pile that is shaken: gravity turns in each step, recorded") \
  SCENE(resting_pile, "a pile at rest, a tenth of it nudged in each step")      \
  SCENE(pyramid, "boxes in pyramids that settle, recorded")                     \
  SCENE(rain, "polygons that fall far from each other, recorded")               \
  SCENE(sparse_drift, "polygons far from each other, all on their way")         \
  SCENE(spinning_grid, "boxes in a grid, each turning on the spot")             \
  SCENE(one_mover, "one polygon on its way through a field that rests")         \
  SCENE(slivers, "a crowd of needles, all moving")                              \
  SCENE(still, "a dense field in which nothing moves")
