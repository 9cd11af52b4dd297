#include "engines/engine.hpp"

#include "oracle/box2d/box2d.hpp"
#include "oracle/box2d/entries.hpp"
#include "oracle/box2d/round_shapes.hpp"

namespace manifuzz {

Engine engine_box2d() {
  return {.name = "box2d",
          .ledger = ledger_of::kOfBox2d,
          .colliders = {{"box2d", [] { return make_box2d(); }}},
          .passes = {{"box2d", "box2d", "clipping", box2d_pass},
                     {"box2d+world", "box2d", "", box2d::world_pass}},
          .scenes = {box2d_pairs, box2d_trajectory}};
}

}  // namespace manifuzz
