#include "engines/sequence_colliders.hpp"

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "sequence/motions.hpp"
#include "sequence/sequence_judge.hpp"
#include "support/skip.hpp"

using namespace manifuzz;

namespace {

std::optional<SequenceCollider> installed(std::string_view name) {
  try {
    return find_sequence_collider(name);
  } catch (const UserError&) {
    return std::nullopt;
  }
}

std::optional<KeptPoint> born_in(const KeptManifold& manifold, std::size_t frame) {
  for (const KeptPoint& point : manifold.points) {
    if (point.born == static_cast<int>(frame)) return point;
  }
  return std::nullopt;
}

/// Whether both were told the same in this frame: not where only one finds that they touch, nor
/// across a gap, of which a query of its own says nothing.
bool is_told_the_same(const KeptManifold& p, const KeptManifold& q, std::size_t frame) {
  const auto of_p = born_in(p, frame);
  const auto of_q = born_in(q, frame);
  return of_p.has_value() == of_q.has_value() && (!of_p || of_p->depth >= 0);
}

/// Up to three: which of four goes is for areas to say, which may be 0 but for rounding.
void check_kept_the_same(const Sequence& sequence, const std::vector<KeptAnswer>& of_bullet,
                         const std::vector<KeptAnswer>& of_rules, int& checked) {
  for (std::size_t frame = 0; frame < std::min(of_bullet.size(), of_rules.size()); ++frame) {
    const auto* const p = std::get_if<KeptManifold>(&of_bullet[frame]);
    const auto* const q = std::get_if<KeptManifold>(&of_rules[frame]);
    if (p == nullptr || q == nullptr || !is_told_the_same(*p, *q, frame)) return;
    if (p->points.size() > 3 || q->points.size() > 3) return;
    REQUIRE(p->points.size() == q->points.size());
    for (std::size_t i = 0; i < p->points.size(); ++i) {
      REQUIRE(p->points[i].id == q->points[i].id);
      REQUIRE(p->points[i].born == q->points[i].born);
      REQUIRE(std::abs(p->points[i].depth - q->points[i].depth) < 1e-5 * size(sequence.at(0)));
    }
    checked += p->points.size() > 1 ? 1 : 0;
  }
}

}  // namespace

TEST_CASE("colliders that keep points are found by name, and have it") {
  for (const SequenceColliderEntry& entry : sequence_colliders()) {
    CHECK(find_sequence_entry(entry.name) == &entry);
    const auto collider = installed(entry.name);
    if (collider) CHECK(collider->declaration.name == entry.name);
    CHECK((collider.has_value() || !entry.is_ours));
  }
  CHECK(find_sequence_collider("cached+gjk").declaration.name == "cached+gjk");
  CHECK(find_sequence_collider("cached-bullet+gjk64").declaration.name == "cached-bullet+gjk64");
}

TEST_CASE("what is no collider that keeps points is said to be none") {
  CHECK_THROWS_WITH(
      find_sequence_collider("cachd"),
      Catch::Contains("no collider that keeps points 'cachd'") && Catch::Contains("cached"));
  CHECK_THROWS_WITH(find_sequence_collider("cached+clip"),
                    Catch::Contains("clip does not give one point a pair"));
  CHECK_THROWS_WITH(find_sequence_collider("cached+gjk-shrunk"),
                    Catch::Contains("gjk-shrunk alters shapes"));
  CHECK_THROWS_WITH(find_sequence_collider("cached+gkj"), Catch::Contains("gkj"));
}

TEST_CASE("what Bullet detects is kept by its rules here as Bullet keeps it") {
  const auto of_bullet = installed("bullet-cached");
  const auto of_rules = installed("cached-bullet+bullet-epa");
  if (!of_bullet || !of_rules) {
    test::skip("Bullet is not installed");
    return;
  }
  int checked = 0;
  for (const char* const motion : {"resting", "rocking", "rolling", "turning_platform"}) {
    for (std::uint64_t index = 0; index < 40; ++index) {
      CAPTURE(motion, index);
      const Sequence sequence = draw_sequence(7, *find_motion(motion), index);
      check_kept_the_same(sequence, ask_sequence(*of_bullet, sequence),
                          ask_sequence(*of_rules, sequence), checked);
    }
  }
  CHECK(checked > 100);
}

TEST_CASE("what Bullet keeps is right, or wrong in a way that the ledger knows") {
  const auto of_bullet = installed("bullet-cached");
  if (!of_bullet) {
    test::skip("Bullet is not installed");
    return;
  }
  int known = 0;
  for (const Motion& motion : motions()) {
    for (std::uint64_t index = 0; index < 150; ++index) {
      CAPTURE(motion.name, index);
      const Sequence sequence = draw_sequence(
          77'001, motion, index, [&](const Sequence& drawn) { return takes(*of_bullet, drawn); });
      const auto judgement =
          judge_sequence(sequence, *of_bullet, ask_sequence(*of_bullet, sequence));
      CHECK(judgement.bucket.verdict != Verdict::subject_wrong);
      known += judgement.bucket.verdict == Verdict::known ? 1 : 0;
    }
  }
  CHECK(known > 100);
}
