// What the engine that is linked in, by manifuzz_collider.h, answers to the cases of every regime:
// a line each, the regime and the hash of all bits.

#include <cstdio>

#include "collider/answer_hash.hpp"
#include "external/c_body.hpp"
#include "generating/regime.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kCases = 2000;

bool takes(const Body& body) {
  const manifuzz_claims& claims = manifuzz_collider.claims;
  const ConvexPolygon<float>& polygon = body.polygon;
  if (polygon.count < kMinVertices)
    return polygon.count >= claims.vertices_min && claims.vertices_min > 0;
  if (polygon.is_round()) return claims.takes_round != 0;
  return polygon.count <= manifuzz_collider.vertices_max &&
         (polygon.radius == 0 || manifuzz_collider.takes_radius != 0);
}

void add(Hash& hash, const manifuzz_double2& v) {
  hash.add(v.x);
  hash.add(v.y);
}

void add_answer(Hash& hash, const PairCase& pair) {
  const manifuzz_body a = c_body(pair.a);
  const manifuzz_body b = c_body(pair.b);
  manifuzz_manifold manifold{};
  hash.add(static_cast<std::uint64_t>(manifuzz_collide(&a, &b, &manifold)));
  hash.add(static_cast<std::uint64_t>(manifold.count));
  if (manifold.count == 0) return;
  add(hash, manifold.normal);
  for (int i = 0; i < manifold.count; ++i) {
    add(hash, manifold.points[i].position);
    hash.add(manifold.points[i].depth);
  }
}

}  // namespace
}  // namespace manifuzz

int main() {
  using namespace manifuzz;
  for (const Regime& regime : regimes()) {
    Hash hash;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const PairCase pair = generate(kSeed, regime, i);
      if (takes(pair.a) && takes(pair.b)) add_answer(hash, pair);
    }
    std::printf("%.*s %016llx\n", static_cast<int>(regime.name.size()), regime.name.data(),
                static_cast<unsigned long long>(hash.value()));
  }
}
