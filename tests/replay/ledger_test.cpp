#include <cmath>

#include <catch2/catch.hpp>

#include "campaign/in_child.hpp"
#include "corpus/corpus.hpp"
#include "judging/by_curve.hpp"
#include "judging/judge.hpp"
#include "judging/unjudged.hpp"
#include "support/installed_collider.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"

// Each entry of the ledger is alive: its witness still shows the deviation it names.

using namespace manifuzz;

namespace {

void check_alive(const LedgerEntry& entry) {
  const auto oracle = test::installed_collider(entry.collider);
  if (!oracle) return;
  const auto path = test::source_dir() / "corpus" / witness_of(entry);
  const CorpusCase witness = read_case_file(path.string());
  const std::string subject = witness.expect ? witness.expect->subject : "clip";
  Interruption interruption(kUntilSignal);
  const Judgement judgement =
      judge_in_child(witness.pair(), find_collider(subject), *oracle, interruption);
  CHECK(judgement.bucket.verdict == Verdict::known);
  REQUIRE(judgement.explanation != nullptr);
  CHECK(judgement.explanation->id == entry.id);
}

/// What an answer says, places of points left out where it claims none.
Manifold<double> manifold_of(const Answer& answer) {
  if (const Manifold<double>* const manifold = manifold_in(answer)) return *manifold;
  Manifold<double> manifold;
  const auto along = said_along(answer);
  if (!along) return manifold;
  manifold.count = 1;
  manifold.normal = along->normal;
  manifold.points[0].depth = along->depth;
  return manifold;
}

/// Puts both shapes where A's frame is, each scaled to a diameter of 1.
void scale_to_unit(PairCase& pair) {
  for (Body* const body : {&pair.a, &pair.b}) {
    const auto scale = 1 / static_cast<float>(size(body->polygon));
    body->pose.position = {0, 0};
    body->polygon.radius *= scale;
    for (int i = 0; i < body->polygon.count; ++i) body->polygon.vertices[i] *= scale;
  }
}

/// The witness of an entry on lost answers: no other loss is explained, nor that of another pair.
void check_strict_on_lost(const LedgerEntry& entry, const PairCase& pair, const Collider& oracle) {
  Interruption interruption(kUntilSignal);
  const Answer answer = ask_in_child(oracle, pair, interruption);
  const auto* const lost = std::get_if<Lost>(&answer);
  const Lost::How how = lost != nullptr ? lost->how : Lost::How::malformed;
  for (const auto each : {Lost::How::crashed, Lost::How::timed_out, Lost::How::malformed}) {
    CHECK(entry.explains_lost({pair, answer, each}) == (each == how));
  }
  PairCase other = pair;
  other.b.pose.position.x() += 4 * static_cast<float>(size(pair.a.polygon) + size(pair.b.polygon));
  // Where it is the lengths that lose an answer, wherever the shapes are: a pair of usual ones.
  const Answer of_other = ask_in_child(oracle, other, interruption);
  if (why_lost(other, {oracle.declaration, of_other})) scale_to_unit(other);
  CHECK_FALSE(entry.explains_lost({other, answer, how}));
}

/// The witness of an entry that the penetration curve judges, and what becomes of other wrong
/// answers to it.
void check_strict(const LedgerEntry& entry) {
  const auto oracle = test::installed_collider(entry.collider);
  if (!oracle) return;
  const auto path = test::source_dir() / "corpus" / witness_of(entry);
  const PairCase pair = read_case_file(path.string()).pair();
  if (entry.explains == nullptr) return check_strict_on_lost(entry, pair, *oracle);
  if (!is_judged_by_curve(oracle->declaration, pair)) return;
  const Admissible right = admissible(pair, oracle->declaration);
  const auto explains = [&](const Manifold<double>& answer, Kind kind) {
    return entry.explains({right, answer, kind, &pair});
  };
  const Manifold<double> got = manifold_of(oracle->collide(pair));
  Manifold<double> wanted = manifold_of(find_collider("clip").collide(pair));
  // What float cannot see, double may.
  if (wanted.count == 0) wanted = manifold_of(find_collider("clip64").collide(pair));
  const Kind kind = judge(pair, find_collider("clip"), *oracle).bucket.kind;
  CHECK(explains(got, kind));
  for (const double angle : {-0.4, 0.4}) {
    Manifold<double> turned = wanted;
    turned.normal = rotate<double>({std::cos(angle), std::sin(angle)}, wanted.normal);
    if (turned.count > 0 && !is_round(pair)) {
      turned.points[0].depth = exact::Along(*right.truth, turned.normal).depth();
      turned.points[1].depth = 0;
    }
    CHECK_FALSE(explains(turned, Kind::not_minimal));
  }
  Manifold<double> deeper = got;
  for (ContactPoint<double>& point : deeper.points) point.depth += size(pair);
  if (deeper.count > 0) CHECK_FALSE(explains(deeper, Kind::inconsistent));
}

[[maybe_unused]] const bool registered = [] {
  for (const LedgerEntry& entry : ledger()) {
    test::add_test("the witness of " + std::string(entry.id) + " still shows it", "[ledger]",
                   [&entry] { check_alive(entry); });
    test::add_test(std::string(entry.id) + " explains no other wrong answer to its witness",
                   "[ledger]", [&entry] { check_strict(entry); });
  }
  return true;
}();

}  // namespace
