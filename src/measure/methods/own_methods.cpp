#include <algorithm>

#include "measure/methods/methods.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// The kernel of the widest instruction set, which comes first.
MethodSubject of_bench(std::string method, const std::string& name) {
  static const std::vector<BenchSubject> all = own_subjects();
  return {std::move(method), *std::ranges::find(all, name, &BenchSubject::name)};
}

MethodSubject keeper(std::string name, SequenceCollider (*make)()) {
  return {"points kept", {.name = std::move(name)}, make};
}

}  // namespace

std::vector<MethodSubject> own_methods() {
  return {of_bench("clipping", "clip"),
          of_bench("clipping", "pair"),
          of_bench("separating axes", "sat"),
          of_bench("closest points", "gjk"),
          of_bench("closest points", "gjk+hint"),
          of_bench("of shrunk shapes", "gjk-shrunk"),
          of_bench("GJK, then clipping", "gjk-clip"),
          keeper("cached", make_cached),
          keeper("cached-bullet", make_cached_bullet),
          of_bench("perturbed", "perturbed")};
}

}  // namespace manifuzz
