#include <functional>
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "base/random.hpp"
#include "scene/query.hpp"
#include "scene/scene.hpp"
#include "unit/memory/failing_allocations.hpp"
#include "unit/memory/failing_calls.hpp"
#include "unit/scene/backwards.hpp"

// Each allocation of each call of a scene fails once: what the header states holds, and the call
// made again gives what it would have given.

using namespace manifuzz;
using scene::BodyHandle;
using scene::Scene;
using test::After;
using test::backwards;
using test::check_every_failure;
using test::Command;

namespace {

/// A crowd of every kind of shape, and calls on it, drawn.
class Crowd {
 public:
  explicit Crowd(std::uint64_t seed) : random_(seed, "crowd that runs out of memory", 0) {
    const Vector2<float> corners[] = {{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, 0.5F}};
    const Vector2<float> ends[] = {{-0.5F, 0}, {0.5F, 0}};
    const Vector2<float> centre[] = {{0, 0}};
    scene.add_shape(make_polygon<float>(corners));
    scene.add_shape(make_polygon<float>(ends, 0.25F, Rounding::round));
    scene.add_shape(make_polygon<float>(centre, 0.5F, Rounding::round));
    for (int i = 0; i < 20; ++i)
      bodies_.push_back(std::get<BodyHandle>(scene.add(shape(), pose())));
    scene.step({});
  }

  /// Drawn now, so that it does the same to every copy.
  Command draw() {
    switch (random_.integer(0, 7)) {
      case 0:
        return {"add_shape", After::unchanged,
                [polygon = scene.shape(shape())](Scene& in) { in.add_shape(polygon); }};
      case 1:
        return {"add", After::unchanged,
                [shape = shape(), pose = pose(), rules = rules()](Scene& in) {
                  in.add(shape, pose, rules);
                }};
      case 2:
        return {"add parts", After::unchanged,
                [parts = parts(), pose = pose(), rules = rules()](Scene& in) {
                  in.add(parts, pose, rules);
                }};
      case 3:
        return {"remove", After::unchanged, [body = body()](Scene& in) { in.remove(body); }};
      case 4:
        return {"set_shape", After::unchanged,
                [body = body(), shape = shape()](Scene& in) { in.set_shape(body, shape); }};
      case 5:
        return {
            "set_filter", After::forgotten,
            [body = body(), filter = rules().filter](Scene& in) { in.set_filter(body, filter); }};
      default:
        return {"step", After::forgotten, [moves = moves()](Scene& in) { in.step(moves); }};
    }
  }

  void run(const Command& command) {
    command.run(scene);
    scene.step({});
    bodies_.clear();
    std::vector<BodyHandle> found;
    scene.near({-1e6F, -1e6F, 1e6F, 1e6F}, found);
    for (const BodyHandle handle : found) {
      const scene::PartName name = scene.part(handle);
      if (name.part == 0) bodies_.push_back(name.body);
    }
  }

  Scene scene;

 private:
  std::uint32_t shape() { return static_cast<std::uint32_t>(random_.integer(0, 2)); }
  Pose<float> pose() {
    const auto x = static_cast<float>(random_.uniform(0, 4));
    const auto y = static_cast<float>(random_.uniform(0, 4));
    return {{x, y}, {1, 0}};
  }
  scene::Rules rules() {
    const auto category = std::uint32_t{1} << random_.integer(0, 2);
    return {.filter = {category, random_.chance(0.5) ? ~category : ~std::uint32_t{0}}};
  }
  std::vector<scene::BodyPart> parts() {
    std::vector<scene::BodyPart> some;
    for (int i = random_.integer(1, 3); i > 0; --i) some.push_back({shape(), pose()});
    return some;
  }
  BodyHandle body() {
    return bodies_[static_cast<std::size_t>(
        random_.integer(0, static_cast<int>(bodies_.size()) - 1))];
  }
  std::vector<scene::Move> moves() {
    std::vector<scene::Move> some;
    for (const BodyHandle body : bodies_) {
      if (random_.chance(0.6)) some.push_back({body, pose()});
    }
    return some;
  }

  Random random_;
  std::vector<BodyHandle> bodies_;
};

}  // namespace

TEST_CASE("a scene whose memory runs out anywhere is right again with the next call") {
  std::map<std::string, std::size_t> failures;
  for (const std::uint64_t seed : {1, 2, 3}) {
    Crowd crowd(seed);
    for (int i = 0; i < 40; ++i) {
      const Command command = crowd.draw();
      failures[command.name] += check_every_failure(crowd.scene, command);
      crowd.run(command);
    }
  }
  CHECK(failures.size() == 7);
  for (const auto& [name, count] : failures) {
    INFO(name);
    CHECK(count > 0);
  }
}

TEST_CASE("a scene whose memory runs out in a task is right again with the next step") {
  Crowd crowd(4);
  for (int i = 0; i < 100; ++i) crowd.run({"add", After::unchanged, crowd.draw().run});
  std::vector<BodyHandle> bodies;
  crowd.scene.near({-1e6F, -1e6F, 1e6F, 1e6F}, bodies);
  Random random(1, "far moves", 0);
  std::vector<scene::Move> moves;
  for (const BodyHandle body : bodies) {
    if (crowd.scene.part(body).part > 0 || !(crowd.scene.part(body).body == body)) continue;
    Pose<float> pose = crowd.scene.pose(body);
    pose.position.x() += static_cast<float>(random.uniform(-2, 2));
    moves.push_back({body, pose});
  }
  const Command step{"step in tasks", After::forgotten,
                     [&](Scene& in) { in.step(moves, backwards); }};
  CHECK(check_every_failure(crowd.scene, step) > 8);
}

TEST_CASE("a scene whose memory runs out in a task of its first step is right with the next") {
  Scene scene;
  const Vector2<float> centre[] = {{0, 0}};
  const auto ball = std::get<std::uint32_t>(scene.add_shape(make_polygon<float>(centre, 0.5F)));
  const std::vector<scene::BodyPart> parts{{ball, {{0, 0}, {1, 0}}}, {ball, {{2, 0}, {1, 0}}}};
  for (int i = 0; i < 150; ++i) {
    const Pose<float> pose{{0.75F * static_cast<float>(i % 13), static_cast<float>(i / 13)},
                           {1, 0}};
    if (i % 5 == 0) {
      scene.add(parts, pose);
    } else {
      scene.add(ball, pose);
    }
  }
  const Command step{"first step in tasks", After::forgotten,
                     [](Scene& in) { in.step({}, backwards); }};
  CHECK(check_every_failure(scene, step) > 8);
}

TEST_CASE("a question for which there is no memory changes nothing") {
  Crowd crowd(5);
  const Ray ray{{-1, 1}, {8, 0.5F}};
  const auto expected = scene::cast_ray(crowd.scene, ray);
  REQUIRE(expected);
  std::size_t failures = 0;
  for (std::size_t after = 0;; ++after, ++failures) {
    Scene scene = crowd.scene;
    if (!test::runs_out(after, [&] { scene::cast_ray(scene, ray); })) break;
    const auto found = scene::cast_ray(scene, ray);
    REQUIRE(found);
    CHECK(found->handle == expected->handle);
    CHECK(found->hit.share == expected->hit.share);
  }
  CHECK(failures > 0);
}

TEST_CASE("bodies of parts are whole after memory ran out while many moves were placed") {
  Scene before;
  const Vector2<float> centre[] = {{0, 0}};
  const auto ball = std::get<std::uint32_t>(before.add_shape(make_polygon<float>(centre, 0.4F)));
  const std::vector<scene::BodyPart> parts{
      {ball, {{0, 0}, {1, 0}}}, {ball, {{0, 1}, {1, 0}}}, {ball, {{1, 0}, {0, 1}}}};
  std::vector<scene::Move> moves;
  for (int i = 0; i < 250; ++i) {
    const float x = 4 * static_cast<float>(i);
    const auto body = std::get<BodyHandle>(before.add(parts, {{x, 0}, {1, 0}}));
    moves.push_back({body, {{x + 1, 0}, {0, 1}}});
  }
  REQUIRE(std::holds_alternative<scene::StepResult>(before.step({})));
  std::size_t after = 0;
  for (;; ++after) {
    CAPTURE(after);
    Scene scene = before;
    if (!test::runs_out(after, [&] { scene.step(moves); })) break;
    REQUIRE(std::holds_alternative<scene::StepResult>(scene.step({})));
    std::size_t torn = 0;
    for (const scene::Move& move : moves) {
      for (std::uint32_t k = 0; k < parts.size(); ++k) {
        const Pose<float> part = scene.placement(scene.handle({move.body, k})).pose;
        const Pose<float> whole = scene::composed(scene.pose(move.body), parts[k].pose);
        torn += static_cast<std::size_t>(!same_bits(part, whole));
      }
    }
    CHECK(torn == 0);
  }
  CHECK(after > 3);
}
