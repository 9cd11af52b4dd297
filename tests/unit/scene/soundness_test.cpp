#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "scene/scene.hpp"
#include "unit/scene/commands.hpp"
#include "unit/scene/crowd.hpp"

// What a scene skips changes nothing: every step's contacts are those of every pair afresh.

using namespace manifuzz;

namespace {

struct Api {
  using Scene = scene::Scene;
  using BodyHandle = scene::BodyHandle;
  using Move = scene::Move;
  using BodyPart = scene::BodyPart;
  using Filter = scene::Filter;
  using Rules = scene::Rules;
};

constexpr test::MakeScene kMake = test::Adapted<Api>::make;

}  // namespace

TEST_CASE("a scene equals its pairs afresh bit for bit, whatever happens to it") {
  CHECK(rc::check("commands between steps", [] { test::check_commands(kMake); }));
}

TEST_CASE("a crowd that drifts, turns and jumps equals its pairs afresh bit for bit") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    CHECK(test::crowd_complaint(kMake, seed).value_or("sound") == "sound");
  }
}
