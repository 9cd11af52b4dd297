#include "report/picture/labels.hpp"

#include <catch2/catch.hpp>

#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

std::vector<Element> drawn(const LabelLayer& labels) {
  Svg svg;
  labels.draw(svg);
  return read_svg(svg.finish(100, 100, "", ""));
}

Label label_at(const Point& anchor) {
  return {.text = "depth 0.25", .anchor = anchor, .css = "word"};
}

constexpr Box kFrame{0, 0, 400, 300};

}  // namespace

TEST_CASE(
    "labels of one anchor cover neither each other nor what is blocked, nor leave the frame") {
  LabelLayer labels(kFrame);
  const Box blocked{180, 140, 40, 20};
  labels.block(blocked);
  for (int i = 0; i < 12; ++i) REQUIRE(labels.place(label_at({200, 150})));
  const auto boxes = select(drawn(labels), "rect", "label");
  REQUIRE(boxes.size() == 12);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK(kFrame.contains(boxes[i].box()));
    CHECK_FALSE(boxes[i].box().overlaps(blocked));
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(boxes[i].box().overlaps(boxes[j].box()));
  }
}

TEST_CASE("a label at the edge stays inside") {
  for (const Point& anchor : {Point(0, 0), Point(400, 0), Point(400, 300), Point(0, 300)}) {
    LabelLayer labels(kFrame);
    REQUIRE(labels.place(label_at(anchor)));
    CHECK(kFrame.contains(select(drawn(labels), "rect", "label").at(0).box()));
  }
}

TEST_CASE("a label lies in the direction it had rather lie in") {
  for (const Point& towards : {Point(1, 0), Point(-1, 0), Point(0, 1), Point(0, -1)}) {
    LabelLayer labels(kFrame);
    labels.block(Box{200, 150, 0, 0}.grown(8));
    Label label = label_at({200, 150});
    label.towards = towards;
    REQUIRE(labels.place(label));
    const Box box = select(drawn(labels), "rect", "label").at(0).box();
    CHECK((box.center() - label.anchor).dot(towards) > 0);
  }
}

TEST_CASE("a label avoids a line") {
  LabelLayer labels(kFrame);
  const Segment line{{0, 160}, {400, 160}};
  labels.avoid(line);
  REQUIRE(labels.place(label_at({200, 158})));
  CHECK_FALSE(inside(line, select(drawn(labels), "rect", "label").at(0).box()));
}

TEST_CASE("a label that lies away has a line to what it names") {
  LabelLayer labels(kFrame);
  labels.block(Box{200, 150, 0, 0}.grown(60));
  REQUIRE(labels.place(label_at({200, 150})));
  const auto leaders = select(drawn(labels), "line", "leader");
  REQUIRE(leaders.size() == 1);
  CHECK(leaders[0].number("x2") == 200);
  CHECK(leaders[0].number("y2") == 150);
}

TEST_CASE("a label without a place within its reach is left out") {
  LabelLayer labels(kFrame);
  labels.block(Box{200, 150, 0, 0}.grown(60));
  Label label = label_at({200, 150});
  label.reach = 20;
  CHECK_FALSE(labels.place(label));
  labels.block(kFrame);
  CHECK_FALSE(labels.place(label_at({200, 150})));
  CHECK(select(drawn(labels), "rect", "label").empty());
}
