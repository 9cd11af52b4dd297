#include <catch2/catch.hpp>

#include "report/picture/drawing.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

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
