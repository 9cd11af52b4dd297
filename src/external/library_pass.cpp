#include <memory>
#include <vector>

#include "external/external_collider.hpp"

namespace manifuzz {
namespace {

using Collide = decltype(&manifuzz_collide);

struct BodyPair {
  manifuzz_body a;
  manifuzz_body b;
};

std::function<void()> pass_of(Collide collide, std::span<const PairCase> pairs) {
  std::vector<BodyPair> bodies;
  for (const PairCase& pair : pairs) bodies.push_back({c_body(pair.a), c_body(pair.b)});
  const auto out = std::make_shared<std::vector<manifuzz_manifold>>(pairs.size());
  return [collide, bodies, out] {
    const CallWatch watch;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      (*out)[i] = {};
      collide(&bodies[i].a, &bodies[i].b, &(*out)[i]);
      if (watch.is_in_forked()) break;  // it ends below
    }
    watch.end();
  };
}

/// Reached through a pointer that the compiler cannot follow, as a library's is.
int collide_nothing(const manifuzz_body*, const manifuzz_body*, manifuzz_manifold*) {
  return 0;
}
constinit Collide volatile nothing = collide_nothing;

}  // namespace

std::function<void()> library_pass(const std::string& path, std::span<const PairCase> pairs) {
  return pass_of(Library(path).function(), pairs);
}

std::function<void()> interface_pass(std::span<const PairCase> pairs) {
  return pass_of(nothing, pairs);
}

}  // namespace manifuzz
