#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "unit/scene/commands.hpp"
#include "unit/scene/crowd.hpp"
#include "unit/scene/own_scene.hpp"

// What a scene skips changes nothing: every step's contacts are those of every pair afresh.

using namespace manifuzz;

namespace {

constexpr test::MakeScene kMake = test::Adapted<test::OwnScene>::make;

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

TEST_CASE("a crowd with more pairs than wait together equals its pairs afresh bit for bit") {
  CHECK(test::dense_crowd_complaint(kMake).value_or("sound") == "sound");
}
