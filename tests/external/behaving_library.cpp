#include <algorithm>
#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <unistd.h>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "external/behaviour.hpp"
#include "external/manifuzz_collider.h"
#include "own_colliders/own_colliders.hpp"

// clip64 behind the C header, as a midpoint collider with normals from B to A where it is told so.
// MANIFUZZ_TEST_BEHAVIOUR says what else it does.

using namespace manifuzz;

namespace {

std::string_view behaviour() {
  const char* const told = std::getenv("MANIFUZZ_TEST_BEHAVIOUR");
  return told == nullptr ? "" : told;
}

Body from_c(const manifuzz_body& body) {
  Body result;
  std::array<Vector2<float>, kMaxVertices> corners;
  for (int i = 0; i < body.count; ++i) corners[i] = {body.vertices[i].x, body.vertices[i].y};
  result.polygon = make_polygon<float>(
      std::span(corners.data(), static_cast<std::size_t>(body.count)), body.radius);
  result.pose = {{body.position.x, body.position.y}, {body.rotation.x, body.rotation.y}};
  return result;
}

manifuzz_feature to_c(const Feature& feature) {
  const auto kind = feature.kind == Feature::Kind::face ? MANIFUZZ_FACE : MANIFUZZ_VERTEX;
  return {static_cast<std::uint8_t>(kind), feature.index};
}

/// Halfway between both surfaces.
Vector2<double> midpoint(const Manifold<double>& manifold, const PairCase& pair, int i) {
  const bool incident_b = manifold.reference == Side::a;
  const double radius = static_cast<double>(pair[other(manifold.reference)].polygon.radius);
  const Vector2<double> inwards = incident_b ? manifold.normal : -manifold.normal;
  const double unit = pair.a.pose.rotation.cast<double>().norm();
  return manifold.points[i].position + inwards * (manifold.points[i].depth / 2 - radius) / unit;
}

/// On what may be our standard streams.
void print_garbage() {
  std::fputs("\x1b[31m{\"garbage\": [\n::error::", stdout);
  std::fputs("\x1b[31mgarbage", stderr);
  std::fflush(stdout);
}

/// What it does to the process that it runs in, beside its answer.
void leave_traces() {
  if (behaviour() == "rounds-down") std::fesetround(FE_DOWNWARD);
  if (behaviour() == "forks") fork();
  if (behaviour() == "prints") print_garbage();
#if defined(__x86_64__)
  if (behaviour() == "flushes") _mm_setcsr(_mm_getcsr() | 0x8040);
  if (behaviour() == "traps") _mm_setcsr(_mm_getcsr() & ~0x0080U);
#endif
}

/// As its behaviour has it: what a separation is named after claims no more.
manifuzz_declaration declaration() {
  manifuzz_declaration declared{};
  declared.interface = MANIFUZZ_INTERFACE;
  declared.name = "behaving";
  declared.version = "1.0";
  declared.scalar = MANIFUZZ_FLOAT64;
  declared.rounds_in = declared.answers_in = MANIFUZZ_FRAME_OF_A;
  declared.points = MANIFUZZ_MIDPOINTS;
  declared.normal = MANIFUZZ_B_TO_A;
  declared.vertices_max = MANIFUZZ_VERTICES_MAX;
  declared.takes_radius = 1;
  if (behaviour() == "separation") declared.claims.answers = MANIFUZZ_CLAIMS_SEPARATION;
  if (behaviour() == "touching") declared.claims.answers = MANIFUZZ_CLAIMS_TOUCHING;
  if (behaviour() == "unknown-claim") declared.claims.answers = 7;
  if (behaviour() == "unclipped") declared.claims.does_not_clip = 1;
  if (behaviour() == "no-shapes") declared.claims.alters_shapes = 1;
  if (behaviour() == "choosy") {
    declared.claims.vertices_min = declared.claims.takes_round = 1;
    declared.claims.least_polygon_turn = 0.1;
  }
  if (behaviour() == "unsourced") declared.claims.tolerance_absolute = 1;
  return declared;
}

}  // namespace

extern "C" {

extern const manifuzz_declaration manifuzz_collider;
const manifuzz_declaration manifuzz_collider = declaration();

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  static const Collider clip64 = make_clip64();
  test::misbehave(behaviour(), a->vertices[0].x, b->position.y);
  const PairCase pair{from_c(*a), from_c(*b)};
  const Answer answer = clip64.collide(pair);
  const auto& found = std::get<Manifold<double>>(answer);
  manifold->count = found.count;
  manifold->touching = found.count > 0 ? 1 : 0;
  manifold->depth = std::max(found.points[0].depth, found.points[1].depth);
  manifold->normal = {-found.normal.x(), -found.normal.y()};
  for (int i = 0; i < found.count; ++i) {
    const Vector2<double> position = midpoint(found, pair, i);
    manifold->points[i] = {{position.x(), position.y()},
                           found.points[i].depth,
                           to_c(found.points[i].features.a),
                           to_c(found.points[i].features.b)};
  }
  if (behaviour() == "garbage" && test::is_unlucky(a->vertices[0].x, b->position.y)) {
    manifold->count = 7;
  }
  if (behaviour() == "nan" && found.count > 0) {
    manifold->points[0].depth = std::numeric_limits<double>::quiet_NaN();
  }
  if (test::is_unlucky(a->vertices[0].x, b->position.y)) leave_traces();
  if (behaviour() == "shallow" && found.count > 0) manifold->points[0].depth /= 2;
  return 0;
}
}
