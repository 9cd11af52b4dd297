#include "report/case_text.hpp"

#include <catch2/catch.hpp>

#include "unit/report/sample.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

TEST_CASE("the text holds polygons, truth, bounds, candidate, answers and verdict") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.given.found = Found{.seed = 7, .regime = "boxes", .index = 12, .versions = {}};
  judged.given.note = "Two boxes.";
  const std::string text = case_text(judged);
  CHECK_THAT(text, Contains("agree within rounding: clip and box2d"));
  CHECK_THAT(text, Contains("none/agree/none/none/a"));
  CHECK_THAT(text, Contains("seed 7, regime boxes, index 12"));
  CHECK_THAT(text, Contains("Two boxes."));
  CHECK_THAT(text, Contains("vertex 3           (-0.5, 0.5)"));
  CHECK_THAT(text, Contains("world (-0.5, -0.75)"));
  CHECK_THAT(text, Contains("separation S_A     -0.25                    A face 0"));
  CHECK_THAT(text, Contains("separation S_B     -0.25                    B face 2"));
  CHECK_THAT(text, Contains("touching, near     yes, no"));
  CHECK_THAT(text, Contains("reference          A face 0, world (-1, -1) to (1, -1)"));
  CHECK_THAT(text, Contains("incident           B face 2, world (0.5, -0.75) to (-0.5, -0.75)"));
  CHECK_THAT(text, Contains("depth 0.25, features A f0, B v3"));
  CHECK_THAT(text, Contains("oracle: box2d 2.4.1, 2 points"));
}

TEST_CASE("numbers of the text read back bit for bit") {
  PairCase pair = box_on_box(0.25F);
  pair.a.pose.position = {0.1F, 1e-7F};
  pair.b.polygon.radius = 0.3F;
  const std::string text = case_text(judged_case(pair));
  CHECK_THAT(text, Contains("position           (0.1, 1e-07)"));
  CHECK_THAT(text, Contains("world (-0.8999999985098839, -0.9999998999999988)"));
  CHECK_THAT(text, Contains("total radius       0.30000001192092896"));
}

TEST_CASE("polygons apart have no right manifold but none") {
  const std::string text = case_text(judged_case(box_on_box(-0.5F)));
  CHECK_THAT(text, Contains("one of 0 for clip"));
  CHECK_THAT(text, Contains("subject: clip 0.1.0, no contact"));
}

TEST_CASE("a ledger entry is shown with its source") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.judgement.explanation = &ledger().front();
  const std::string text = case_text(judged);
  CHECK_THAT(text, Contains(std::string(ledger().front().id)));
  CHECK_THAT(text, Contains(std::string(ledger().front().source)));
}
