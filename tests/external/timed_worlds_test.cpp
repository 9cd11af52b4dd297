#include <array>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "engines/asked_engines.hpp"
#include "external/timed_world.hpp"
#include "geometry/convex_polygon.hpp"
#include "support/skip.hpp"

using namespace manifuzz;

namespace {

Body box_at(float x) {
  const std::array<Vector2<float>, 4> corners{
      Vector2<float>{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, 0.5F}};
  return {make_polygon<float>(corners, 0.01F), {{x, 0}, {1, 0}}};
}

manifuzz_move move_to(std::uint32_t body, float x, Vector2<float> rotation = {1, 0}) {
  return {body, {x, 0}, {rotation.x(), rotation.y()}};
}

/// How many touch where these moves leave the bodies.
std::size_t contacts_after(TimedWorld& world, const std::vector<manifuzz_move>& moves) {
  world.step(moves);
  return world.contacts();
}

}  // namespace

TEST_CASE("a world of a library is stepped, and says its time and contacts") {
  const std::array bodies{box_at(-1), box_at(1), box_at(2)};
  TimedWorld world(MANIFUZZ_TEST_TIMED_WORLDS, "sound", bodies);
  CHECK(world.contacts() == 1);
  const std::array moves{move_to(1, -3), move_to(2, -2)};
  CHECK(world.step(moves) == 2000);
  CHECK(world.contacts() == 3);
}

TEST_CASE("what a library's worlds refuse or get wrong is one clear line") {
  const std::array bodies{box_at(0)};
  const auto says = [](const std::string& text) { return Catch::Contains(text); };
  CHECK_THROWS_WITH(TimedWorld(MANIFUZZ_TEST_TIMED_WORLDS, "nobody's", bodies),
                    says("has no world nobody's"));
  CHECK_THROWS_WITH(TimedWorld(MANIFUZZ_TEST_LIBRARY, "sound", bodies),
                    says("has no manifuzz_timed_world_create; see manifuzz_timed_world.h"));
  std::array with_circle{box_at(0), box_at(1)};
  with_circle[1].polygon = make_polygon<float>(std::array{Vector2<float>(0, 0)}, 0.5F);
  CHECK_THROWS_WITH(TimedWorld(MANIFUZZ_TEST_TIMED_WORLDS, "sound", with_circle),
                    says("cannot take body 1"));
  TimedWorld broken(MANIFUZZ_TEST_TIMED_WORLDS, "broken", bodies);
  CHECK_THROWS_WITH(broken.step({}), says("a step of nan ns"));
  CHECK_THROWS_WITH(broken.contacts(), says("-1 contacts"));
}

TEST_CASE("a library has worlds or not") {
  CHECK(has_timed_worlds(MANIFUZZ_TEST_TIMED_WORLDS));
  CHECK_FALSE(has_timed_worlds(MANIFUZZ_TEST_LIBRARY));
  CHECK_FALSE(has_timed_worlds("./nothing.so"));
}

TEST_CASE("an installed engine's world has its bodies where they are moved, and pushes none") {
  const auto worlds = installed_timed_worlds();
  if (worlds.empty()) {
    test::skip("no engine that has a world is installed; scripts/setup --engines installs it");
    return;
  }
  for (const EngineTimedWorld& from : worlds) {
    CAPTURE(from.name);
    TimedWorld world(from.library, from.name, std::array{box_at(0), box_at(0.5F), box_at(9)});
    // Nothing is pushed apart, however long it overlaps.
    for (int step = 0; step < 50; ++step) CHECK(world.step({}) >= 0);
    CHECK(world.contacts() == 1);
    CHECK(contacts_after(world, {move_to(1, 5)}) == 0);
    CHECK(contacts_after(world, {move_to(2, 5.8F)}) == 1);
    // Apart by 0.2 unless one is turned by 45 degrees, in steps of 9.
    CHECK(contacts_after(world, {move_to(2, 6.2F)}) == 0);
    Vector2<float> rotation(1, 0);
    const Vector2<float> turn(0.98768834F, 0.15643447F);
    for (int step = 0; step < 5; ++step) {
      rotation = rotate(turn, rotation);
      world.step(std::array{move_to(2, 6.2F, rotation)});
    }
    CHECK(world.contacts() == 1);
  }
}
