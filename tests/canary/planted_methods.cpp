// Copied with the bugs planted into the methods other than clipping, and compiled under a namespace
// of theirs.
#include "canary/planted.hpp"
#include "own_colliders/gjk.cpp"
#include "own_colliders/perturbed.cpp"

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
  const bool is_of_pair = bits / 8 % 4 > 0;
  const auto index = [&](int shift, int count) {
    return static_cast<unsigned char>((bits >> shift) % (is_of_pair ? count : kMaxVertices));
  };
  for (int k = 0; k < 3; ++k) {
    hint.vertices[k] = {index(8 + 6 * k, pair.a.polygon.count),
                        index(11 + 6 * k, pair.b.polygon.count)};
  }
  return hint;
}

Collider asked_with(const std::string& name, methods::Simplex (*hint_of_pair)(const PairCase&)) {
  Collider collider = make_gjk();
  collider.declaration.name = name;
  collider.collide = [hint_of_pair](const PairCase& pair) {
    return own::answer_of<float>(pair,
                                 [&](const auto& a, const auto& b, const Pose<float>& b_in_a) {
                                   methods::Simplex hint = hint_of_pair(pair);
                                   return methods::contact_by_gjk(a, b, b_in_a, hint).manifold;
                                 });
  };
  return collider;
}

Collider make_gjk_hinted() {
  return asked_with("gjk with a hint", hint_of);
}

/// With what it left itself.
Collider make_gjk_again() {
  return asked_with("gjk asked again", [](const PairCase& pair) {
    methods::Simplex hint;
    methods::contact_by_gjk(pair.a.polygon, pair.b.polygon, relative_pose(pair.a.pose, pair.b.pose),
                            hint);
    return hint;
  });
}

[[maybe_unused]] const bool planted =
    canary::add_methods({PLANTED_BUGS}, {make_gjk, make_gjk64, make_gjk_hinted, make_gjk_again,
                                         make_gjk_clip, make_perturbed, make_perturbed64});

}  // namespace
}  // namespace manifuzz
