#include "report/picture/drawing.hpp"

#include <catch2/catch.hpp>

#include "unit/report/sample.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

Region square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

double area(const Region& region) {
  double twice = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    twice += cross<double>(region[i], region[(i + 1) % region.size()]);
  }
  return twice / 2;
}

constexpr Box kEverything{-100, -100, 200, 200};

}  // namespace

TEST_CASE("two squares share the square between their corners") {
  CHECK(area(intersection(square(0, 0, 2), square(1.5, 1, 3))) == Approx(0.5));
}

TEST_CASE("a region inside another is what they share") {
  CHECK(area(intersection(square(0, 0, 4), square(1, 1, 1))) == Approx(1));
  CHECK(area(intersection(square(1, 1, 1), square(0, 0, 4))) == Approx(1));
}

TEST_CASE("regions apart share nothing") {
  CHECK(intersection(square(0, 0, 1), square(2, 0, 1)).empty());
}

TEST_CASE("a region is cut to a box, whichever way it turns") {
  Region region = square(-1, -1, 2);
  CHECK(area(intersection(region, Box{0, 0, 5, 5})) == Approx(1));
  std::reverse(region.begin(), region.end());
  CHECK(area(intersection(region, Box{0, 0, 5, 5})) == Approx(-1));
}

TEST_CASE("a segment is cut to a box") {
  const Box box{0, 0, 2, 1};
  const auto through = inside({{-1, 0.5}, {3, 0.5}}, box);
  REQUIRE(through);
  CHECK(through->first == Point(0, 0.5));
  CHECK(through->second == Point(2, 0.5));
  CHECK_FALSE(inside({{-1, 2}, {3, 2}}, box));
  CHECK_FALSE(inside({{-1, 0.5}, {-0.5, 0.5}}, box));
  CHECK_FALSE(inside({{-1, 0}, {1, 4}}, box));
  CHECK(inside({{1, 0.5}, {1, 0.5}}, box));
  CHECK_FALSE(inside({{1, 5}, {1, 5}}, box));
}

TEST_CASE("how deep a point lies in a region") {
  CHECK(depth_in(square(0, 0, 4), {1, 2}) == Approx(1));
  CHECK(depth_in(square(0, 0, 4), {6, 2}) == Approx(-2));
}

TEST_CASE("a rounded square has the area of its skin") {
  const exact::RoughPair world = exact::place_roughly(box_on_box(0));
  const double pi = 3.14159265358979;
  const Region skin = region_of(rim_of(world.a, 0.5, Rounding::round), kEverything, 1e-6);
  CHECK(area(skin) == Approx(4 + 4 * 2 * 0.5 + pi * 0.25).epsilon(1e-5));
  CHECK(area(region_of(rim_of(world.a, 0, Rounding::round), kEverything, 1e-6)) == Approx(4));
}

TEST_CASE("arcs are fine where they are looked at, and coarse elsewhere") {
  const exact::RoughPair world = exact::place_roughly(box_on_box(0));
  const double sine = 0.70710678118654752;
  const Point top = Point(1, 1) + 0.5 * Point(sine, sine);
  const Box about = Box{top.x(), top.y(), 0, 0}.grown(1e-6);
  const Region skin = region_of(rim_of(world.a, 0.5, Rounding::round), about, 1e-12);
  CHECK(std::abs(depth_in(skin, top)) < 1e-11);
  CHECK(skin.size() < 400);
}

TEST_CASE("an empty picture is well-formed") {
  const auto elements = read_svg(Svg("a < b & c", ".x{fill:red}").finish(10, 20));
  REQUIRE(elements.size() == 4);
  CHECK(elements[0].name == "svg");
  CHECK(elements[0].attributes.at("viewBox") == "0 0 10 20");
  CHECK(elements[1].text == "a < b & c");
  CHECK(select(elements, "rect", "paper").at(0).box().bottom() == 19.5);
}

TEST_CASE("text is escaped, and bytes that are not ASCII are spelt out") {
  Svg svg("", "");
  svg.text({1, 2}, "<a> & \"b\"\n\xff", {12}, "word");
  const auto elements = read_svg(svg.finish(10, 10));
  REQUIRE(select(elements, "text", "word").size() == 1);
  CHECK(select(elements, "text", "word")[0].text == "<a> & \"b\"\\x0a\\xff");
}

TEST_CASE("shapes come out with their coordinates, zero without a sign") {
  Svg svg("", "");
  svg.line({{-0.001, 1.5}, {2.25, 1e4}}, "l");
  svg.circle({1, 2}, 3, "c");
  svg.box({1, 2, 3, 4}, "b", 5);
  svg.polygon({{0, 0}, {1, 0}, {0, 1}}, "p");
  const auto elements = read_svg(svg.finish(10, 10));
  const Element line = select(elements, "line", "l").at(0);
  CHECK(line.attributes.at("x1") == "0");
  CHECK(line.attributes.at("y1") == "1.5");
  CHECK(line.attributes.at("x2") == "2.25");
  CHECK(line.attributes.at("y2") == "10000");
  CHECK(select(elements, "circle", "c").at(0).attributes.at("r") == "3");
  CHECK(select(elements, "rect", "b").at(0).attributes.at("rx") == "5");
  CHECK(select(elements, "polygon", "p").at(0).attributes.at("points") == "0,0 1,0 0,1");
}

TEST_CASE("a polygon of two corners is left out") {
  Svg svg("", "");
  svg.polygon({{0, 0}, {1, 0}}, "p");
  CHECK(select(read_svg(svg.finish(1, 1)), "polygon", "p").empty());
}

TEST_CASE("text is broken at blanks into lines that fit, none of it lost") {
  const std::string text = "the quick brown fox jumps over the lazy dog";
  const auto lines = wrapped(text, {12}, 100);
  CHECK(lines.size() > 2);
  std::string joined;
  for (const std::string& line : lines) {
    CHECK(text_width(line, {12}) <= 100);
    joined += (joined.empty() ? "" : " ") + line;
  }
  CHECK(joined == text);
}

TEST_CASE("a word that is too long is cut") {
  const auto lines = wrapped("wwwwwwwwwwwwwwwwwwww", {12}, 50);
  CHECK(lines.size() > 3);
  for (const std::string& line : lines) CHECK(text_width(line, {12}) <= 50);
  CHECK(wrapped("", {12}, 50).empty());
}

TEST_CASE("the reader of these tests refuses what is not well-formed") {
  const std::string head = "<?xml version=\"1.0\"?>\n";
  for (const char* bad : {"<a><b></a></b>", "<a>", "<a/><b/>", "<a b=c/>", "<a b=\"1\" b=\"2\"/>",
                          "<a b=\"<\">", ""}) {
    CAPTURE(bad);
    CHECK_THROWS(read_svg(head + bad));
  }
  CHECK(read_svg(head + "<a b=\"1\"><c/>x&lt;</a>\n").at(0).text == "x<");
}
