// The article's clipping in C++ as a shared library, or for libFuzzer:
//
//   scripts/libfuzzer scripts/colliders/cpp/clip.cpp -max_total_time=60

#include "clip.hpp"

extern "C" {

const manifuzz_declaration manifuzz_collider = clip::declaration("clip-in-c");

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  clip::collide(*a, *b, *manifold);
  return 0;
}
}
