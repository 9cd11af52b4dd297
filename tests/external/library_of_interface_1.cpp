// A library as it was built against interface 1 of manifuzz_collider.h: its structs end where that
// one's did. It says that nothing touches.
#include <cstdint>

namespace {

struct DeclarationOfInterface1 {
  std::int32_t interface;
  const char* name;
  const char* version;
  std::int32_t scalar, rounds_in, answers_in, points, normal;
  double tie_bias;
  std::int32_t vertices_max, takes_radius;
  const char* snippet;
};

}  // namespace

extern "C" {

extern const DeclarationOfInterface1 manifuzz_collider;
const DeclarationOfInterface1 manifuzz_collider = {1, "early", "1.0", 1, 1, 1,
                                                   0, 0,       0.25,  6, 1, nullptr};

int manifuzz_collide(const void*, const void*, std::int32_t* manifold) {
  manifold[0] = 0;
  return 0;
}
}
