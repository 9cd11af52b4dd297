#include "report/departure/departure.hpp"

#include <algorithm>
#include <iostream>
#include <map>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "canary/search.hpp"
#include "generating/regime.hpp"

// What is said of how a planted bug's wrong answers came about: the step that has the bug.

namespace manifuzz::canary {
namespace {

constexpr std::uint64_t kCases = 3000;
constexpr const char* kNoStep = "no step";

/// How often a bug's wrong answers are said to depart at each step, the only or the first one.
struct StepCounts {
  std::map<std::string, int> of_step;
  std::map<std::string, std::string> example;
  int answers = 0;

  /// The step that is named most often.
  std::string most() const {
    const auto found = std::ranges::max_element(
        of_step, {}, [](const auto& step_and_count) { return step_and_count.second; });
    return found == of_step.end() ? "" : found->first;
  }
};

StepCounts steps_of(const PlantedBug& bug, std::uint64_t cases) {
  const Collider collider = bug.collider();
  StepCounts counts;
  for (const char* const regime : {"generic", "boxes"}) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      const PairCase pair = generate(1, *find_regime(regime), index);
      const Answer answer = collider.collide(pair);
      const auto departures = departures_of(pair, {collider.declaration, answer});
      if (!departures) continue;
      ++counts.answers;
      const std::string step(departures->found.empty() ? kNoStep : departures->found.front().step);
      ++counts.of_step[step];
      counts.example.try_emplace(step, departures_in_words(*departures));
    }
  }
  return counts;
}

bool is_of_polygons(const PlantedBug& bug) {
  return bug.collider && !is_unedited(bug) && !bug.in_kernel;
}

const PlantedBug& planted_bug(const std::string& name) {
  const auto bug = std::ranges::find(planted_bugs(), name, &PlantedBug::name);
  REQUIRE(bug != planted_bugs().end());
  return *bug;
}

/// A bug and the step that has it.
struct BugOfStep {
  const char* bug;
  const char* step;
};

constexpr BugOfStep kBugsOfSteps[] = {
    {"least_face", "the separation"},
    {"last_vertex_skipped", "the separation"},
    {"stops_at_zero", "the separation"},
    {"reference_flipped", "the reference edge"},
    {"relative_bias", "the reference edge"},
    {"normal_not_turned", "the reference edge"},
    {"incident_after", "the incident edge"},
    {"polygons_swapped", "the incident edge"},
    {"first_plane_not_widened", "clip 1"},
    {"clip_needs_both_outside", "clip 1"},
    {"second_clip_dropped", "clip 2"},
    {"last_clip_dropped", "clip 3 (behind the reference edge)"},
    {"depth_without_radius", "the depth"},
    {"share_of_sum", kNoStep},
    {"bodies_swapped", kNoStep},
    {"stale_feature", kNoStep},
};

}  // namespace

TEST_CASE("a planted bug's wrong answers depart at the step that has the bug") {
  for (const auto& [name, step] : kBugsOfSteps) {
    const StepCounts counts = steps_of(planted_bug(name), kCases);
    CAPTURE(name, counts.of_step);
    CHECK(counts.most() == step);
  }
}

TEST_CASE("the steps at which planted bugs depart", "[.table]") {
  for (const PlantedBug& bug : planted_bugs()) {
    if (!is_of_polygons(bug)) continue;
    const StepCounts counts = steps_of(bug, kCases);
    std::cout << fmt::format("{:<35} {}\n", bug.name, counts.answers);
    for (const auto& [step, count] : counts.of_step) {
      std::cout << fmt::format("  {:>5} {}: {}\n", count, step, counts.example.at(step));
    }
    std::cout << std::flush;
  }
}

}  // namespace manifuzz::canary
