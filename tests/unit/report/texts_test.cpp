#include <algorithm>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "report/upstream/parts.hpp"
#include "report/upstream/program.hpp"
#include "report/words.hpp"
#include "unit/report/sample.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

TEST_CASE("numbers in labels are short") {
  CHECK(brief(0.31) == "0.31");
  CHECK(brief(-0.0) == "0");
  CHECK(brief(1.0 / 3) == "0.3333");
  CHECK(brief(20000) == "20000");
  CHECK(brief(-123456) == "-123456");
  CHECK(brief(1e7) == "1e+07");
  CHECK(brief(1e-9) == "1e-09");
}

TEST_CASE("agreement says what they agree on") {
  CHECK(verdict_sentence(judged_case(box_on_box(0.25F))) ==
        "agree within rounding: clip and box2d report 2 points, depths 0.25 and 0.25");
  CHECK(verdict_sentence(judged_case(box_on_box(-0.5F))) ==
        "agree: clip and box2d report no contact, gap 0.5");
}

TEST_CASE("what lies between the polygons") {
  CHECK(truth_in_words(box_on_box(0.25F)) == "overlap 0.25");
  CHECK(truth_in_words(box_on_box(-0.5F)) == "gap 0.5");
  CHECK(truth_in_words(box_on_box(-0.25F, 0.5F)) == "depth 0.25");
  CHECK(truth_in_words(box_on_box(0)) == "overlap 0");
}

TEST_CASE("a shape in words says what it is, round corners of radius 0 too") {
  CHECK(shape_in_words(box_polygon(1, 1)) == "4 vertices");
  CHECK(shape_in_words(box_polygon(1, 1, 0.5F)) == "4 vertices, radius 0.5");
  ConvexPolygon<float> rounded = box_polygon(1, 1);
  rounded.rounding = Rounding::round;
  CHECK(shape_in_words(rounded) == "4 vertices, radius 0, round corners");
}

TEST_CASE("each verdict has its sentence") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.judgement.magnitude = 0.5;
  const auto sentence = [&](Verdict verdict, Kind kind, Fault fault) {
    judged.judgement.bucket.verdict = verdict;
    judged.judgement.bucket.kind = kind;
    judged.judgement.bucket.fault = fault;
    return verdict_sentence(judged);
  };
  CHECK(sentence(Verdict::known, Kind::missed_contact, Fault::oracle) ==
        "oracle wrong (known): box2d reports no contact, true overlap 0.25");
  CHECK(sentence(Verdict::subject_wrong, Kind::depth, Fault::subject) ==
        "subject wrong: a depth of clip is off by 0.7071");
  judged.judgement.of_subject.errors[Component::depth] = 0.25;
  CHECK(sentence(Verdict::subject_wrong, Kind::depth, Fault::subject) ==
        "subject wrong: a depth of clip is off by 0.3536");
  CHECK(sentence(Verdict::oracle_wrong, Kind::normal, Fault::oracle) ==
        "oracle wrong: the normal of box2d is off by 0.5");
  CHECK(sentence(Verdict::both_wrong, Kind::position, Fault::both) ==
        "both wrong: a point of clip is off by 0.7071, and box2d is wrong too");
  CHECK(sentence(Verdict::subject_wrong, Kind::count, Fault::subject) ==
        "subject wrong: clip leaves out a point that is 0.7071 deep");
  CHECK(sentence(Verdict::crashed, Kind::none, Fault::oracle) ==
        "crashed: box2d died on this case");
  CHECK(sentence(Verdict::timed_out, Kind::none, Fault::subject) ==
        "timed out: clip gave no answer in time");
  CHECK(sentence(Verdict::malformed, Kind::none, Fault::oracle) ==
        "malformed: box2d answered nonsense");
  for (std::size_t verdict = 0; verdict < kVerdictNames.size(); ++verdict) {
    for (std::size_t kind = 0; kind < kKindNames.size(); ++kind) {
      const std::string text =
          sentence(static_cast<Verdict>(verdict), static_cast<Kind>(kind), Fault::subject);
      CAPTURE(kVerdictNames[verdict], kKindNames[kind]);
      CHECK(text.size() > 20);
      CHECK(text.find("  ") == std::string::npos);
    }
  }
}

TEST_CASE("a sentence of what is malformed says why") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.judgement.bucket = bucket_of_lost(Verdict::malformed, Fault::subject);
  std::get<Manifold<double>>(judged.subject.answer).points[1].depth = -0.5;
  CHECK(verdict_and_why(judged) ==
        "malformed: clip answered nonsense: point 1: depth -0.5 is below 0; 0 or more is expected");
  judged.subject.answer = Lost{Lost::How::malformed, "$: ends too early"};
  CHECK(verdict_and_why(judged) == "malformed: clip answered nonsense: $: ends too early");
}

TEST_CASE("what a collider answered") {
  DeclaredAnswer asked = judged_case(box_on_box(0.25F)).subject;
  CHECK(answer_in_words(asked) == "2 points, depths 0.25 and 0.25");
  asked.answer = Unsupported{"too many vertices"};
  CHECK(answer_in_words(asked) == "unsupported: too many vertices");
  asked.answer = Lost{Lost::How::crashed, "crashed"};
  CHECK(answer_in_words(asked) == "crashed");
}

TEST_CASE("an unsupported case says why") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.oracle.answer = Unsupported{"rounded polygons"};
  judged.judgement.bucket = {.verdict = Verdict::unsupported};
  CHECK(verdict_sentence(judged) == "unsupported: box2d cannot take this case: rounded polygons");
}

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

TEST_CASE("what the text computes has no negative zeros") {
  PairCase pair = box_on_box(0.25F);
  pair.a.pose.rotation = {-1, 0};
  pair.b.pose.rotation = {-1, 0};
  const std::string text = case_text(judged_case(pair));
  INFO(text);
  CHECK_THAT(text, Contains("normal") && !Contains("-0.0,") && !Contains("-0.0)"));
}

TEST_CASE("every right manifold is shown with what tells it apart") {
  PairCase pair = box_on_box(0.25F);
  pair.b.pose.position.x() = 0.75F;
  const std::string text = case_text(judged_case(pair));
  CHECK_THAT(text, Contains("right manifold       1 of 2 for clip\n"
                            "  reference          A face 0, world (-1, -1) to (1, -1)\n"));
  CHECK_THAT(text,
             Contains("  ends               first not clipped, second clipped at A vertex 1"));
  CHECK_THAT(text, Contains("right manifold       2 of 2 for clip\n"
                            "  reference          B face 2, world (1.25, -0.75)"));
}

TEST_CASE("a wrong answer is shown with the step at which it departs") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  auto& manifold = std::get<Manifold<double>>(judged.subject.answer);
  manifold.normal = -manifold.normal;
  const std::string text = case_text(judged);
  CHECK_THAT(text,
             Contains("  why it is wrong    It departs at the reference edge: with the normal "
                      "not turned to point from A to B the clip gives this answer.\n"));
  manifold.normal = -manifold.normal;
  CHECK_THAT(case_text(judged), !Contains("why it is wrong"));
}

TEST_CASE("polygons apart have no right manifold but none") {
  const std::string text = case_text(judged_case(box_on_box(-0.5F)));
  CHECK_THAT(text,
             Contains("right manifold       1 of 1 for clip\n                     no contact\n"));
  CHECK_THAT(text, Contains("subject: clip 0.1.0, no contact"));
}

TEST_CASE("a ledger entry is shown with its source") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.judgement.explanation = &ledger().front();
  const std::string text = case_text(judged);
  CHECK_THAT(text, Contains(std::string(ledger().front().id)));
  CHECK_THAT(text, Contains(std::string(ledger().front().source)));
}

TEST_CASE("a snippet's placeholders become the case's numbers") {
  PairCase pair = test::box_on_box(0.25F);
  pair.b.pose.position = {0.5F, -2};
  CHECK(filled_in("f(@b.position[]@, @b.position{}@, @a.count@)", pair) ==
        "f([0.5, -2], {0.5, -2}, 4)");
  CHECK(filled_in("@a.rotation[]@ @b.radius@ @c.radius@", pair) == "[1, 0] 0 @c.radius@");
  CHECK(filled_in("@a.vertices{}@", pair).starts_with("{{"));
}

TEST_CASE("a snippet's numbers in forms, of floats and of doubles") {
  PairCase pair = test::box_on_box(0.25F);
  pair.b.polygon.radius = 0.1F;
  pair.b.pose.position = {0.1F, -2};
  pair.b.pose.rotation = {0, 1};
  CHECK(filled_in("f(@b.position({ x: $x, y: $y })@)", pair) == "f({ x: 0.1, y: -2 })");
  CHECK(filled_in("@b.position($X, $Y)@", pair) == "0.10000000149011612, -2");
  CHECK(filled_in("@b.radius@ @b.wide_radius@", pair) == "0.1 0.10000000149011612");
  CHECK(filled_in("@a.vertices(v($x, $y))@", pair) == "v(-1, -1), v(1, -1), v(1, 1), v(-1, 1)");
  CHECK(filled_in("@a.unit_normals([$X])@", pair) == "[0], [1], [0], [-1]");
  CHECK(filled_in("@a.centroid($X, $Y)@ @b.unit_rotation($X, $Y)@", pair) == "0, 0 0, 1");
  CHECK(filled_in("@a.world($X)@", pair) == "-1, 1, 1, -1");
}

TEST_CASE("a snippet's lines stand where their conditions hold") {
  PairCase pair = test::box_on_box(0.25F);
  pair.b.pose.position = {0, 1};
  const std::string snippet =
      "@a.circle? circle\n  @a.polygon? polygon\n@a.polygon? @b.segment? both\n"
      "@a.polygon? @!b.segment? not both\n@a.placed? a\n@b.placed? b\n@b.turned? turned\n"
      "@b.moved? moved\n@!a.rounded? sharp\n@each @*.polygon? @* is @^, @*.count(\nend";
  CHECK(filled_in(snippet, pair) ==
        "  polygon\nnot both\nb\nmoved\nsharp\na is A, @a.count(\nb is B, @b.count(\nend");
}

TEST_CASE("a snippet says of its engine what the report needs") {
  const Program program = program_for(
      "@language js\n@point at $p\n@no_normal\n@b_first\n@figures as they stand\n"
      "lib.@asked(collide)@(1);\n",
      test::box_on_box(0.25F));
  CHECK(program.text == "lib.collide(1);\n");
  CHECK(program.function == "collide");
  CHECK(program.language == "js");
  CHECK(program.point == "at $p");
  CHECK_FALSE(program.has_normal);
  CHECK(program.is_b_first);
  CHECK(program.figures == "as they stand");
}

TEST_CASE("a report says what was got, what is right, and how to see it") {
  JudgedCase judged = test::judged_case(test::box_on_box(0.25F), "clip", "box2d");
  CHECK_THROWS_AS(upstream_report(judged, "--subject clip"), UserError);
  judged.oracle.answer = Manifold<double>{};
  judged.judgement = judge(judged.given.pair(), {judged.subject.declaration, judged.subject.answer},
                           {judged.oracle.declaration, judged.oracle.answer});
  judged.given.expect.emplace().severity = 0.5;
  const std::string report = upstream_report(judged, "--subject clip");
  INFO(report);
  CHECK(
      report.starts_with("# Quadrilaterals that overlap by 0.25 have no contact\n\n"
                         "box2d 2.4.1, `b2CollidePolygons`.\n"));
  CHECK(std::ranges::count(report, '\n') <= 30);
  CHECK_THAT(report, Contains("b2CollidePolygons(&manifold, &a, atA, &b, atB);\n"));
  CHECK_THAT(report, Contains("- Got: no contact.\n- Expected: normal (0, -1) from A to B; "
                              "world.points (-0.5, -0.875), separations -0.25; "));
  CHECK_THAT(report, Contains("- Users see: nothing pushes the bodies apart"));
  CHECK_THAT(report, Contains("each way: 50 % fail too.\n"));
  CHECK_THAT(report, Contains("- By hand: the face of A from (-1, -1) to (1, -1) has the outward "
                              "normal (0, -1), and B's vertex "));
  CHECK_THAT(report, Contains("0.25 behind it; so they overlap by 0.25"));
  CHECK(report.find('@') == std::string::npos);
}

TEST_CASE("every kind of finding has a title with figures, and what users see") {
  JudgedCase judged = test::judged_case(test::box_on_box(0.25F), "clip", "box2d");
  judged.judgement.magnitude = 0.5;
  for (std::size_t kind = 1; kind < kKindNames.size(); ++kind) {
    CAPTURE(kKindNames[kind]);
    judged.judgement.bucket.kind = static_cast<Kind>(kind);
    CHECK_THAT(upstream_title(judged, judged.oracle),
               Contains("uadrilaterals that overlap by 0.25"));
    CHECK(seen_by_users(judged, judged.oracle).size() >= 20);
  }
}
