#include "scene/threads.hpp"

#include <atomic>
#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "unit/scene/backwards.hpp"
#include "unit/scene/commands.hpp"
#include "unit/scene/model.hpp"
#include "unit/scene/motion.hpp"
#include "unit/scene/own_scene.hpp"

// What an executor runs: each task once, and the same step as without one.

using namespace manifuzz;
using scene::BodyHandle;
using scene::Scene;

namespace {

struct Divided : test::OwnScene {
  static scene::Executor executor() {
    static scene::Threads threads(3);
    return std::ref(threads);
  }
};

/// How many parts the bodies of a scene have.
enum class Built { of_one_part, of_one_and_of_two };

/// Many bodies of all shapes that drift, a share of them fast enough to leave their boxes, all of
/// them in one step or few.
class Drift {
 public:
  explicit Drift(int bodies = 900, const scene::Settings& settings = {},
                 Built built = Built::of_one_part)
      : scene(settings), random_(test::motion(5)) {
    const auto width = static_cast<float>(8 * std::sqrt(bodies / 900.0));
    for (const auto& shape : test::shapes_for_scenes()) scene.add_shape(shape);
    for (int i = 0; i < bodies; ++i) {
      Pose<float> pose = test::anywhere(random_.bits());
      pose.position *= width;
      bodies_.push_back(add(pose, built == Built::of_one_and_of_two && i % 3 == 1));
    }
  }

  scene::StepResult step(int number, const scene::Executor& executor) {
    std::vector<scene::Move> moves;
    for (const BodyHandle body : bodies_) {
      Pose<float> pose = scene.pose(body);
      const bool rests = random_.chance(number % 5 == 4 ? 0.99 : 0.3);
      const float by = rests ? 0.0F : number % 2 == 0 ? 0.2F : 0.02F;
      pose.position += by * random_direction(random_).cast<float>();
      moves.push_back({body, pose});
    }
    const auto stepped = scene.step(moves, executor);
    return std::get<scene::StepResult>(stepped);
  }

  Scene scene;

 private:
  BodyHandle add(const Pose<float>& pose, bool is_of_two) {
    if (!is_of_two) return std::get<BodyHandle>(scene.add(any_shape(), pose));
    const scene::BodyPart parts[] = {{any_shape(), {{0.5F, 0}, {1, 0}}},
                                     {any_shape(), {{-0.5F, 0.25F}, {0.6F, 0.8F}}}};
    return std::get<BodyHandle>(scene.add(parts, pose));
  }

  std::uint32_t any_shape() {
    const int last = static_cast<int>(test::shapes_for_scenes().size()) - 1;
    return static_cast<std::uint32_t>(random_.integer(0, last));
  }

  Random random_;
  std::vector<BodyHandle> bodies_;
};

template <class T>
bool same(std::span<const T> p, std::span<const T> q) {
  return p.size() == q.size() &&
         (p.empty() || std::memcmp(p.data(), q.data(), p.size_bytes()) == 0);
}

bool same_contacts(std::span<const scene::Contact> p, std::span<const scene::Contact> q) {
  const auto are_same = [](const scene::Contact& c, const scene::Contact& d) {
    return c.a == d.a && c.b == d.b && same_bits(c.manifold, d.manifold);
  };
  return std::ranges::equal(p, q, are_same);
}

}  // namespace

TEST_CASE("each task is run once, by any number of threads, call after call") {
  for (const std::size_t count : {1, 2, 5}) {
    for (const scene::Idle idle : {scene::Idle::sleep, scene::Idle::spin}) {
      scene::Threads threads(count, idle);
      for (std::size_t tasks = 0; tasks < 40; ++tasks) {
        std::vector<std::atomic<int>> runs(tasks);
        threads(tasks, [&](std::size_t task) { ++runs[task]; });
        CHECK(std::ranges::all_of(runs, [](const auto& n) { return n == 1; }));
      }
    }
  }
}

namespace {

/// Whether the later of a body's two moves holds, and all other moves, where body `twice` moves
/// twice. Bodies have one part or two.
bool later_move_holds(std::uint32_t twice, std::size_t part_count) {
  Scene scene;
  const std::vector<Vector2<float>> centre{{0, 0}};
  const auto dot = std::get<std::uint32_t>(
      scene.add_shape(make_polygon<float>(centre, 0.125F, Rounding::round)));
  const scene::BodyPart parts[] = {{dot, {{0, 0}, {1, 0}}}, {dot, {{3, 0}, {1, 0}}}};
  std::vector<scene::Move> moves;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const auto x = static_cast<float>(10 * i);
    const Pose<float> pose{{x, 0}, {1, 0}};
    const auto added = part_count == 1 ? scene.add(dot, pose) : scene.add(parts, pose);
    const auto body = std::get<BodyHandle>(added);
    if (i == twice) moves.push_back({body, {{x, 2}, {1, 0}}});
    moves.push_back({body, {{x, 1}, {1, 0}}});
  }
  if (!std::holds_alternative<scene::StepResult>(scene.step(moves, test::backwards))) return false;
  std::vector<BodyHandle> at_later;
  std::vector<BodyHandle> at_earlier;
  scene.near({-1, 0.9F, 2010, 1.1F}, at_later);
  scene.near({-1, 1.9F, 2010, 2.1F}, at_earlier);
  return scene.pose(moves[twice].body).position.y() == 1 && at_later.size() == 200 * part_count &&
         at_earlier.empty();
}

}  // namespace

TEST_CASE("the later of a body's two moves holds, whichever share of the moves ends between both") {
  for (const std::size_t part_count : {1, 2}) {
    int wrong = 0;
    for (std::uint32_t twice = 0; twice < 200; ++twice) {
      wrong += !later_move_holds(twice, part_count);
    }
    CHECK(wrong == 0);
  }
}

namespace {

/// Steps of both kinds follow each other.
void check_divided(Drift& alone, Drift& divided, const scene::Executor& executor, int steps) {
  for (int number = 0; number < steps; ++number) {
    CAPTURE(number);
    const auto right = alone.step(number, {});
    const bool is_divided = number % 7 != 3;
    const auto result = divided.step(number, is_divided ? executor : scene::Executor());
    REQUIRE(same_contacts(result.contacts, right.contacts));
    CHECK(same(result.began, right.began));
    CHECK(same(result.ended, right.ended));
    CHECK(same(result.renumbered, right.renumbered));
    CHECK(result.stayed == right.stayed);
    CHECK(std::memcmp(&result.counts, &right.counts, sizeof(result.counts)) == 0);
    CHECK(divided.scene.pair_count() == alone.scene.pair_count());
  }
  CHECK(alone.scene.pair_count() > 900);
}

}  // namespace

TEST_CASE("a step has the same contacts, order and counts by any number of threads, or none") {
  for (const std::size_t count : {1, 2, 3}) {
    CAPTURE(count);
    scene::Threads threads(count);
    Drift alone;
    Drift divided;
    check_divided(alone, divided, std::ref(threads), 25);
  }
}

TEST_CASE("bodies of several parts have the same contacts, order and counts by threads") {
  scene::Threads threads(2);
  Drift alone(900, {}, Built::of_one_and_of_two);
  Drift divided(900, {}, Built::of_one_and_of_two);
  check_divided(alone, divided, std::ref(threads), 25);
}

TEST_CASE("a step of few movers among many, and one that recycles, is the same by threads") {
  scene::Threads threads(2);
  for (const float motion : {0.0F, 0.05F}) {
    CAPTURE(motion);
    Drift alone(8000, {.recycled_motion = motion});
    Drift divided(8000, {.recycled_motion = motion});
    check_divided(alone, divided, std::ref(threads), 10);
  }
}

TEST_CASE(
    "a floor under more bodies than wait in a task has the same contacts and counts by threads") {
  scene::Threads threads(2);
  Scene alone;
  Scene divided;
  std::vector<BodyHandle> bodies;
  constexpr int kCount = 5500;
  constexpr int kFloor = 500;
  for (Scene* const scene : {&alone, &divided}) {
    bodies.clear();
    const auto add_shape = [&](const std::vector<Vector2<float>>& vertices, float radius) {
      return std::get<std::uint32_t>(scene->add_shape(make_polygon<float>(vertices, radius)));
    };
    const auto ball = add_shape({{0, 0}}, 0.4F);
    const auto floor = add_shape({{-10, -1}, {6000, -1}, {6000, 0}, {-10, 0}}, 0);
    for (int i = 0; i < kCount; ++i) {
      const float height = i < kFloor ? 100 : 0.39F + 0.0001F * static_cast<float>(i % 400);
      const Pose<float> pose{{static_cast<float>(i), height}, {1, 0}};
      const bool is_floor = i == kFloor;
      const auto added = scene->add(is_floor ? floor : ball, is_floor ? Pose<float>{} : pose);
      bodies.push_back(std::get<BodyHandle>(added));
    }
    const auto executor = scene == &divided ? std::ref(threads) : scene::Executor();
    REQUIRE(std::holds_alternative<scene::StepResult>(scene->step({}, executor)));
  }
  for (int number = 0; number < 12; ++number) {
    CAPTURE(number);
    std::vector<scene::Move> moves;
    for (const BodyHandle body : bodies) {
      Pose<float> pose = alone.pose(body);
      pose.position.x() += number % 2 == 0 ? 0.0003F : -0.0002F;
      moves.push_back({body, pose});
    }
    const auto right = std::get<scene::StepResult>(alone.step(moves));
    const auto result = std::get<scene::StepResult>(divided.step(moves, std::ref(threads)));
    REQUIRE(same_contacts(result.contacts, right.contacts));
    CHECK(std::memcmp(&result.counts, &right.counts, sizeof(result.counts)) == 0);
    CHECK(right.counts.pairs.separated + right.counts.pairs.collided > 2500);
  }
}

TEST_CASE("a scene by threads equals its pairs afresh bit for bit, whatever happens to it") {
  CHECK(rc::check("commands between steps",
                  [] { test::check_commands(test::Adapted<Divided>::make); }));
}
