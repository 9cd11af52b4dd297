#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include "external/manifuzz_timed_world.h"

// Worlds behind the C header, in which a body left of x = 0 touches something. A step takes a
// microsecond a move.

struct manifuzz_timed_world {
  bool is_broken = false;
  std::vector<float> x;
};

manifuzz_timed_world* manifuzz_timed_world_create(const char* name) {
  const std::string_view wanted(name);
  if (wanted != "sound" && wanted != "broken") return nullptr;
  return new manifuzz_timed_world{wanted == "broken", {}};
}

int manifuzz_timed_world_add(manifuzz_timed_world* world, const manifuzz_body* body) {
  if (body->count < 3) return 1;
  world->x.push_back(body->position.x);
  return 0;
}

double manifuzz_timed_world_step(manifuzz_timed_world* world, const manifuzz_move* moves,
                                 std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) world->x[moves[i].body] = moves[i].position.x;
  return world->is_broken ? std::numeric_limits<double>::quiet_NaN() : 1000.0 * count;
}

std::int64_t manifuzz_timed_world_contacts(manifuzz_timed_world* world) {
  if (world->is_broken) return -1;
  return std::ranges::count_if(world->x, [](float x) { return x < 0; });
}

void manifuzz_timed_world_destroy(manifuzz_timed_world* world) {
  delete world;
}
