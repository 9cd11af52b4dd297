#include "scene/recycled.hpp"

#include <catch2/catch.hpp>

#include "clipping/collide.hpp"
#include "generating/drafts.hpp"
#include "scene/scene.hpp"

using namespace manifuzz;
using scene::BodyHandle;
using scene::StepResult;

namespace {

ConvexPolygon<float> box_polygon(float half_width, float half_height) {
  const std::array<Vector2<float>, 4> corners{{{-half_width, -half_height},
                                               {half_width, -half_height},
                                               {half_width, half_height},
                                               {-half_width, half_height}}};
  return make_polygon<float>(corners);
}

Pose<float> at(float x, float y, float t = 0) {
  const float n = 1 + t * t;
  return {{x, y}, {(1 - t * t) / n, 2 * t / n}};
}

const ConvexPolygon<float> kWide = box_polygon(2, 0.5F);
const ConvexPolygon<float> kSmall = box_polygon(0.5F, 0.5F);

void check_near(const Manifold<float>& found, const Manifold<float>& right) {
  REQUIRE(found.count == right.count);
  CHECK(found.reference == right.reference);
  CHECK((found.normal - right.normal).norm() < 1e-6F);
  for (int i = 0; i < found.count; ++i) {
    CAPTURE(i);
    CHECK((found.points[i].position - right.points[i].position).norm() < 1e-6F);
    CHECK(found.points[i].depth == Approx(right.points[i].depth).margin(1e-6));
    CHECK(found.points[i].features == right.points[i].features);
  }
}

/// A wide box that rests, with a small one on it, whose contacts are recycled up to `motion`.
struct Stack {
  scene::Scene scene;
  BodyHandle small;

  explicit Stack(float motion) : scene({.recycled_motion = motion}) {
    const auto wide_shape = std::get<std::uint32_t>(scene.add_shape(kWide));
    const auto small_shape = std::get<std::uint32_t>(scene.add_shape(kSmall));
    scene.add(wide_shape, at(0, 0));
    small = std::get<BodyHandle>(scene.add(small_shape, at(0, 0.99F)));
    scene.step({});
  }

  StepResult step(const Pose<float>& pose) {
    return std::get<StepResult>(scene.step({{{small, pose}}}));
  }
};

}  // namespace

TEST_CASE("a recycled manifold is the collided one where the incident edge keeps its clip") {
  const Pose<float> before = at(0.1F, 0.99F, 0.001F);
  const Pose<float> after = at(0.13F, 0.985F, 0.0015F);
  SECTION("of a reference face of A") {
    const auto collided = clipping::collide(kWide, kSmall, before);
    REQUIRE(collided.reference == Side::a);
    check_near(scene::recycled(collided, before, after), clipping::collide(kWide, kSmall, after));
  }
  SECTION("of a reference face of B") {
    const auto swapped = [](const Pose<float>& pose) { return relative_pose(pose, Pose<float>{}); };
    const auto collided = clipping::collide(kSmall, kWide, swapped(before), -0.01F);
    REQUIRE(collided.reference == Side::b);
    check_near(scene::recycled(collided, swapped(before), swapped(after)),
               clipping::collide(kSmall, kWide, swapped(after), -0.01F));
  }
}

TEST_CASE("contacts are recycled until a vertex has moved by the threshold, then collided") {
  Stack stack(0.01F);
  const StepResult near = stack.step(at(0.005F, 0.99F));
  CHECK(near.counts.pairs.recycled == 1);
  CHECK(near.counts.pairs.collided == 0);
  CHECK(near.stayed == 1);
  const StepResult far = stack.step(at(0.011F, 0.99F));
  CHECK(far.counts.pairs.recycled == 0);
  CHECK(far.counts.pairs.collided == 1);
  const auto right = clipping::collide(kWide, kSmall, at(0.011F, 0.99F));
  CHECK(far.contacts[0].manifold == right);
}

TEST_CASE("recycling does not accumulate: small steps end where one step does") {
  Stack stack(0.01F);
  Stack at_once(0.01F);
  for (int i = 1; i < 8; ++i) stack.step(at(0.001F * static_cast<float>(i), 0.99F));
  const auto slowly = stack.step(at(0.009F, 0.99F));
  const auto quickly = at_once.step(at(0.009F, 0.99F));
  CHECK(slowly.counts.pairs.recycled == 1);
  CHECK(slowly.contacts[0].manifold == quickly.contacts[0].manifold);
}

TEST_CASE("a body that turns on the spot is collided once its vertices have moved") {
  Stack stack(0.01F);
  CHECK(stack.step(at(0, 0.99F, 0.002F)).counts.pairs.recycled == 1);
  CHECK(stack.step(at(0, 0.99F, 0.02F)).counts.pairs.collided == 1);
}

TEST_CASE("another shape's contacts are not recycled") {
  Stack stack(0.01F);
  const auto shape = std::get<std::uint32_t>(stack.scene.add_shape(box_polygon(0.4F, 0.5F)));
  stack.scene.set_shape(stack.small, shape);
  CHECK(stack.step(at(0.001F, 0.99F)).counts.pairs.collided == 1);
}

TEST_CASE("contacts that are kept for recycling stay with their pairs as others end") {
  scene::Scene scene({.recycled_motion = 0.01F});
  const auto shape = std::get<std::uint32_t>(scene.add_shape(kSmall));
  std::vector<BodyHandle> bodies;
  for (int i = 0; i < 6; ++i) {
    const int stack = i / 2;
    const float x = 3 * static_cast<float>(stack);
    bodies.push_back(
        std::get<BodyHandle>(scene.add(shape, at(x, i % 2 == 0 ? 0 : 0.9F + 0.01F * x))));
  }
  scene.step({});
  scene.remove(bodies[0]);
  const std::vector<scene::Move> moves{{bodies[3], at(3, 0.932F)}, {bodies[5], at(6, 0.961F)}};
  const auto result = std::get<StepResult>(scene.step(moves));
  CHECK(result.counts.pairs.recycled == 2);
  REQUIRE(result.contacts.size() == 2);
  for (const scene::Contact& contact : result.contacts) {
    const Pose<float> b_in_a = relative_pose(scene.pose(contact.a), scene.pose(contact.b));
    check_near(contact.manifold, clipping::collide(kSmall, kSmall, b_in_a));
  }
}

TEST_CASE("a pair of which no body left its box is looked at where none has left since the start") {
  scene::Scene scene({.recycled_motion = 0.01F});
  const auto ball = std::get<std::uint32_t>(
      scene.add_shape(make_polygon<float>(std::vector<Vector2<float>>{{0, 0}}, 0.5F)));
  std::vector<BodyHandle> bodies;
  for (int i = 0; i < 40; ++i) {
    bodies.push_back(std::get<BodyHandle>(scene.add(ball, at(10 * static_cast<float>(i), 0))));
  }
  scene.step({});
  const std::vector<scene::Move> one{{bodies[0], at(9.5F, 0)}};
  CHECK(std::get<StepResult>(scene.step(one)).contacts.size() == 1);
  std::vector<scene::Move> three;
  for (const int i : {5, 6, 7}) {
    three.push_back({bodies[static_cast<std::size_t>(i)], at(10 * static_cast<float>(i), 1e-6F)});
  }
  CHECK(std::get<StepResult>(scene.step(three)).contacts.size() == 1);
}
