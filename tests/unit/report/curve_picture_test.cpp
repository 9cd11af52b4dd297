#include <catch2/catch.hpp>

#include "report/picture/pictures.hpp"
#include "support/named_tests.hpp"
#include "unit/report/sample.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

Point center_of(const Element& circle) {
  return {circle.number("cx"), circle.number("cy")};
}

/// The rings of the plot; the last one is the legend's.
std::vector<Element> rings_of(const std::vector<Element>& elements) {
  auto rings = select(elements, "circle", "ring");
  rings.pop_back();
  return rings;
}

/// Whether the subject's mark, the first of two, stands in a ring.
bool is_in_ring(const std::vector<Element>& elements) {
  const auto marks = select(elements, "circle", "mark-subject");
  return marks.size() == 2 && std::ranges::any_of(rings_of(elements), [&](const Element& ring) {
           return length(center_of(ring) - center_of(marks.front())) < 1;
         });
}

/// A box that overlaps another by a quarter from above, the subject's answer changed.
template <class Change>
std::vector<Element> curve_with(const Change& change) {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  change(std::get<Manifold<double>>(judged.subject.answer));
  return read_svg(curve_svg(judged));
}

[[maybe_unused]] const bool curves_registered = [] {
  for (const Regime& regime : regimes()) {
    add_test("curves of the regime " + std::string(regime.name), "[picture]", [&regime] {
      for (std::uint64_t index = 0; index < 50; ++index) {
        CAPTURE(index);
        const std::string svg = curve_svg(judged_case(generate(1, regime, index)));
        check_numbers(svg);
        const auto elements = read_svg(svg);
        check_layout(elements);
        CHECK(!rings_of(elements).empty());
      }
    });
  }
  return true;
}();

}  // namespace

TEST_CASE("a right answer stands in the ring") {
  const auto elements = curve_with([](const Manifold<double>&) {});
  CHECK(rings_of(elements).size() == 1);
  CHECK(is_in_ring(elements));
  CHECK_THAT(all_text(elements), Contains("depth 0.25 along (0, -1)"));
}

TEST_CASE("depths that tie have a ring each, and a right answer stands in one of them") {
  PairCase pair = box_on_box(0.25F);
  pair.b.pose.position = {1.25F, -1.25F};
  const auto elements = read_svg(curve_svg(judged_case(pair)));
  CHECK(rings_of(elements).size() == 2);
  CHECK(is_in_ring(elements));
  CHECK_THAT(all_text(elements), Contains("which tie"));
}

TEST_CASE("a reversed normal and a wrong depth stand outside the ring") {
  const auto reversed = curve_with([](Manifold<double>& m) { m.normal = -m.normal; });
  CHECK_FALSE(is_in_ring(reversed));
  CHECK_THAT(all_text(reversed), Contains("where they overlap by 2.75"));
  CHECK_FALSE(is_in_ring(curve_with([](Manifold<double>& m) { m.points[0].depth = 1; })));
}

TEST_CASE("an answer without a contact has no mark in the plot, and is told") {
  const auto elements = curve_with([](Manifold<double>& m) { m.count = 0; });
  CHECK(select(elements, "circle", "mark-subject").size() == 1);
  CHECK_THAT(all_text(elements), Contains("clip: no contact"));
}
