#include "scene/query.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "unit/scene/model.hpp"
#include "unit/scene/motion.hpp"

using namespace manifuzz;
using scene::BodyHandle;
using scene::Scene;

namespace {

/// A crowd that has moved for some steps, so that boxes are not where they were drawn.
class Moved {
 public:
  explicit Moved(std::uint64_t seed) : random_(test::motion(seed)) {
    for (const auto& shape : test::shapes_for_scenes()) scene.add_shape(shape);
    const int last = static_cast<int>(test::shapes_for_scenes().size()) - 1;
    for (int i = 0; i < 60; ++i) {
      const auto shape = static_cast<std::uint32_t>(random_.integer(0, last));
      const scene::Rules rules{{i % 3 == 0 ? 2U : 1U}, i % 2 == 0, i % 7 == 0};
      bodies.push_back(std::get<BodyHandle>(scene.add(shape, place(), rules)));
    }
    for (int step = 0; step < 5; ++step) {
      std::vector<scene::Move> moves;
      for (const BodyHandle body : bodies) {
        Pose<float> pose = scene.pose(body);
        pose.position += 0.02F * random_direction(random_).cast<float>();
        moves.push_back({body, pose});
      }
      CHECK(std::holds_alternative<scene::StepResult>(scene.step(moves)));
    }
  }

  Ray ray() {
    const auto at = [&] { return Vector2<float>(3 * test::anywhere(random_.bits()).position); };
    return {at(), at()};
  }

  Scene scene;
  std::vector<BodyHandle> bodies;

 private:
  Pose<float> place() {
    Pose<float> pose = test::anywhere(random_.bits());
    pose.position *= 3;
    return pose;
  }

  Random random_;
};

}  // namespace

TEST_CASE("a ray through a scene meets what it meets first of all shapes") {
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Moved moved(seed);
    for (int i = 0; i < 50; ++i) {
      CAPTURE(i);
      const Ray ray = moved.ray();
      const scene::Filter filter{1, i % 2 == 0 ? 1U : 3U};
      std::optional<scene::SceneHit> first;
      for (const BodyHandle body : moved.bodies) {
        const scene::Rules rules = moved.scene.rules(body);
        if (rules.is_sensor || !may_touch(filter, rules.filter)) continue;
        const auto [shape, pose] = moved.scene.placement(body);
        const auto hit = cast_ray(moved.scene.shape(shape), pose, ray);
        if (hit && (!first || hit->share < first->hit.share)) first = {body, *hit};
      }
      const auto found = scene::cast_ray(moved.scene, ray, filter);
      REQUIRE(found.has_value() == first.has_value());
      if (!found) continue;
      ++hits;
      CHECK(found->handle == first->handle);
      CHECK(found->hit.share == first->hit.share);
    }
  }
  CHECK(hits > 200);
}

TEST_CASE("a box finds all bodies that reach into it, and none that is far") {
  Moved moved(3);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const Vector2<float> at = moved.ray().from;
    const scene::Box box{at.x(), at.y(), at.x() + 0.5F, at.y() + 0.5F};
    std::vector<BodyHandle> right;
    for (const BodyHandle body : moved.bodies) {
      const auto [shape, pose] = moved.scene.placement(body);
      const ConvexPolygon<float>& polygon = moved.scene.shape(shape);
      scene::Box tight = scene::kNowhere;
      for (const auto& vertex : polygon.corners()) {
        const Vector2<float> v = transform(pose, vertex);
        tight = {std::min(tight.x_min, v.x() - polygon.radius),
                 std::min(tight.y_min, v.y() - polygon.radius),
                 std::max(tight.x_max, v.x() + polygon.radius),
                 std::max(tight.y_max, v.y() + polygon.radius)};
      }
      if (overlap(tight, box)) right.push_back(body);
    }
    std::vector<BodyHandle> found;
    moved.scene.near(box, found);
    CHECK(std::ranges::is_sorted(found, {}, &BodyHandle::index));
    for (const BodyHandle body : right) CHECK(std::ranges::find(found, body) != found.end());
    // A padded box is larger by a thousandth, and by less than half the radius of sharp shapes.
    CHECK(found.size() <= right.size() + 2);
  }
}

TEST_CASE("boxes and rays without bounds, or that are none, find what there is, or nothing") {
  Moved moved(1);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float none = std::nanf("");
  std::vector<BodyHandle> found;
  moved.scene.near({-infinity, -infinity, infinity, infinity}, found);
  CHECK(found.size() == moved.bodies.size());
  moved.scene.near({none, none, none, none}, found);
  CHECK(found.empty());
  moved.scene.near({infinity, infinity, -infinity, -infinity}, found);
  CHECK(found.empty());
  CHECK(scene::cast_ray(moved.scene, {{-2e38F, 0}, {3e38F, 0}}));
  Scene empty;
  empty.near({-1, -1, 1, 1}, found);
  CHECK(found.empty());
  CHECK_FALSE(scene::cast_ray(empty, {{0, 0}, {1, 0}}));
}

TEST_CASE("a removed body's contact has its name, though rules came only after it") {
  Scene scene;
  const Vector2<float> centre[] = {{0, 0}};
  const auto disc = std::get<std::uint32_t>(scene.add_shape(make_polygon<float>(centre, 1)));
  const auto first = std::get<BodyHandle>(scene.add(disc, {{0, 0}, {1, 0}}));
  REQUIRE(std::holds_alternative<BodyHandle>(scene.add(disc, {{1, 0}, {1, 0}})));
  REQUIRE(std::holds_alternative<scene::StepResult>(scene.step({})));
  CHECK(scene.remove(first) == std::nullopt);
  REQUIRE(
      std::holds_alternative<BodyHandle>(scene.add(disc, {{9, 0}, {1, 0}}, {.is_sensor = true})));
  const auto stepped = scene.step({});
  const auto& ended = std::get<scene::StepResult>(stepped).ended;
  REQUIRE(ended.size() == 1);
  CHECK(scene.part(ended[0].a) == scene::PartName{first, 0});
}

TEST_CASE("parts of a body are known by their numbers, and its contacts name them") {
  Scene scene;
  const auto disc = std::get<std::uint32_t>(
      scene.add_shape(make_polygon<float>(std::vector<Vector2<float>>{{0, 0}}, 1)));
  const std::vector<scene::BodyPart> parts{{disc, {{-2, 0}, {1, 0}}}, {disc, {{2, 0}, {1, 0}}}};
  const auto dumbbell = std::get<BodyHandle>(scene.add(parts, {{0, 0}, {0, 1}}));
  const auto ball = std::get<BodyHandle>(scene.add(disc, {{0, 3.5F}, {1, 0}}));
  const auto stepped = scene.step({});
  const auto& result = std::get<scene::StepResult>(stepped);
  REQUIRE(result.contacts.size() == 1);
  CHECK(scene.part(result.contacts[0].a) == scene::PartName{dumbbell, 1});
  CHECK(scene.part(result.contacts[0].b) == scene::PartName{ball, 0});
  CHECK(scene.handle(scene::PartName{dumbbell, 1}) == result.contacts[0].a);
  CHECK(scene.pose(dumbbell).position.y() == 0);

  CHECK(scene.remove(result.contacts[0].a) == scene::Defect::unknown_body);  // a part is no body
  const std::vector<scene::Move> part_moves{{result.contacts[0].a, {}}};
  CHECK(std::get<scene::RefusedMove>(scene.step(part_moves)).defect == scene::Defect::unknown_body);
  CHECK(scene.set_shape(dumbbell, disc, 2) == scene::Defect::unknown_part);
  CHECK(std::get<scene::Defect>(scene.add(std::vector<scene::BodyPart>{}, {})) ==
        scene::Defect::no_parts);

  CHECK(scene.remove(dumbbell) == std::nullopt);
  const auto after = scene.step({});
  const auto& ended = std::get<scene::StepResult>(after).ended;
  REQUIRE(ended.size() == 1);
  CHECK(scene.part(ended[0].a) == scene::PartName{dumbbell, 1});
}
