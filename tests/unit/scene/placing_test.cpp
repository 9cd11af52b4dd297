#include "scene/placing.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "geometry/manifold.hpp"
#include "unit/scene/motion.hpp"

// What placing many bodies at once leaves behind: what placing one after the other does.

using namespace manifuzz;
using scene::Move;

namespace {

constexpr std::uint32_t kBodies = 100;

/// Bodies in any state, some of which have moved in this step already.
struct Placed {
  std::vector<scene::ShapeFacts> facts{{0.5F, 0, 0}, {2, 0.25F, 0}};
  std::vector<kernel::Placement<float>> placements;
  std::vector<std::uint8_t> states;
  std::vector<float> paths;
  std::vector<float> leave_at;
  std::vector<std::uint32_t> moved;
  std::vector<scene::Mover> unsure;

  explicit Placed(std::uint64_t seed) {
    Random random = test::motion(seed);
    for (std::uint32_t i = 0; i < kBodies; ++i) {
      placements.push_back({i % 2, test::anywhere(random.bits())});
      states.push_back(static_cast<std::uint8_t>(random.integer(0, 255)));
      paths.push_back(static_cast<float>(random.uniform(0, 4)));
      leave_at.push_back(paths.back() + static_cast<float>(random.uniform(-0.1, 1)));
    }
  }

  void place(std::span<const Move> moves) {
    const std::size_t moved_before = moved.size();
    const std::size_t unsure_before = unsure.size();
    moved.resize(moved_before + moves.size());
    unsure.resize(unsure_before + moves.size());
    const auto counts = scene::place_moves(
        moves, {facts.data(), placements.data(), states.data(), paths.data(), leave_at.data(),
                moved.data() + moved_before, unsure.data() + unsure_before});
    moved.resize(moved_before + counts.moved);
    unsure.resize(unsure_before + counts.unsure);
  }
};

/// Runs of bodies one after another, of any length, that go somewhere, hardly move or stay.
std::vector<Move> any_moves(const Placed& placed, std::uint64_t seed) {
  Random random = test::motion(seed);
  std::vector<Move> moves;
  for (int run = random.integer(0, 6); run > 0; --run) {
    const auto first = static_cast<std::uint32_t>(random.integer(0, kBodies - 1));
    const auto last = std::min(first + static_cast<std::uint32_t>(random.integer(1, 40)), kBodies);
    const bool is_mixed = random.chance(0.3);
    for (std::uint32_t body = first; body < last; ++body) {
      const Pose<float>& pose = placed.placements[body].pose;
      const int kind = random.integer(0, 3);
      moves.push_back({{is_mixed ? kBodies - 1 - body : body, 1},
                       kind == 0   ? pose
                       : kind == 1 ? test::shifted(pose, random.bits())
                       : kind == 2 ? test::turned(pose, random.bits())
                                   : test::anywhere(random.bits())});
    }
  }
  return moves;
}

/// One of its numbers is no longer what it was, by much or by little.
void spoil(Move& move, Random& random) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float numbers[] = {kNaN, kInfinity, -kInfinity, 1e15F, 1.001e15F, -1.001e15F, 0};
  const float number = numbers[random.integer(0, 6)];
  switch (random.integer(0, 4)) {
    case 0:
      move.body.index = static_cast<std::uint32_t>(random.bits());
      return;
    case 1:
      move.body.generation += static_cast<std::uint32_t>(random.integer(1, 2));
      return;
    case 2:
      move.pose.position[random.integer(0, 1)] = number;
      return;
    case 3:
      move.pose.rotation[random.integer(0, 1)] = number;
      return;
    default:  // to where a rotation is unit no more
      move.pose.rotation *= static_cast<float>(1 + random.uniform(4.9e-6, 5.1e-6));
  }
}

bool is_same(const Placed& one, const Placed& other) {
  const auto same_placement = [](const auto& p, const auto& q) {
    return p.shape == q.shape && same_bits(p.pose, q.pose);
  };
  const auto same_mover = [](const scene::Mover& p, const scene::Mover& q) {
    return p.body == q.body && same_bits(p.from, q.from);
  };
  return std::ranges::equal(one.placements, other.placements, same_placement) &&
         one.states == other.states && one.paths == other.paths && one.moved == other.moved &&
         std::ranges::equal(one.unsure, other.unsure, same_mover);
}

}  // namespace

TEST_CASE("many moves at once leave what they leave one by one") {
  CHECK(rc::check("whatever moves, in whatever order", [](std::uint64_t seed) {
    Placed at_once(seed);
    Placed one_by_one = at_once;
    const std::vector<Move> moves = any_moves(at_once, seed + 1);
    at_once.place(moves);
    for (const Move& move : moves) one_by_one.place(std::span(&move, 1));
    RC_ASSERT(is_same(at_once, one_by_one));
  }));
}

TEST_CASE("many moves are sound where each of them is") {
  CHECK(rc::check("whatever is wrong with some, or nothing", [](std::uint64_t seed) {
    Random random = test::motion(seed);
    const std::vector<Move> sound = any_moves(Placed(seed), seed + 1);
    const std::vector<std::uint32_t> generations(random.chance(0.1) ? kBodies / 2 : kBodies, 1);
    const auto is_sound = [&](const Move& move) {
      return scene::are_sound(std::span(&move, 1), generations);
    };
    for (int spoilt = 0; spoilt < 20; ++spoilt) {
      std::vector<Move> moves = sound;
      if (!moves.empty() && spoilt > 0) {
        const int last = static_cast<int>(moves.size()) - 1;
        spoil(moves[static_cast<std::size_t>(random.integer(0, last))], random);
      }
      RC_ASSERT(scene::are_sound(moves, generations) == std::ranges::all_of(moves, is_sound));
    }
  }));
}

TEST_CASE("a move is sound of a body that is there, to a pose without a defect") {
  const std::vector<std::uint32_t> generations{1, 2, 3};
  const auto is_sound = [&](const Move& move) {
    return scene::are_sound(std::span(&move, 1), generations);
  };
  const Pose<float> pose;
  CHECK(is_sound({{2, 3}, pose}));
  CHECK_FALSE(is_sound({{2, 1}, pose}));
  CHECK_FALSE(is_sound({{1, 2}, pose}));
  CHECK_FALSE(is_sound({{3, 1}, pose}));
  CHECK_FALSE(is_sound({{0, 1}, {{std::numeric_limits<float>::quiet_NaN(), 0}, {1, 0}}}));
  CHECK_FALSE(is_sound({{0, 1}, {{0, 0}, {1, 0.01F}}}));
  CHECK_FALSE(scene::are_sound(std::vector<Move>{{{0, 1}, pose}}, {}));
}

TEST_CASE("a body that moves twice in a step is told of once, and goes both ways") {
  Placed placed(1);
  placed.states.assign(kBodies, 0);
  placed.leave_at.assign(kBodies, 0);
  Pose<float> pose = placed.placements[7].pose;
  const float path = placed.paths[7];
  const Pose<float> start = pose;
  std::vector<Move> moves;
  for (const float x : {1.0F, -2.0F}) {
    pose.position.x() += x;
    moves.push_back({{7, 1}, pose});
  }
  placed.place(moves);
  CHECK(same_bits(placed.placements[7].pose, pose));
  CHECK(placed.moved == std::vector<std::uint32_t>{7});
  REQUIRE(placed.unsure.size() == 1);
  CHECK(same_bits(placed.unsure[0].from, start.position));
  CHECK(placed.paths[7] >= path + 3);
  CHECK(placed.states[7] == (scene::kMoved | scene::kUnsure));
}
