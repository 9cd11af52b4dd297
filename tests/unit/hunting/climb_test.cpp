#include "hunting/climb.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "hunting/wrong_answers.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

Summit summit_named(std::string_view name, const Declaration& declaration) {
  for (const Summit& summit : summits_of(declaration)) {
    if (summit.name == name) return summit;
  }
  FAIL("no summit has that name");
  return {};
}

Observation seen(const Collider& collider, const PairCase& pair) {
  const exact::Truth truth(pair);
  const Answer answer = collider.collide(pair);
  return shares_observed(unowned(truth), {collider.declaration, answer});
}

}  // namespace

TEST_CASE("a climb is made again by its arguments, and its shares are those of its cases") {
  const Collider clip = make_clip();
  for (const Summit& summit : summits_of(clip.declaration)) {
    CAPTURE(summit.name);
    for (const std::uint64_t index : {0U, 1U, 2U}) {
      const Climbed once = climb(summit, clip, {}, 7, index, 2000);
      const Climbed again = climb(summit, clip, {}, 7, index, 2000);
      CHECK_FALSE(once.wrong);
      for (std::size_t k = 0; k < kGauges; ++k) {
        CHECK(once.highest[k].share == again.highest[k].share);
        if (once.highest[k].share == 0) continue;
        CHECK(once.highest[k].pair == again.highest[k].pair);
        CHECK(is_round(once.highest[k].pair) == summit.is_round);
        CHECK(seen(clip, once.highest[k].pair).gauges[k] == once.highest[k].share);
        CHECK_FALSE(wrong_answer(clip, once.highest[k].pair));
      }
    }
  }
}

TEST_CASE("a climb of more cases goes on from where one of fewer ended, higher") {
  const Collider clip = make_clip();
  const Summit depth = summit_named("depth", clip.declaration);
  double highest = 0;
  // Every third climb begins with the best of drawn cases, whatever their rotations.
  for (const std::uint64_t index : {0U, 3U, 6U}) {
    const double low = climb(depth, clip, {}, 7, index, 500)[Gauge::depth_share].share;
    const double high = climb(depth, clip, {}, 7, index, 20000)[Gauge::depth_share].share;
    CHECK(low < high);
    highest = std::max(highest, high);
  }
  CHECK(highest > 0.4);
  CHECK(highest <= 1);
}

TEST_CASE("a climb that begins with a founder is at least as high as that") {
  const Collider clip = make_clip();
  const Summit position = summit_named("position", clip.declaration);
  const Height founder = climb(position, clip, {}, 7, 0, 20000)[Gauge::position_share];
  const std::vector<PairCase> founders{founder.pair};
  CHECK(climb(position, clip, founders, 8, 2, 10)[Gauge::position_share].share >= founder.share);
}

TEST_CASE("one climb of three stays where rotations are unit but for rounding") {
  const Collider clip = make_clip();
  const PairCase highest =
      climb(summit_named("normal", clip.declaration), clip, {}, 7, 1, 5000)[Gauge::normal_share]
          .pair;
  CHECK(rotation_defect(highest.a) <= 0x1p-22);
  CHECK(rotation_defect(highest.b) <= 0x1p-22);
}

TEST_CASE("a collider that is wrong now and then is seen to be") {
  Collider planted = make_clip();
  planted.collide = [clip = make_clip().collide](const PairCase& pair) {
    Answer answer = clip(pair);
    auto& manifold = std::get<Manifold<double>>(answer);
    if (pair.a.polygon.count == 5 && manifold.count == 2)
      manifold.points[0].depth += size(pair) / 8;
    return answer;
  };
  const Summit depth = summit_named("depth", planted.declaration);
  const Climbed climbed = climb(depth, planted, {}, 7, 0, 5000);
  REQUIRE(climbed.wrong);
  CHECK(wrong_answer(planted, *climbed.wrong));
  CHECK_FALSE(wrong_answer(planted, climbed[Gauge::depth_share].pair));
}
