// Copied with the bugs planted into the methods other than clipping, and compiled under a namespace
// of theirs.
#include "canary/planted.hpp"
#include "own_colliders/gjk.cpp"

namespace manifuzz {
namespace {

/// What a step before may have left: where the cores were when B stood elsewhere, or vertices that
/// depend on nothing but the numbers of the pair, some of which it does not have.
methods::Simplex hint_of(const PairCase& pair) {
  const auto bits = std::bit_cast<std::uint32_t>(pair.b.pose.position.x()) ^
                    std::bit_cast<std::uint32_t>(pair.a.polygon.vertices[0].y());
  methods::Simplex hint;
  if (bits % 2 == 0) {
    Pose<float> before = relative_pose(pair.a.pose, pair.b.pose);
    before.position *= 1 + static_cast<float>(bits / 2 % 8) / 8;
    methods::contact_by_gjk(pair.a.polygon, pair.b.polygon, before, hint);
    return hint;
  }
  hint.count = static_cast<int>(bits / 2 % 4);
  for (int k = 0; k < 3; ++k) {
    hint.vertices[k] = {static_cast<unsigned char>((bits >> (8 + 6 * k)) % 8),
                        static_cast<unsigned char>((bits >> (11 + 6 * k)) % 8)};
  }
  return hint;
}

Collider make_gjk_hinted() {
  Collider collider = make_gjk();
  collider.declaration.name = "gjk with a hint";
  collider.collide = [](const PairCase& pair) {
    return answer_of<float>(pair, [&](const auto& a, const auto& b, const Pose<float>& b_in_a) {
      methods::Simplex hint = hint_of(pair);
      methods::contact_by_gjk(a, b, b_in_a, hint);
      return methods::contact_by_gjk(a, b, b_in_a, hint).manifold;
    });
  };
  return collider;
}

[[maybe_unused]] const bool planted =
    canary::add_methods({PLANTED_BUGS}, {make_gjk, make_gjk64, make_gjk_hinted, make_gjk_clip});

}  // namespace
}  // namespace manifuzz
