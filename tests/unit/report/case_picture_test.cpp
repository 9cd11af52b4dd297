#include <limits>
#include <sstream>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/pictures.hpp"
#include "report/words.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"
#include "unit/report/sample.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

constexpr std::uint64_t kCasesOfRegime = 200;

/// The text that the picture is expected to hold, broken into lines or not.
bool holds(const std::vector<Element>& elements, std::string_view expected) {
  std::string joined;
  for (const char c : all_text(elements)) joined += c == '\n' ? ' ' : c;
  return joined.find(expected) != std::string::npos;
}

/// The bounds of an upright box that is drawn as a polygon.
Box bounds_of(const Element& polygon) {
  std::istringstream corners(polygon.attributes.at("points"));
  Point low(1e9, 1e9);
  Point high(-1e9, -1e9);
  char comma = 0;
  for (Point corner; corners >> corner.x() >> comma >> corner.y();) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

void check_words(const JudgedCase& judged, const std::vector<Element>& elements) {
  CHECK(holds(elements, verdict_sentence(judged)));
  for (const DeclaredAnswer* asked : {&judged.subject, &judged.oracle}) {
    CHECK(holds(elements, asked->declaration.name + " " + asked->declaration.version));
    CHECK(holds(elements, answer_in_words(*asked)));
  }
  const Admissible right = admissible(judged.given.pair(), judged.subject.declaration);
  const exact::Clip* const candidate = candidate_to_show(right, judged.subject);
  if (candidate == nullptr) return;
  const Side side = candidate->reference.side;
  CHECK(holds(elements, "reference (" + face_name(side, candidate->reference.index) + ")"));
  CHECK(holds(elements, "incident (" + face_name(other(side), candidate->incident) + ")"));
}

void check_picture(const JudgedCase& judged) {
  const std::string svg = case_svg(judged);
  check_numbers(svg);
  const auto elements = read_svg(svg);
  check_layout(elements);
  check_words(judged, elements);
}

[[maybe_unused]] const bool registered = [] {
  for (const Regime& regime : regimes()) {
    add_test("pictures of the regime " + std::string(regime.name), "[picture]", [&regime] {
      for (std::uint64_t index = 0; index < kCasesOfRegime; ++index) {
        CAPTURE(index);
        check_picture(judged_case(generate(1, regime, index)));
      }
    });
  }
  return true;
}();

}  // namespace

TEST_CASE("a picture shows both colliders' points with their depths") {
  const auto elements = read_svg(case_svg(judged_case(box_on_box(0.25F))));
  CHECK(select(elements, "circle", "mark-subject").size() == 3);  // one in the legend
  CHECK(select(elements, "rect", "mark-oracle").size() == 3);
  CHECK(select(elements, "line", "bar subject").size() == 4);  // and a tick each
  CHECK(select(elements, "polygon", "overlap").size() == 1);
  CHECK_THAT(all_text(elements), Contains("depth 0.25 (clip, box2d)"));
}

TEST_CASE("points at one spot share a label, in which each collider stands once") {
  PairCase pair = box_on_box(0.25F);
  pair.b.polygon = box_polygon(1e-4F, 0.5F);
  const auto elements = read_svg(case_svg(judged_case(pair)));
  const std::string whole = select(elements, "text", "depth-word").at(0).text;
  CHECK(whole == "depth 0.25 (clip, box2d)");
}

TEST_CASE("polygons have their letters, and vertices their numbers") {
  const auto elements = read_svg(case_svg(judged_case(box_on_box(0.25F))));
  for (const std::string side : {"a", "b"}) {
    CHECK(select(elements, "text", "letter " + side).size() == 1);
    CHECK(select(elements, "text", "vertex " + side).size() == 4);
  }
}

TEST_CASE("labels of points near each other are stacked") {
  PairCase pair = box_on_box(0.25F);
  pair.b.polygon = box_polygon(0.05F, 0.5F);
  const auto elements = read_svg(case_svg(judged_case(pair)));
  CHECK(select(elements, "text", "depth-word").size() >= 2);
  check_layout(elements);
}

TEST_CASE("the overlap is drawn where it is") {
  const auto elements = read_svg(case_svg(judged_case(box_on_box(0.25F))));
  const Box a = bounds_of(select(elements, "polygon", "fill a").at(0));
  const Box b = bounds_of(select(elements, "polygon", "fill b").at(0));
  const Box overlap = bounds_of(select(elements, "polygon", "overlap").at(0));
  // The top of B, half as wide as A, lies above A's bottom; y grows downwards.
  CHECK(overlap.x == b.x);
  CHECK(overlap.width == b.width);
  CHECK(overlap.y == b.y);
  CHECK(overlap.bottom() == Approx(a.bottom()));
}

TEST_CASE("a depth too small to be seen gets a closer view") {
  const auto frames = [](float depth) {
    return select(read_svg(case_svg(judged_case(box_on_box(depth)))), "rect", "frame").size();
  };
  CHECK(frames(0.25F) == 1);
  CHECK(frames(1e-5F) == 2);
  CHECK(frames(-1e-5F) == 2);
}

TEST_CASE("an overlap much thinner than its depth gets a view of its own, if rounding leaves one") {
  const auto frames = [](const char* file) {
    const auto path = source_dir() / "corpus/defects/box2d" / file;
    const PairCase pair = read_case_file(path.string()).pair();
    return select(read_svg(case_svg(judged_case(pair))), "rect", "frame").size();
  };
  CHECK(frames("thin-overlap-box2d.json") == 3);
  CHECK(frames("oracle-known-missed_contact-none-a-gross-0103adb7.json") == 1);
}

TEST_CASE("polygons apart show the gap, and no contact") {
  const auto elements = read_svg(case_svg(judged_case(box_on_box(-0.5F))));
  CHECK(holds(elements, "gap 0.5"));
  CHECK(select(elements, "line", "incident").empty());
  CHECK(select(elements, "line", "bar truth").size() == 2);
}

TEST_CASE("rounded polygons have a dashed skin") {
  const auto elements = read_svg(case_svg(judged_case(box_on_box(-0.25F, 0.5F))));
  CHECK(select(elements, "path", "skin a").size() == 1);
  CHECK(select(elements, "path", "skin b").empty());
}

TEST_CASE("a ledger entry stands below the picture") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.judgement.explanation = &ledger().front();
  CHECK(holds(read_svg(case_svg(judged)), ledger().front().id));
}

TEST_CASE("answers that are nonsense make a picture all the same") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite, 1e300, -1e300}) {
    for (int i = 0; i < 4; ++i) {
      JudgedCase judged = judged_case(box_on_box(0.25F));
      Manifold<double> manifold = *judged.oracle.manifold();
      double* const places[] = {&manifold.points[0].position.x(), &manifold.points[0].depth,
                                &manifold.normal.x(), &manifold.points[1].position.y()};
      *places[i] = bad;
      judged.oracle.answer = manifold;
      CAPTURE(bad, i);
      check_layout(read_svg(case_svg(judged)));
    }
  }
  JudgedCase judged = judged_case(box_on_box(0.25F));
  Manifold<double> manifold = *judged.oracle.manifold();
  manifold.count = 1000;
  manifold.points[0].features.a.index = 200;
  manifold.normal = {0, 0};
  judged.oracle.answer = manifold;
  check_layout(read_svg(case_svg(judged)));
}

TEST_CASE("a collider that gave no answer is in the legend") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.oracle.answer = Lost{Lost::How::crashed, "crashed"};
  judged.judgement.bucket = bucket_of_lost(Verdict::crashed, Fault::oracle);
  check_picture(judged);
}

TEST_CASE("sizes and places that no picture was made for") {
  for (const float size : {1e-30F, 1e-6F, 1e6F, 1e15F}) {
    PairCase pair = box_on_box(0.25F);
    pair.a.polygon = box_polygon(size, size);
    pair.b.polygon = box_polygon(size / 2, size / 2);
    pair.b.pose.position = {0, -1.25F * size};
    CAPTURE(size);
    check_picture(judged_case(pair));
    pair.b.polygon = box_polygon(size * 1e-5F, size);
    check_picture(judged_case(pair));
  }
  PairCase far = box_on_box(0.25F);
  far.a.pose.position = {1e7F, -1e7F};
  far.b.pose.position = {1e7F, -10000001};
  check_picture(judged_case(far));
  CHECK(holds(read_svg(case_svg(judged_case(far))), "(1e+07,-1e+07)"));
}
