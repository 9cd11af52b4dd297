#include <algorithm>
#include <numbers>

#include <catch2/catch.hpp>

#include "report/picture/pictures.hpp"
#include "report/words.hpp"
#include "unit/report/sample.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

ConvexPolygon<float> circle(float radius) {
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  return make_polygon<float>(center, radius);
}

ConvexPolygon<float> capsule(float half_length, float radius) {
  const std::array ends{Vector2<float>(-half_length, 0), Vector2<float>(half_length, 0)};
  return make_polygon<float>(ends, radius);
}

/// A shape at the origin, and another one so far below it.
PairCase one_below_another(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                           float below) {
  PairCase pair{{a, {}}, {b, {}}};
  pair.b.pose.position = {0, -below};
  return pair;
}

std::vector<Element> picture_of(const PairCase& pair) {
  return read_svg(case_svg(judged_case(pair)));
}

std::ptrdiff_t arcs_of(const Element& path) {
  return std::ranges::count(path.attributes.at("d"), 'A');
}

}  // namespace

TEST_CASE("a circle is two arcs, a capsule has one at each end") {
  const auto elements = picture_of(one_below_another(circle(1), capsule(1, 0.5F), 1.25F));
  CHECK(arcs_of(select(elements, "path", "fill a").at(0)) == 2);
  CHECK(arcs_of(select(elements, "path", "fill b").at(0)) == 2);
  CHECK(arcs_of(select(elements, "path", "skin b").at(0)) == 2);
  CHECK(select(elements, "polygon", "overlap").size() == 1);
}

TEST_CASE("round corners are arcs, and mitred skins have none") {
  PairCase pair = box_on_box(0.25F, 0.5F);
  CHECK(arcs_of(select(picture_of(pair), "path", "skin a").at(0)) == 0);
  CHECK(select(picture_of(pair), "path", "skin b").empty());
  pair.a.polygon.rounding = Rounding::round;
  CHECK(arcs_of(select(picture_of(pair), "path", "skin a").at(0)) == 4);
}

TEST_CASE("the area between arcs is that of the shape, whatever it is") {
  constexpr double pi = std::numbers::pi;
  const Box everything{-100, -100, 200, 200};
  const auto area = [&](const ConvexPolygon<float>& shape, Rounding corners) {
    const PairCase pair = one_below_another(shape, circle(1), 9);
    const Rim rim = rim_of(exact::place_roughly(pair).a, shape.radius, corners);
    const Region region = region_of(rim, everything, 1e-6);
    double twice = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
      twice += cross<double>(region[i], region[(i + 1) % region.size()]);
    }
    return twice / 2;
  };
  CHECK(area(circle(2), Rounding::round) == Approx(4 * pi).epsilon(1e-5));
  CHECK(area(capsule(1, 0.5F), Rounding::round) == Approx(2 + pi / 4).epsilon(1e-5));
  CHECK(area(box_polygon(1, 1, 0.5F), Rounding::round) == Approx(8 + pi / 4).epsilon(1e-5));
  CHECK(area(box_polygon(1, 1, 0.5F), Rounding::mitre) == Approx(9));
}

TEST_CASE("the depth of round shapes is drawn from the contact point, which is on a surface") {
  const auto judged = judged_case(one_below_another(box_polygon(1, 1), circle(0.5F), 1.25F));
  const auto elements = read_svg(case_svg(judged));
  const Element mark = select(elements, "circle", "mark-subject").at(0);
  const Element bar = select(elements, "line", "bar subject").at(0);
  CHECK(mark.number("cy") == Approx(bar.number("y1")).margin(0.02));
  // From the circle's top down to A's lower face.
  const Box a = [&] {
    const Element edge = select(elements, "line", "reference").at(0);
    return Box{edge.number("x1"), edge.number("y1")};
  }();
  CHECK(bar.number("y2") == Approx(a.y).margin(0.02));
  CHECK(bar.number("y1") < bar.number("y2"));
}

TEST_CASE("where cores are nearest at a vertex, that is the reference") {
  const auto elements = picture_of(one_below_another(circle(1), circle(0.5F), 1.25F));
  CHECK_THAT(all_text(elements), Contains("Cores 1.25 apart at A vertex 0"));
  CHECK_THAT(all_text(elements), Contains("reference (A vertex 0)"));
  CHECK_THAT(all_text(elements), Contains("A: circle, radius 1,"));
}

TEST_CASE("the curve's picture draws circles") {
  const auto judged = judged_case(one_below_another(circle(1), capsule(1, 0.5F), 1.25F));
  const auto elements = read_svg(curve_svg(judged));
  CHECK(arcs_of(select(elements, "path", "fill a").at(0)) == 2);
  CHECK(arcs_of(select(elements, "path", "fill b").at(0)) == 2);
  CHECK_THAT(all_text(elements), Contains("least 0.25"));
}

TEST_CASE("shapes have names by their vertices and radius") {
  CHECK(shape_in_words(circle(0.5F)) == "circle, radius 0.5");
  CHECK(shape_in_words(capsule(1, 0.5F)) == "capsule, radius 0.5");
  CHECK(shape_in_words(capsule(1, 0)) == "segment");
  CHECK(shape_in_words(box_polygon(1, 1)) == "4 vertices");
  CHECK(shape_in_words(box_polygon(1, 1, 0.5F)) == "4 vertices, radius 0.5");
  ConvexPolygon<float> round = box_polygon(1, 1, 0.5F);
  round.rounding = Rounding::round;
  CHECK(shape_in_words(round) == "4 vertices, radius 0.5, round corners");
}
