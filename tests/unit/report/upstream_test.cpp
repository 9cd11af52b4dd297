#include "report/upstream.hpp"

#include <catch2/catch.hpp>

#include "base/user_error.hpp"
#include "unit/report/sample.hpp"

using namespace manifuzz;

TEST_CASE("a snippet's placeholders become the case's numbers") {
  PairCase pair = test::box_on_box(0.25F);
  pair.b.pose.position = {0.5F, -2};
  CHECK(filled_in("f(@b.position[]@, @b.position{}@, @a.count@)", pair) ==
        "f([0.5, -2], {0.5, -2}, 4)");
  CHECK(filled_in("@a.rotation[]@ @b.radius@ @c.radius@", pair) == "[1, 0] 0 @c.radius@");
  CHECK(filled_in("@a.vertices{}@", pair).starts_with("{{"));
}

TEST_CASE("a report says what was got, what is right, and how to see it") {
  JudgedCase judged = test::judged_case(test::box_on_box(0.25F), "clip", "box2d");
  CHECK_THROWS_AS(upstream_report(judged, "--subject clip"), UserError);
  judged.oracle.answer = Manifold<double>{};
  judged.judgement = judge(judged.given.pair, {judged.subject.declaration, judged.subject.answer},
                           {judged.oracle.declaration, judged.oracle.answer});
  const std::string report = upstream_report(judged, "--subject clip");
  CHECK(report.starts_with("# box2d 2.4.1: oracle wrong"));
  CHECK(report.find("## Got\n\n```\nno contact") != std::string::npos);
  CHECK(report.find("depth 0.25") != std::string::npos);
  CHECK(report.find("b2CollidePolygons(&manifold") != std::string::npos);
  CHECK(report.find('@') == std::string::npos);
}
