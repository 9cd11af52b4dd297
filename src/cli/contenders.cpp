#include "cli/contenders.hpp"

#include "cli/colliders.hpp"
#include "measure/our_contenders.hpp"
#include "oracle/box2d/box2d.hpp"
#include "oracle/chipmunk/chipmunk_pass.hpp"

namespace manifuzz {

std::vector<Contender> contenders() {
  std::vector<Contender> all{{.name = "box2d", .prepare = box2d_pass, .collider = make_box2d},
                             {.name = "chipmunk", .prepare = chipmunk_pass, .collider = [] {
                                return find_collider("chipmunk");
                              }}};
  for (Contender& ours : our_contenders()) all.push_back(std::move(ours));
  return all;
}

}  // namespace manifuzz
