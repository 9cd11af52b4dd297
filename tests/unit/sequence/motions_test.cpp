#include "sequence/motions.hpp"

#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "exact/curve.hpp"
#include "unit/generating/case_hash.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kSequences = 200;

/// Overlaps by more than that, or less, as a share of the size.
double depth_share(const PairCase& pair) {
  const exact::Truth truth(pair);
  return exact::PenetrationCurve(truth, exact::skin_of(truth)).least() / truth.size();
}

/// The share of the motion's frames of which this holds.
double share_of_frames(std::string_view motion, const std::function<bool(const PairCase&)>& holds) {
  double count = 0;
  double holding = 0;
  for (std::uint64_t i = 0; i < kSequences; ++i) {
    const Sequence sequence = draw_sequence(7, *find_motion(motion), i);
    for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
      ++count;
      if (holds(sequence.at(k))) ++holding;
    }
  }
  return holding / count;
}

/// The share of steps from one frame to the next of which it holds.
double share_of_steps(std::string_view motion,
                      const std::function<bool(const PairCase&, const PairCase&)>& holds) {
  double count = 0;
  double holding = 0;
  for (std::uint64_t i = 0; i < kSequences; ++i) {
    const Sequence sequence = draw_sequence(7, *find_motion(motion), i);
    for (std::size_t k = 1; k < sequence.frames.size(); ++k) {
      ++count;
      if (holds(sequence.at(k - 1), sequence.at(k))) ++holding;
    }
  }
  return holding / count;
}

bool touches_clearly(const PairCase& pair) {
  return depth_share(pair) > 0;
}

/// Where B's origin is, as A sees it.
Vector2<double> seen(const PairCase& pair) {
  return to_local(pair.a.pose, pair.b.pose.position.cast<double>());
}

/// How far B went as A sees it, as a share of the size.
double went(const PairCase& before, const PairCase& after) {
  return (seen(after) - seen(before)).norm() / size(after);
}

/// The sine of how far A turned in the world.
double a_turned(const PairCase& before, const PairCase& after) {
  return std::abs(
      cross<double>(before.a.pose.rotation.cast<double>(), after.a.pose.rotation.cast<double>()));
}

}  // namespace

TEST_CASE("the first sequences of every motion are those they always were") {
  // To change a motion on purpose, paste the hash that the failure prints. A hash that changes with
  // the compiler or the machine is a bug.
  const std::map<std::string, std::string> golden = {
      {"resting", "020794f6f02c2f5e"},          {"rocking", "8ff0a4ab3927508f"},
      {"sliding", "769987b2fcec4cfe"},          {"rolling", "1b682506d10c2a9f"},
      {"turning_platform", "65b991e54529572a"}, {"apart_and_back", "f0b9cad6e8fc1661"},
      {"teleport", "765d56dafd494ed6"},         {"tiny_bodies", "18be32e3b794c4b0"},
  };
  for (const Motion& motion : motions()) {
    CaseHash hash;
    for (std::uint64_t i = 0; i < 64; ++i) {
      const Sequence sequence = draw_sequence(42, motion, i);
      for (std::size_t k = 0; k < sequence.frames.size(); ++k) hash.add(sequence.at(k));
    }
    const std::string name(motion.name);
    const auto expected = golden.find(name);
    INFO("motion " << name);
    CHECK(hash.hex() == (expected == golden.end() ? "" : expected->second));
  }
}

TEST_CASE("every sequence has valid shapes, unit rotations, and 4 to 40 frames") {
  for (const Motion& motion : motions()) {
    int round = 0;
    for (std::uint64_t i = 0; i < kSequences; ++i) {
      const Sequence sequence = draw_sequence(7, motion, i);
      INFO(motion.name << ' ' << i);
      REQUIRE(sequence.frames.size() >= kMinFrames);
      REQUIRE(sequence.frames.size() <= kMaxFrames);
      for (const auto* const shape : {&sequence.a, &sequence.b}) {
        REQUIRE_FALSE(find_shape_defect(shape->corners(), shape->radius));
      }
      for (const FramePoses& poses : sequence.frames) {
        for (const Pose<float>& pose : {poses.a, poses.b}) {
          REQUIRE(pose.position.allFinite());
          REQUIRE(is_unit_rotation(pose.rotation));
        }
      }
      if (is_round(sequence.at(0))) ++round;
    }
    INFO(motion.name);
    CHECK(round >= static_cast<int>(kSequences) / 4);
    CHECK(round < static_cast<int>(kSequences));
  }
}

TEST_CASE("a sequence depends on the seed, the motion's name and the index alone") {
  const Motion& motion = *find_motion("resting");
  CHECK(draw_sequence(1, motion, 5) == draw_sequence(1, motion, 5));
  CHECK_FALSE(draw_sequence(1, motion, 5) == draw_sequence(1, motion, 6));
  CHECK_FALSE(draw_sequence(1, motion, 5) == draw_sequence(2, motion, 5));
  CHECK(find_motion("none of them") == nullptr);
}

TEST_CASE("sequences are drawn of shapes that are taken, else the first of all") {
  const TakesSequence of_polygons = [](const Sequence& sequence) {
    return !is_round(sequence.at(0));
  };
  int others = 0;
  for (const Motion& motion : motions()) {
    for (std::uint64_t i = 0; i < kSequences; ++i) {
      const Sequence any = draw_sequence(7, motion, i);
      const Sequence taken = draw_sequence(7, motion, i, of_polygons);
      REQUIRE(of_polygons(taken));
      REQUIRE(taken == draw_sequence(7, motion, i, of_polygons));
      if (of_polygons(any)) REQUIRE(taken == any);
      others += of_polygons(any) ? 0 : 1;
    }
    CHECK(has_taken(motion, of_polygons));
    CHECK_FALSE(has_taken(motion, [](const Sequence&) { return false; }));
    CHECK(draw_sequence(7, motion, 3, [](const Sequence&) { return false; }) ==
          draw_sequence(7, motion, 3));
  }
  CHECK(others > 0);
}

TEST_CASE("most frames of motions touch, and those of teleport now and then") {
  const std::map<std::string, double> least = {
      {"resting", 0.5},  {"rocking", 0.5},          {"sliding", 0.4},        {"rolling", 0.9},
      {"teleport", 0.3}, {"turning_platform", 0.5}, {"apart_and_back", 0.1}, {"tiny_bodies", 0.4}};
  for (const auto& [name, share] : least) {
    INFO(name);
    CHECK(share_of_frames(name, touches_clearly) >= share);
  }
  CHECK(share_of_frames("teleport", [](const PairCase& pair) { return depth_share(pair) < -1; }) >=
        0.2);
  const auto is_past = [](const PairCase& pair) { return depth_share(pair) < -0.02; };
  CHECK(share_of_frames("apart_and_back", is_past) >= 0.2);
  CHECK(share_of_frames("apart_and_back", is_past) <= 0.7);
}

TEST_CASE("bodies move as their motion says") {
  CHECK(share_of_steps("resting", [](const PairCase& before, const PairCase& after) {
          return went(before, after) < 1e-3;
        }) >= 0.8);
  CHECK(share_of_steps("sliding", [](const PairCase& before, const PairCase& after) {
          return went(before, after) > 0.01;
        }) >= 0.3);
  CHECK(share_of_steps("turning_platform", [](const PairCase& before, const PairCase& after) {
          return a_turned(before, after) > 1e-3 && went(before, after) < 0.01;
        }) >= 0.7);
  CHECK(share_of_steps("teleport", [](const PairCase& before, const PairCase& after) {
          return went(before, after) > 2;
        }) >= 0.1);
  CHECK(share_of_frames("tiny_bodies", [](const PairCase& pair) { return size(pair) < 0.05; }) ==
        1);
}

}  // namespace manifuzz
