#include "hunting/rare_colliders.hpp"

#include "hunting/rare_bugs.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz::test {

std::size_t index_of_bug(std::string_view name) {
  std::size_t i = 0;
  while (rare_bugs()[i].name != name) ++i;
  return i;
}

Collider with_rare_bug(std::string_view name) {
  Collider collider = make_clip();
  collider.declaration.name = "planted";
  const std::size_t bug = index_of_bug(name);
  collider.collide = [bug, clip = make_clip()](const PairCase& pair) {
    Answer answer = clip.collide(pair);
    if ((rare_bugs_met_by(exact::Truth(pair)) >> bug & 1) == 0) return answer;
    if (auto* const manifold = std::get_if<Manifold<double>>(&answer)) {
      for (ContactPoint<double>& point : manifold->points) point.depth += size(pair) / 4;
    }
    return answer;
  };
  collider.with_tie_bias = nullptr;  // another collider, which has no bug
  return collider;
}

}  // namespace manifuzz::test
