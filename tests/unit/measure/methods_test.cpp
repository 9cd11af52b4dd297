#include "measure/methods/methods.hpp"

#include <catch2/catch.hpp>

#include "measure/methods/method_errors.hpp"
#include "own_colliders/own_colliders.hpp"
#include "sequence/motions.hpp"

using namespace manifuzz;

namespace {

Body box_at(float x, float y) {
  const std::array<Vector2<float>, 4> corners{Vector2<float>{-1, -1}, Vector2<float>{1, -1},
                                              Vector2<float>{1, 1}, Vector2<float>{-1, 1}};
  Body body;
  body.polygon = make_polygon<float>(corners);
  body.pose.position = {x, y};
  return body;
}

/// One box on another: they touch from (0.5, 0.75) to (1, 0.75), 0.25 deep.
const PairCase kResting{box_at(0, 0), box_at(1.5F, 1.75F)};

TouchingPoints points_at(std::vector<double> places) {
  TouchingPoints said{
      .is_answered = true, .touches = true, .normal = {0, 1}, .depth = 0.25, .points = {}};
  for (const double x : places) said.points.push_back({{x, 0.75}, 0.25, {}});
  return said;
}

/// What is measured of these answers to a contact that does not change.
MethodCollector collected(const std::vector<TouchingPoints>& frames) {
  const TrueContact truth(kResting);
  MethodCollector collector;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    collector.add(i, truth, make_clip().declaration, frames[i], i == 0);
  }
  return collector;
}

const TouchingPoints kBoth = points_at({0.5, 1});
const TouchingPoints kOne = points_at({1});

}  // namespace

TEST_CASE("a resting contact has two points in the exact clip") {
  const TrueContact truth(kResting);
  CHECK(truth.clip == ClipNow{.is_decided = true, .count = 2});
  const TrueContact apart({box_at(0, 0), box_at(0, 3)});
  CHECK(apart.clip == ClipNow{.is_decided = true, .count = 0});
  const TrueContact touching({box_at(0, 0), box_at(0, 2)});
  CHECK_FALSE(touching.clip.is_decided);
}

TEST_CASE("what is complete in the third frame takes three frames, and flickers once") {
  const MethodCollector late = collected({kOne, kOne, kBoth, kBoth, kBoth});
  CHECK(late.frames().frames_to_complete == 3.0);
  CHECK(late.frames().completed == 1);
  CHECK(late.frames().flicker == 0.25);
  CHECK(late.errors().points_missing == Approx(0.4));
  CHECK(late.errors().extent_lost == Approx(0.4));
}

TEST_CASE("what is never complete has no number of frames") {
  const MethodCollector never = collected({kOne, kOne, kOne, kOne});
  CHECK_FALSE(never.frames().frames_to_complete.has_value());
  CHECK(never.frames().completed == 0);
  CHECK(never.frames().flicker == 0);
  CHECK(never.errors().extent_lost == 1);
}

TEST_CASE("points where the shapes are not in front of each other linger") {
  CHECK(lingering_points(kResting, kBoth, 1e-5) == 0);
  CHECK(lingering_points(kResting, points_at({0.25, 1}), 1e-5) == 1);
  CHECK(lingering_points({box_at(0, 0), box_at(0, 2.5F)}, points_at({0}), 1e-5) == 1);
}

TEST_CASE("of points that are kept those that touch count, the deepest first") {
  KeptManifold kept;
  kept.points.resize(3);
  kept.points[0].depth = -0.1;
  kept.points[1].depth = 0.1;
  kept.points[2].depth = 0.2;
  kept.points[1].normal = kept.points[2].normal = {0, 1};
  kept.points[1].anchor_b = {-1, -1};
  kept.points[2].anchor_b = {1, -1};
  const TouchingPoints said = touching_points(kResting, kept);
  REQUIRE(said.points.size() == 2);
  CHECK(said.depth == 0.2);
  CHECK((said.points[0].position - Vector2<double>(2.5, 0.75)).norm() < 1e-12);
  CHECK(said.ends().count == 2);
}

TEST_CASE("clipping leaves nothing out and does not flicker, the deepest point alone leaves all") {
  const auto measured = [](const Collider& collider) {
    MethodCollector collector;
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Sequence sequence = draw_sequence(1, *find_motion("resting"), i);
      for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
        const PairCase pair = sequence.at(k);
        if (is_round(pair) || total_radius(pair) > 0) continue;
        const TrueContact truth(pair);
        collector.add(k, truth, collider.declaration, touching_points(collider.collide(pair)),
                      k == 0);
      }
    }
    return collector;
  };
  const MethodCollector clip = measured(make_clip());
  CHECK(clip.errors().contacts > 20);
  CHECK(clip.errors().points_missing == 0);
  CHECK(clip.errors().extent_lost == 0);
  CHECK(clip.frames().frames_to_complete == 1.0);
  CHECK(clip.frames().lingering == 0);
  CHECK(clip.frames().flicker == 0);
  const MethodCollector gjk = measured(make_gjk());
  CHECK(gjk.errors().extent_lost == 1);
  CHECK_FALSE(gjk.frames().frames_to_complete.has_value());
}
