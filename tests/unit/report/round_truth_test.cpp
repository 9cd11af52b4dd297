#include "report/round_truth.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "report/words.hpp"
#include "support/named_tests.hpp"
#include "unit/report/sample.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// A circle of radius 1 in the origin, and below it a box of 2 by 2 that overlaps it by 0.25.
PairCase circle_on_box() {
  PairCase pair;
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  pair.a.polygon = make_polygon<float>(center, 1.0F);
  pair.b.polygon = box_polygon(1, 1);
  pair.b.pose.position = {0.5F, -1.75F};
  return pair;
}

/// Whatever a report shows as right, the judge takes for right.
void check_shown(const PairCase& pair) {
  const Declaration declaration = find_collider("clip").declaration;
  for (const auto& shown : manifolds_to_show(admissible(pair, declaration), declaration)) {
    const ColliderAnswer answer{declaration, shown};
    const Judgement judgement = judge(pair, answer, answer);
    CAPTURE(case_json(pair).dump(), to_string(judgement.bucket));
    const Verdict verdict = judgement.bucket.verdict;
    CHECK((verdict == Verdict::agree || verdict == Verdict::tie || verdict == Verdict::ill_posed));
  }
}

[[maybe_unused]] const bool shown_registered = [] {
  for (const Regime& regime : regimes()) {
    add_test("what reports show as right is right, in " + std::string(regime.name), "[report]",
             [&regime] {
               for (std::uint64_t index = 0; index < 300; ++index) {
                 const PairCase pair = generate(1, regime, index);
                 CAPTURE(index);
                 if (is_round(pair)) check_shown(pair);
               }
             });
  }
  return true;
}();

}  // namespace

TEST_CASE("the right contact of a circle on a box is its lowest point") {
  const Declaration declaration = find_collider("clip").declaration;
  const auto shown = manifolds_to_show(admissible(circle_on_box(), declaration), declaration);
  REQUIRE(shown.size() == 1);
  REQUIRE(shown[0].count == 1);
  CHECK(shown[0].normal == Vector2<double>(0, -1));
  CHECK(shown[0].points[0].position == Vector2<double>(0, -1));
  CHECK(shown[0].points[0].depth == 0.25);
  CHECK(shown[0].points[0].features.a == Feature{Feature::Kind::vertex, 0});
  CHECK(shown[0].points[0].features.b == Feature{Feature::Kind::face, 2});
}

TEST_CASE("the text of round shapes names them and the right contact") {
  const std::string text = case_text(judged_case(circle_on_box()));
  CHECK_THAT(text, Contains("A: circle, radius 1\n"));
  CHECK_THAT(text, Contains("B: 4 vertices\n"));
  CHECK_THAT(text, Contains("right contact        one of 1 for clip"));
  CHECK_THAT(text, Contains("separation S_A     a point has no face"));
}

TEST_CASE("a report on round shapes says what they are, and what is right") {
  JudgedCase judged = judged_case(circle_on_box());
  judged.oracle.answer = Manifold<double>{};
  judged.judgement = judge(judged.given.pair(), {judged.subject.declaration, judged.subject.answer},
                           {judged.oracle.declaration, judged.oracle.answer});
  const std::string report = upstream_report(judged, "--subject clip");
  CHECK_THAT(report,
             Contains("# A circle and a quadrilateral that overlap by 0.25 have no contact\n"));
  CHECK_THAT(report, Contains("- Expected: normal (0, 1) from B to A; world.points (0, -0.875), "
                              "separations -0.25.\n"));
}

TEST_CASE("of round shapes the truth of a map says that they touch") {
  const exact::Truth truth(circle_on_box());
  CHECK(statement_in_words(summary_of(truth)) == "they touch");
}

TEST_CASE("words on round shapes are not on polygons") {
  JudgedCase judged = judged_case(circle_on_box());
  judged.judgement.bucket = {.verdict = Verdict::ill_posed};
  CHECK_THAT(verdict_sentence(judged), Contains("moves these shapes by"));
}
