#include "scene/scene.hpp"

#include <catch2/catch.hpp>

#include "unit/scene/squares.hpp"

using namespace manifuzz;
using scene::BodyHandle;
using scene::Defect;
using scene::Scene;
using scene::StepResult;
using test::kInfinity;
using test::square;

namespace {

Pose<float> upright(float x, float y) {
  return {{x, y}, {1, 0}};
}

/// A row of squares, each touching the next.
struct Row {
  Scene scene;
  std::uint32_t shape = std::get<std::uint32_t>(scene.add_shape(square(0.5F)));
  std::vector<BodyHandle> bodies;

  explicit Row(int count) {
    for (int i = 0; i < count; ++i) {
      bodies.push_back(
          std::get<BodyHandle>(scene.add(shape, upright(0.99F * static_cast<float>(i), 0))));
    }
  }

  StepResult step(std::span<const scene::Move> moves = {}) {
    return std::get<StepResult>(scene.step(moves));
  }
};

}  // namespace

TEST_CASE("contacts begin, stay and end") {
  Row row(3);
  const StepResult first = row.step();
  CHECK(first.contacts.size() == 2);
  CHECK(first.began.size() == 2);
  CHECK(first.counts.pairs.collided == first.counts.pairs.candidates);
  CHECK(first.counts.pairs_added == first.counts.pairs.candidates);

  const StepResult second = row.step();
  CHECK(second.contacts.size() == 2);
  CHECK(second.began.empty());
  CHECK(second.stayed == 2);
  CHECK(second.counts.pairs.at_rest == second.counts.pairs.candidates);

  const scene::Move away{row.bodies[2], upright(9, 0)};
  const StepResult third = row.step({{away}});
  REQUIRE(third.ended.size() == 1);
  CHECK(third.ended[0].a == row.bodies[1]);
  CHECK(third.ended[0].b == row.bodies[2]);
  CHECK(third.stayed == 1);
  CHECK(third.counts.pairs_dropped == second.counts.pairs.candidates - row.scene.pair_count());
  CHECK(row.step().ended.empty());
}

TEST_CASE("a body's contacts end with it, and its place is used again once that is told") {
  Row row(3);
  row.step();
  const std::size_t pairs = row.scene.pair_count();
  CHECK(row.scene.remove(row.bodies[1]) == std::nullopt);
  const std::size_t dropped = pairs - row.scene.pair_count();
  const BodyHandle instead = std::get<BodyHandle>(row.scene.add(row.shape, upright(0.99F, 0)));
  CHECK(instead.index != row.bodies[1].index);
  const StepResult result = row.step();
  CHECK(result.ended.size() == 2);
  CHECK(result.counts.pairs_dropped == dropped);
  for (const scene::EndedContact& ended : result.ended) {
    CHECK((ended.a == row.bodies[1] || ended.b == row.bodies[1]));
  }
  CHECK(result.began.size() == 2);
  const BodyHandle again = std::get<BodyHandle>(row.scene.add(row.shape, upright(50, 0)));
  CHECK(again.index == row.bodies[1].index);
  CHECK(again != row.bodies[1]);
}

TEST_CASE("a scene at rest looks at nothing, a mover at its own pairs") {
  Row row(1000);
  row.step();
  const scene::Move there{row.bodies[500], row.scene.pose(row.bodies[500])};
  CHECK(row.step({{there}}).counts.moved == 0);
  const scene::Move nudge{row.bodies[500], upright(0.99F * 500, 0.01F)};
  const StepResult result = row.step({{nudge}});
  CHECK(result.counts.moved == 1);
  CHECK(result.counts.left_boxes == 0);
  CHECK(result.counts.pairs.collided == 2);
  CHECK(result.contacts.size() == 999);
}

TEST_CASE("a pair proven separated is skipped until it has moved by its margin") {
  Row row(0);
  const auto add = [&](float x) {
    return std::get<BodyHandle>(row.scene.add(row.shape, upright(x, 0)));
  };
  add(0);
  const BodyHandle b = add(1.1F);
  CHECK(row.step().counts.proofs == 1);
  CHECK(row.step({{{b, upright(1.05F, 0)}}}).counts.pairs.separated == 1);
  CHECK(row.step({{{b, upright(1.01F, 0)}}}).counts.pairs.separated == 1);
  const StepResult touching = row.step({{{b, upright(1, 0)}}});
  CHECK(touching.counts.pairs.collided == 1);
  CHECK(touching.contacts.size() == 1);
}

TEST_CASE("a floor under all bodies comes and goes") {
  constexpr int kBodies = 5000;
  scene::Scene scene;
  const auto add = [&](std::uint32_t shape, const Pose<float>& pose) {
    return std::get<BodyHandle>(scene.add(shape, pose));
  };
  const auto step = [&](std::span<const scene::Move> moves) {
    return std::get<StepResult>(scene.step(moves));
  };
  const auto small = std::get<std::uint32_t>(scene.add_shape(square(0.4F)));
  const auto large = std::get<std::uint32_t>(scene.add_shape(square(kBodies)));
  const BodyHandle floor = add(large, upright(kBodies / 2, 0.5F - kBodies));
  std::vector<BodyHandle> bodies;
  for (int i = 0; i < kBodies; ++i)
    bodies.push_back(add(small, upright(static_cast<float>(i), 0.85F)));
  CHECK(step({}).contacts.size() == kBodies);

  const scene::Move away{floor, upright(kBodies / 2, -3 * kBodies)};
  CHECK(step({{away}}).ended.size() == kBodies);
  const scene::Move back{floor, upright(kBodies / 2, 0.5F - kBodies)};
  CHECK(step({{back}}).began.size() == kBodies);

  std::vector<scene::Move> nudges;
  for (int i = 0; i < kBodies; i += 50) {
    nudges.push_back({bodies[static_cast<std::size_t>(i)], upright(static_cast<float>(i), 0.86F)});
  }
  CHECK(step(nudges).counts.pairs.collided == nudges.size());

  CHECK(scene.remove(floor) == std::nullopt);
  CHECK(step({}).ended.size() == kBodies);
}

TEST_CASE("a body that shakes on the spot begins a new path now and then") {
  Row row(0);
  std::get<BodyHandle>(row.scene.add(row.shape, upright(0, 0)));
  const auto b = std::get<BodyHandle>(row.scene.add(row.shape, upright(1.1F, 0)));
  row.step();
  std::size_t begun = 0;
  std::size_t collided = 0;
  for (int i = 0; i < 20'000; ++i) {
    const StepResult result = row.step({{{b, upright(i % 2 == 0 ? 1.11F : 1.1F, 0)}}});
    REQUIRE(result.contacts.empty());
    begun += result.counts.left_boxes;
    collided += result.counts.pairs.collided;
  }
  CHECK(begun > 0);
  CHECK(begun < 20);
  CHECK(collided <= 2 * begun);
}

TEST_CASE("without certificates every pair that moved is collided, to the same contacts") {
  scene::Scene with;
  scene::Scene without({.certificates = false});
  const auto contacts_after = [](scene::Scene& scene, float x) {
    const auto shape = std::get<std::uint32_t>(scene.add_shape(square(0.5F)));
    scene.add(shape, upright(0, 0));
    const auto b = std::get<BodyHandle>(scene.add(shape, upright(1.1F, 0)));
    scene.step({});
    return std::get<StepResult>(scene.step({{{b, upright(x, 0)}}}));
  };
  CHECK(contacts_after(with, 1.05F).counts.pairs.separated == 1);
  const StepResult apart = contacts_after(without, 1.05F);
  CHECK(apart.counts.pairs.collided == apart.counts.pairs.candidates - apart.counts.pairs.at_rest);
  CHECK(apart.counts.proofs == 0);
  CHECK(contacts_after(without, 0.9F).counts.pairs.separated == 0);
}

TEST_CASE("the time of a step at rest has nothing to do with the bodies: no counter rises") {
  Row row(100);
  row.step();
  const StepResult result = row.step();
  CHECK(result.counts.moved == 0);
  CHECK(result.counts.left_boxes == 0);
  CHECK(result.counts.proofs == 0);
  CHECK(result.counts.pairs.separated + result.counts.pairs.collided == 0);
}

TEST_CASE("bodies of every size find each other") {
  Scene scene;
  std::vector<BodyHandle> bodies;
  for (int k = -20; k <= 20; k += 4) {
    const float half = std::ldexp(1.0F, k);
    const auto shape = std::get<std::uint32_t>(scene.add_shape(square(half)));
    bodies.push_back(std::get<BodyHandle>(scene.add(shape, upright(half / 2, half / 3))));
  }
  const auto result = std::get<StepResult>(scene.step({}));
  CHECK(result.contacts.size() == bodies.size() * (bodies.size() - 1) / 2);
}

TEST_CASE("far out, where a float is wider than a body, bodies find each other") {
  Row row(0);
  row.scene.add(row.shape, upright(1e12F, -1e15F));
  row.scene.add(row.shape, upright(1e12F, -1e15F));
  row.scene.add(row.shape, upright(-1e12F, 1e15F));
  CHECK(row.step().contacts.size() == 1);
}

TEST_CASE("memory stays within 300 bytes a body and 200 a pair") {
  Row row(20'000);
  row.step();
  std::vector<scene::Move> moves;
  for (std::size_t i = 0; i < row.bodies.size(); ++i) {
    moves.push_back({row.bodies[i], upright(0.99F * static_cast<float>(i), 0.001F)});
  }
  row.step(moves);
  CHECK(row.scene.memory().bodies <= 300 * row.scene.body_count());
  CHECK(row.scene.memory().pairs <= 200 * row.scene.pair_count());
}

namespace {

/// A row's contacts after a step without moves.
std::size_t contacts_left(Row& row) {
  return row.step().contacts.size();
}

}  // namespace

TEST_CASE("a refused move leaves the scene as it was, the moves before it too") {
  Row row(3);
  row.step();
  const auto refused = [&](const Pose<float>& pose) {
    const std::vector<scene::Move> moves{{row.bodies[0], upright(50, 50)}, {row.bodies[2], pose}};
    const auto result = std::get<scene::RefusedMove>(row.scene.step(moves));
    CHECK(result.index == 1);
    CHECK(row.scene.pose(row.bodies[0]) == upright(0, 0));
    CHECK(contacts_left(row) == 2);
    return result.defect;
  };
  CHECK(refused(upright(kInfinity, 0)) == Defect::position_not_finite);
  CHECK(refused(upright(0, std::nanf(""))) == Defect::position_not_finite);
  CHECK(refused(upright(2e15F, 0)) == Defect::position_too_far);
  CHECK(refused({{0, 0}, {1, 0.01F}}) == Defect::rotation_not_unit);
  CHECK(refused({{0, 0}, {std::nanf(""), 0}}) == Defect::rotation_not_unit);
}

TEST_CASE("what ended waits for a step that is not refused") {
  Row row(2);
  row.step();
  row.scene.remove(row.bodies[0]);
  const std::vector<scene::Move> stale{{row.bodies[0], upright(0, 0)}};
  CHECK(std::get<scene::RefusedMove>(row.scene.step(stale)).defect == Defect::unknown_body);
  CHECK(row.step().ended.size() == 1);
}

TEST_CASE("unknown bodies and shapes are refused") {
  Row row(2);
  row.step();
  CHECK(row.scene.remove(row.bodies[0]) == std::nullopt);
  CHECK(row.scene.remove(row.bodies[0]) == Defect::unknown_body);
  CHECK(row.scene.remove({7, 1}) == Defect::unknown_body);
  CHECK(row.scene.remove({}) == Defect::unknown_body);
  CHECK(row.scene.set_shape(row.bodies[0], row.shape) == Defect::unknown_body);
  CHECK(row.scene.set_shape(row.bodies[1], row.shape + 1) == Defect::unknown_shape);
  CHECK(std::get<Defect>(row.scene.add(row.shape + 1, upright(0, 0))) == Defect::unknown_shape);
  CHECK(std::get<Defect>(row.scene.add(row.shape, upright(kInfinity, 0))) ==
        Defect::position_not_finite);
  CHECK(row.scene.body_count() == 1);
}

TEST_CASE("settings that are no lengths are found") {
  const float nan = std::nanf("");
  CHECK(find_defect(scene::Settings{}) == std::nullopt);
  CHECK(find_defect(scene::Settings{.tie_bias = 0.5F, .recycled_motion = 1e15F}) == std::nullopt);
  for (const float unfit : {nan, -1.0F, kInfinity, 2e15F}) {
    CHECK(find_defect(scene::Settings{.tie_bias = unfit}) == Defect::setting_not_a_length);
    CHECK(find_defect(scene::Settings{.recycled_motion = unfit}) == Defect::setting_not_a_length);
  }
}

TEST_CASE("every defect is described") {
  for (int i = 0; i <= static_cast<int>(Defect::unknown_body); ++i) {
    CHECK_FALSE(describe(static_cast<Defect>(i)).empty());
  }
}
