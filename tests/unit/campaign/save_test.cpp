#include "campaign/save.hpp"

#include <catch2/catch.hpp>

#include "campaign/in_child.hpp"
#include "campaign/pairs/recorded_case.hpp"
#include "engines/colliders.hpp"

using namespace manifuzz;
using Catch::Contains;

namespace {

CorpusCase recorded(const PairCase& pair, const Collider& subject) {
  const Collider oracle = find_collider("clip64");
  Interruption interruption;
  const Judgement judgement = judge_in_child(pair, subject, oracle, interruption);
  return recorded_case(pair, judgement, subject, oracle, interruption);
}

ConvexPolygon<float> circle(float radius) {
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  return make_polygon<float>(center, radius);
}

PairCase boxes() {
  const std::vector<Vector2<float>> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair;
  pair.a.polygon = pair.b.polygon = make_polygon<float>(square);
  pair.b.pose.position = {1.5F, 0.25F};
  return pair;
}

}  // namespace

TEST_CASE("a note tells the separation of shapes that have no face") {
  PairCase circles;
  circles.a.polygon = circles.b.polygon = circle(1);
  circles.b.pose.position = {1.5F, 0};
  const Collider clip = find_collider("clip");
  CHECK_THAT(recorded(circles, clip).note, Contains(", the separation being 1.5."));
  CHECK_THAT(recorded(boxes(), clip).note, Contains(", the greatest separation being -0.5."));
}

TEST_CASE("what is recorded of an answer has no negative zeros") {
  Collider signing = find_collider("clip");
  signing.collide = [](const PairCase& pair) {
    Manifold<double> manifold = std::get<Manifold<double>>(find_collider("clip").collide(pair));
    manifold.normal.y() = -0.0;
    for (auto& point : manifold.points) point.position.y() = -0.0;
    return Answer(manifold);
  };
  PairCase turned = boxes();
  turned.a.pose.rotation = {-1, 0};
  turned.b.pose.position = {-1.5F, 0.25F};
  for (const PairCase& pair : {boxes(), turned}) {
    const std::string text = format_case(recorded(pair, signing));
    INFO(text);
    CHECK_THAT(text, Contains("\"normal\": [") && !Contains("-0.0,") && !Contains("-0.0]"));
  }
}
