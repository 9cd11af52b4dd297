#include "unit/memory/failing_calls.hpp"

#include <algorithm>
#include <tuple>

#include <catch2/catch.hpp>

#include "unit/memory/failing_allocations.hpp"

namespace manifuzz::test {

using scene::Scene;

namespace {

/// Two bodies that touch, and the bits of their manifold.
using Touch = std::tuple<std::uint32_t, std::uint32_t, int, float, float, float, float>;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Touch> sorted(std::span<const scene::Contact> contacts) {
  std::vector<Touch> touches;
  for (const scene::Contact& contact : contacts) {
    const Manifold<float>& m = contact.manifold;
    touches.emplace_back(contact.a.index, contact.b.index, m.count, m.normal.x(), m.normal.y(),
                         m.points[0].depth, m.points[0].position.x());
  }
  std::ranges::sort(touches);
  return touches;
}

std::vector<Pair> began(const scene::StepResult& result) {
  std::vector<Pair> pairs;
  for (const std::uint32_t i : result.began) {
    pairs.emplace_back(result.contacts[i].a.index, result.contacts[i].b.index);
  }
  std::ranges::sort(pairs);
  return pairs;
}

std::vector<Pair> ended(const scene::StepResult& result) {
  std::vector<Pair> pairs;
  for (const scene::EndedContact& contact : result.ended) {
    pairs.emplace_back(contact.a.index, contact.b.index);
  }
  std::ranges::sort(pairs);
  return pairs;
}

/// What holds after a call, and after a step that moves nobody.
struct Outcome {
  std::size_t bodies = 0;
  std::vector<Touch> touches;
  std::vector<Pair> began;
  std::vector<Pair> ended;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcome(Scene& scene) {
  const auto stepped = scene.step({});
  const auto& result = std::get<scene::StepResult>(stepped);
  return {scene.body_count(), sorted(result.contacts), began(result), ended(result)};
}

/// The next step tells of all that touch as begun. Whether the moves were placed depends on where
/// the memory ran out.
void check_forgotten(Scene& scene, const Outcome& untouched, const Outcome& done) {
  const Outcome found = outcome(scene);
  CHECK((found.touches == done.touches || found.touches == untouched.touches));
  CHECK(found.began.size() == found.touches.size());
  CHECK(found.ended.empty());
}

}  // namespace

std::size_t check_every_failure(const Scene& before, const Command& command) {
  Scene right = before;
  command.run(right);
  const std::size_t bodies = right.body_count();
  const Outcome expected = outcome(right);
  Scene untouched = before;
  const Outcome unchanged = outcome(untouched);
  for (std::size_t after = 0;; ++after) {
    INFO(command.name << ", allocation " << after);
    Scene scene = before;
    if (!runs_out(after, [&] { command.run(scene); })) return after;
    Scene left = scene;
    if (command.after == After::forgotten) {
      check_forgotten(left, unchanged, expected);
      command.run(scene);
      CHECK(outcome(scene).touches == expected.touches);
    } else {
      CHECK(scene.body_count() == before.body_count());
      CHECK(outcome(left) == unchanged);
      command.run(scene);
      CHECK(scene.body_count() == bodies);
      CHECK(outcome(scene) == expected);
    }
  }
}

}  // namespace manifuzz::test
