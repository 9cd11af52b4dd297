#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "generating/drafts.hpp"
#include "generating/sweep.hpp"
#include "measure/stress/stress.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

using Planted = std::function<void(std::uint64_t frame, Manifold<double>& manifold)>;

/// The changes of `clip` with a bias, spoilt as planted, through so many frames.
WalkChanges changes_of(std::string_view walk, std::uint64_t frames, const Planted& planted = {}) {
  const Collider clip = make_clip(0.0005);
  Walker walker(1, *find_by_name(walks(), walk));
  WalkChangeCounter counter;
  for (std::uint64_t frame = 0; frame < frames; ++frame) {
    const PairCase pair = walker.next();
    Referee referee(pair);
    auto manifold = std::get<Manifold<double>>(clip.collide(pair));
    if (planted) planted(frame, manifold);
    counter.add(frame, referee, clip.declaration, manifold);
  }
  return counter.changes();
}

}  // namespace

TEST_CASE("every frame of a walk is a valid pair, near to the one before") {
  for (const Walk& walk : walks()) {
    CAPTURE(walk.name);
    Walker walker(1, walk);
    PairCase before = walker.next();
    double longest = 0;
    int invalid = 0;
    int moved = 0;
    for (int i = 0; i < 2000; ++i) {
      const PairCase now = walker.next();
      invalid += revalidated(now) ? 0 : 1;
      moved += now == before ? 0 : 1;
      const Vector2<double> way = (now.b.pose.position - before.b.pose.position).cast<double>();
      longest = std::max(longest, way.norm());
      before = now;
    }
    CHECK(invalid == 0);
    CHECK(moved >= 1900);
    CHECK(longest < 0.2);
  }
}

TEST_CASE("a walk's frames depend on the seed and the walk alone") {
  const Walk& walk = *find_by_name(walks(), "tumbling");
  Walker walker(3, walk);
  for (int i = 0; i < 10; ++i) walker.next();
  CHECK(walker.next() == frame_of(3, walk, 10));
  CHECK_FALSE(frame_of(4, walk, 10) == frame_of(3, walk, 10));
  CHECK(find_by_name(walks(), "none") == nullptr);
}

TEST_CASE("nothing is held against a steady collider") {
  for (const Walk& walk : walks()) {
    CAPTURE(walk.name);
    const WalkChanges changes = changes_of(walk.name, 3000);
    CHECK(changes.touching > 1000);
    CHECK(changes.flickers.with_margin == 0);
    CHECK(changes.jumps.with_margin == 0);
    CHECK(changes.features.with_margin == 0);
  }
}

TEST_CASE("a planted flicker of the reference is seen, each time") {
  const auto flicker = [](std::uint64_t frame, Manifold<double>& manifold) {
    if (frame == 100 || frame == 200) {
      manifold.reference = other(manifold.reference);
    }
  };
  const WalkChanges changes = changes_of("resting", 300, flicker);
  CHECK(changes.flickers.with_margin == 4);  // there and back, twice
  CHECK(changes.flickers.first == 100);
  CHECK(changes.flickers.within_bound == 0);
  CHECK(changes.jumps.with_margin == 0);
}

TEST_CASE("a flicker within the bound is told from one with a margin") {
  const Collider clip = make_clip(0);  // box on box: the faces of both tie
  Walker walker(1, *find_by_name(walks(), "resting"));
  WalkChangeCounter counter;
  for (std::uint64_t frame = 0; frame < 500; ++frame) {
    const PairCase pair = walker.next();
    Referee referee(pair);
    counter.add(frame, referee, clip.declaration, clip.collide(pair));
  }
  CHECK(counter.changes().flickers.with_margin == 0);
  CHECK(counter.changes().flickers.within_bound > 0);
}

TEST_CASE("a planted jump of a point is seen") {
  const auto jump = [](std::uint64_t frame, Manifold<double>& manifold) {
    if (frame == 150) manifold.points[1].position.x() += 1e-3;
  };
  const WalkChanges changes = changes_of("resting", 300, jump);
  CHECK(changes.jumps.with_margin + changes.jumps.within_bound == 2);
  CHECK(changes.flickers.with_margin == 0);
}

TEST_CASE("planted changes of features and of the number of points are seen") {
  const auto change = [](std::uint64_t frame, Manifold<double>& manifold) {
    if (frame == 50) manifold.points[0].features.a.index ^= 1;
    if (frame == 100) manifold.count = 1;
  };
  const WalkChanges changes = changes_of("resting", 300, change);
  CHECK(changes.features.with_margin + changes.features.within_bound == 4);
}

TEST_CASE("frames without a contact end what is compared") {
  const auto lose = [](std::uint64_t frame, Manifold<double>& manifold) {
    if (frame == 100) manifold = {};
    if (frame == 101) manifold.reference = other(manifold.reference);
  };
  CHECK(changes_of("resting", 300, lose).flickers.with_margin == 1);  // back, at frame 102
}

}  // namespace manifuzz
