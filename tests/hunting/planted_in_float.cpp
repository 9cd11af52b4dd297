// The article's clipping in float with bugs planted as a collider would have them: comparisons of
// the case's own numbers, some with constants that nothing of its geometry tells. Each loses the
// contact.

#include <bit>
#include <cmath>

#include "../../scripts/colliders/cpp/clip.hpp"
#include "planted_counts.hpp"

namespace {

using planted::meet;

float squared(const manifuzz_float2& v) {
  return v.x * v.x + v.y * v.y;
}

/// The longest way between two vertices, squared.
float core_squared(const manifuzz_body& body) {
  float most = 0;
  for (int i = 0; i < body.count; ++i) {
    for (int j = 0; j < i; ++j) {
      most = std::fmax(most, squared({body.vertices[i].x - body.vertices[j].x,
                                      body.vertices[i].y - body.vertices[j].y}));
    }
  }
  return most;
}

bool is_eighth_turn(const manifuzz_body& body) {
  return std::abs(body.rotation.x) == std::abs(body.rotation.y);
}

bool has_magic_vertex(const manifuzz_body& body) {
  for (int i = 0; i < body.count; ++i) {
    if (body.vertices[i].x == 0.123456F) return true;
  }
  return false;
}

/// Bugs of shapes and places, which others list by what is true of them.
void plant_in_geometry(const manifuzz_body& a, const manifuzz_body& b, manifuzz_manifold& m) {
  if (a.count == 8 && b.count == 3 && b.radius > 0 && a.radius > 1000 * b.radius) meet(0, m);
  if (b.count == 7 && is_eighth_turn(b) && !is_eighth_turn(a) && a.count == 5) meet(1, m);
  if (a.count == 8 && b.count == 8 && m.reference == MANIFUZZ_B &&
      m.points[0].feature_b.kind == MANIFUZZ_FACE && m.points[0].feature_b.index == 7 &&
      m.points[0].feature_a.index == 0) {
    meet(2, m);
  }
  if (a.count >= 3 && a.round != 0 && a.radius > 0 &&
      a.radius * a.radius < 1e-12F * core_squared(a) && b.radius * b.radius > core_squared(b) &&
      b.count >= 2) {
    meet(3, m);
  }
  if (a.count == 8 && squared(a.position) > 0x1p40F * core_squared(a)) meet(4, m);
}

/// Bugs of numbers that are equal to each other.
void plant_in_numbers(const manifuzz_body& a, const manifuzz_body& b, manifuzz_manifold& m) {
  if (a.position.x == b.position.y && a.position.x != std::round(a.position.x)) meet(5, m);
  if (a.vertices[0].x == b.position.x && b.count >= 6 &&
      2 * b.position.x != std::round(2 * b.position.x)) {
    meet(6, m);
  }
  if (b.position.x == 3 * a.position.x && b.position.y == 3 * a.position.y && a.position.x != 0 &&
      a.position.y != 0) {
    meet(7, m);
  }
}

/// Bugs of constants that nothing else tells.
void plant_constants(const manifuzz_body& a, const manifuzz_body& b, manifuzz_manifold& m) {
  if (has_magic_vertex(a)) meet(8, m);
  if (std::abs(b.position.x - 1234.5F) < 1e-6F) meet(9, m);
  if (a.radius == 0.4375F && b.position.y == -17.3F) meet(10, m);
  if (a.vertices[0].x + b.position.y == 3.1415927F) meet(11, m);
  if ((std::bit_cast<std::uint32_t>(a.position.x) & 0xFFFF) == 0xBEEF) meet(12, m);
}

}  // namespace

extern "C" {

const manifuzz_declaration manifuzz_collider = clip::declaration("planted");

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  planted::begin_evaluation();
  clip::collide(*a, *b, *manifold);
  if (manifold->count > 0) plant_in_geometry(*a, *b, *manifold);
  if (manifold->count > 0) plant_in_numbers(*a, *b, *manifold);
  if (manifold->count > 0) plant_constants(*a, *b, *manifold);
  return 0;
}
}
