#include <algorithm>

#include <catch2/catch.hpp>

#include "report/picture/drawing.hpp"
#include "report/picture/pictures.hpp"
#include "support/run_program.hpp"
#include "unit/report/sample.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// Characters, not bytes.
std::size_t width_of(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

PairCase apart(float distance) {
  PairCase pair = box_on_box(0.25F);
  pair.b.pose.position = {distance, 0};
  return pair;
}

}  // namespace

TEST_CASE("dots lie in their cells, marks over them, and lines end with the last one") {
  DotCanvas canvas(3, 2);
  canvas.dot(0, 0);
  canvas.dot(3, 3);
  canvas.mark({0, 5}, 'x');
  canvas.dot(-1, 0);
  canvas.dot(6, 0);
  CHECK(canvas.text() == "⠁⢀\nx\n");
  CHECK(canvas.mark_at({1, 6}) == 'x');
  DotCanvas lines(2, 1);
  lines.line({0, 0}, {3, 0}, 1);
  lines.line({0, 3}, {3, 3}, 2);
  CHECK(lines.text() == "⡉⡉\n");
}

TEST_CASE("a box below a box") {
  CHECK(text_picture(judged_case(box_on_box(0.25F))) == R"(⡏⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⢹
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀A⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀*⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡*⠀⠀⠀⠀⠀⠀⠀⢸
⡇⠀⠀⠀⠀⠀⠀⠀⠨⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⠡⡂⠀⠀⠀⠀⠀⠀⠀⢸
⠓⠒⠒⠒⠒⠒⠒⠒⠺⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⠓⡒⠒⠒⠒⠒⠒⠒⠒⠚
⠀⠀⠀⠀⠀⠀⠀⠀⠨⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⡂
⠀⠀⠀⠀⠀⠀⠀⠀⠨⠀⠀⠀⠀⠀⠀⠀⠀B⠀⠀⠀⠀⠀⠀⠀⠀⡂
⠀⠀⠀⠀⠀⠀⠀⠀⠨⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⡂
⠀⠀⠀⠀⠀⠀⠀⠀⠨⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⡂
⠀⠀⠀⠀⠀⠀⠀⠀⠨⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⡂
⠀⠀⠀⠀⠀⠀⠀⠀⢨⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⢀⡂

A solid, B dotted, overlap filled; a character is 0.05789 wide
+ right: overlap 0.25
S clip: 2 points, depths 0.25 and 0.25
O box2d: 2 points, depths 0.25 and 0.25
* several of these
)");
}

TEST_CASE("no picture is wider than 76 characters but for its legend, or longer than 46 lines") {
  PairCase sliver = box_on_box(0.25F);
  sliver.b.polygon = box_polygon(1e-7F, 10);
  PairCase far = box_on_box(0.25F);
  far.a.pose.position += Vector2<float>(1e8F, 1e8F);
  far.b.pose.position += Vector2<float>(1e8F, 1e8F);
  PairCase huge = box_on_box(0.25F);
  huge.a.polygon = box_polygon(1e30F, 1e30F);
  PairCase tiny = box_on_box(0.25F);
  tiny.a.polygon = box_polygon(1e-30F, 1e-30F);
  tiny.b.polygon = tiny.a.polygon;
  tiny.b.pose.position = {1e-30F, 0};
  std::vector<PairCase> pairs{
      sliver, far, huge, tiny, apart(1e8F), apart(3e38F), box_on_box(1e-6F, 5)};
  for (const Regime& regime : regimes()) {
    for (std::uint64_t i = 0; i < 5; ++i) pairs.push_back(generate(1, regime, i, {}));
  }
  for (const PairCase& pair : pairs) {
    std::string line;
    append_case_line(line, pair);
    CAPTURE(line);
    const std::string picture = text_picture(judged_case(pair));
    const std::vector<std::string> lines = lines_of(picture);
    CHECK(lines.size() <= 46);
    bool is_legend = false;
    for (const std::string& drawn : lines) {
      is_legend = is_legend || drawn.starts_with("A solid, B dotted");
      if (!is_legend) CHECK(width_of(drawn) <= 76);
    }
    CHECK(is_legend);
  }
}

TEST_CASE("what is too small to be seen is shown again, closer") {
  CHECK_THAT(text_picture(judged_case(box_on_box(1e-4F))), Contains("times closer:\n"));
  CHECK_THAT(text_picture(judged_case(box_on_box(0.25F))), !Contains("times closer:\n"));
}

TEST_CASE("answers that are missing or absurd leave a picture of the polygons") {
  const PairCase pair = box_on_box(0.25F);
  const Declaration declaration{"mine", "1", ""};
  Manifold<double> absurd;
  absurd.count = 2;
  absurd.points[0].position = {1e300, -1e300};
  absurd.points[1].position = {std::nan(""), 0};
  const std::vector<Answer> answers{Lost{Lost::How::crashed, "died"}, Unsupported{"why"}, absurd};
  for (const Answer& answer : answers) {
    const DeclaredAnswer asked{declaration, answer};
    CHECK_THAT(text_picture(pair, {&asked, 1}), Contains("S mine: "));
  }
}
