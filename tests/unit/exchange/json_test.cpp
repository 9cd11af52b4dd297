#include "base/json.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/random.hpp"
#include "base/text.hpp"
#include "corpus/corpus.hpp"
#include "support/bad_cases.hpp"
#include "support/run_program.hpp"

using namespace manifuzz;

namespace {

template <class Scalar>
std::string written(Scalar value) {
  std::string text;
  append_number(text, value);
  return text;
}

float read_back(float value) {
  const JsonTree tree = parse_json(written(value));
  return JsonView(tree).number_as_float();
}

PairCase read_pair(const std::string& text) {
  return parse_case(text, FormatKey::optional).pair();
}

std::string complaint_about(const std::string& text) {
  try {
    parse_case(text, FormatKey::optional);
  } catch (const UserError& error) {
    return error.what();
  }
  return "nothing was wrong";
}

/// A pair whose A stands rotated and away from the origin, and a manifold on it.
PairCase turned_pair() {
  PairCase pair = read_pair(test::good_case());
  pair.a.pose = {{3, -2}, {0.6F, 0.8F}};
  return pair;
}

Manifold<double> sample_manifold() {
  Manifold<double> manifold;
  manifold.count = 2;
  manifold.reference = Side::b;
  manifold.normal = {0.8, -0.6};
  manifold.points[0] = {{0.1, 0.2}, 0.3, {{Feature::Kind::vertex, 3}, {Feature::Kind::face, 0}}};
  manifold.points[1] = {
      {1.0 / 3, -7e-9}, 0, {{Feature::Kind::face, 2}, {Feature::Kind::vertex, 1}}};
  return manifold;
}

NamedAnswer read_back(const PairCase& pair, const Answer& answer) {
  std::string line;
  append_answer(line, pair, "clip", answer);
  const JsonTree tree = parse_json(line);
  return read_recorded_answer(JsonView(tree), pair);
}

}  // namespace

TEST_CASE("every bad case is refused in a line that names the place", "[bad-input]") {
  for (const test::BadCase& row : test::bad_cases()) {
    if (row.complaint == "1 MiB") continue;  // who splits lines and files looks after their length
    const std::string complaint = complaint_about(row.text);
    CAPTURE(row.name, complaint);
    CHECK(complaint.find(row.complaint) != std::string::npos);
    CHECK(test::is_one_clear_line(complaint + "\n"));
    CHECK(complaint.size() < 600);
  }
}

TEST_CASE("Floats are written so that they read back bit for bit") {
  const float special[] = {
      0.F,
      -0.F,
      1.F,
      0.1F,
      7.038531e-26F,  // its shortest decimal, by way of double, is another float
      std::numeric_limits<float>::denorm_min(),
      std::numeric_limits<float>::min(),
      std::numeric_limits<float>::max(),
      16777216.F};
  for (const float value : special) {
    CHECK(std::bit_cast<std::uint32_t>(read_back(value)) == std::bit_cast<std::uint32_t>(value));
  }
  Random random(1, "floats", 0);
  int wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random.bits()));
    if (!std::isfinite(value)) continue;
    if (std::bit_cast<std::uint32_t>(read_back(value)) != std::bit_cast<std::uint32_t>(value))
      ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("Numbers are written shortest") {
  CHECK(written(0.1F) == "0.1");
  CHECK(written(1.F) == "1");
  CHECK(written(-0.F) == "-0.0");
  CHECK(written(7.038531e-26F) != "7.038531e-26");
  CHECK(written(0.1) == "0.1");
  CHECK(written(static_cast<double>(0.1F)) == "0.10000000149011612");
  CHECK(written(std::numeric_limits<double>::infinity()) == "null");
  CHECK(written(std::numeric_limits<double>::quiet_NaN()) == "null");
}

TEST_CASE("Decimals become the nearest double, then the nearest float") {
  const auto x_of = [](const std::string& number) {
    return read_pair(R"({"a": {"vertices": [[0,0],[1,0],[0,1]], "position": [)" + number +
                     R"(,0]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}})")
        .a.pose.position.x();
  };
  CHECK(x_of("0.1") == 0.1F);
  CHECK(x_of("1E-1") == 0.1F);
  CHECK(x_of("7.038531e-26") == static_cast<float>(7.038531e-26));
  CHECK(x_of("7.038531e-26") != 7.038531e-26F);
  CHECK(x_of("3.4028235677973362e38") == std::numeric_limits<float>::max());
  CHECK(x_of("18446744073709551617") == 0x1p64F);
  CHECK(x_of("1e-999") == 0);
  CHECK(std::signbit(x_of("-0")));
  CHECK(std::signbit(x_of("-0.0")));
  CHECK(!std::signbit(x_of("0")));
}

TEST_CASE("A pair case is read with its defaults") {
  const PairCase pair = read_pair(test::good_case());
  CHECK(pair.a.polygon.count == 4);
  CHECK(pair.a.polygon.vertices[3] == Vector2<float>(-1, 1));
  CHECK(pair.a.polygon.normals[0] == Vector2<float>(0, -1));
  CHECK(pair.a.polygon.radius == 0);
  CHECK(pair.a.pose == Pose<float>());
  CHECK(pair.b.polygon.count == 3);
  CHECK(pair.b.pose.position == Vector2<float>(0.5F, 0.75F));
}

TEST_CASE("White space, line ends of Windows and a byte order mark are free") {
  const PairCase pair = read_pair(test::good_case());
  std::string spread;
  for (const char c : test::good_case()) {
    spread += c;
    if (c == ',' || c == '[' || c == '}') spread += " \t\r\n";
  }
  CHECK(read_pair(spread) == pair);
  CHECK(read_pair(test::good_case() + "\r") == pair);
  CHECK(read_pair("\xef\xbb\xbf" + test::good_case()) == pair);
}

TEST_CASE("The format may be left out where it is optional alone") {
  const std::string text =
      R"({"a": {"vertices": [[0,0],[1,0],[0,1]]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}})";
  CHECK_NOTHROW(parse_case(text, FormatKey::optional));
  CHECK_THROWS_WITH(parse_case(text, FormatKey::required),
                    Catch::Contains("\"format\" is missing"));
}

TEST_CASE("Errors of spread text name line and column") {
  CHECK(complaint_about("{\n  \"a\": x").starts_with("line 2, column 8: not JSON"));
  CHECK(complaint_about("[NaN").starts_with("column 2: not JSON"));
}

TEST_CASE("A case line has the keys of the format in order and reads back equal") {
  PairCase pair = turned_pair();
  pair.b.polygon.radius = 0.1F;
  std::string line;
  append_case_line(line, pair);
  CHECK(
      line ==
      R"({"format": "manifuzz/case/1", "a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "radius": 0, )"
      R"("position": [3,-2], "rotation": [0.6,0.8]}, "b": {"vertices": [[0,0],[2,0],[1,2]], )"
      R"("radius": 0.1, "position": [0.5,0.75], "rotation": [1,0]}})");
  CHECK(read_pair(line) == pair);
}

TEST_CASE("A line to a program has the same values whether its numbers are doubles or floats") {
  PairCase pair = turned_pair();
  pair.a.polygon.radius = 0.1F;
  pair.b.pose.position = {0.3F, -1e-7F};
  for (const ScalarType scalar : {ScalarType::float32, ScalarType::float64}) {
    std::string line;
    append_program_line(line, pair, scalar);
    const nlohmann::json json = nlohmann::json::parse(line);
    CHECK(json["a"]["radius"].get<double>() == static_cast<double>(0.1F));
    CHECK(json["b"]["position"][0].get<double>() == static_cast<double>(0.3F));
    CHECK(json["b"]["position"][1].get<double>() == static_cast<double>(-1e-7F));
    CHECK(json["a"]["rotation"][0].get<double>() == static_cast<double>(0.6F));
    CHECK(read_pair(line) == pair);
  }
}

TEST_CASE("A line to a program has normals in the scalar that it declares, and a point has none") {
  const PairCase pair = turned_pair();
  for (const ScalarType scalar : {ScalarType::float32, ScalarType::float64}) {
    std::string line;
    append_program_line(line, pair, scalar);
    const nlohmann::json json = nlohmann::json::parse(line);
    for (const Side side : {Side::a, Side::b}) {
      const auto& polygon = pair[side].polygon;
      const auto in_double = polygon_cast<double>(polygon);
      const auto& normals = json[side == Side::a ? "a" : "b"]["normals"];
      REQUIRE(normals.size() == static_cast<std::size_t>(polygon.count));
      for (int i = 0; i < polygon.count; ++i) {
        const double expected = scalar == ScalarType::float64
                                    ? in_double.normals[i].x()
                                    : static_cast<double>(polygon.normals[i].x());
        CHECK(normals[static_cast<std::size_t>(i)][0].get<double>() == expected);
      }
    }
  }
  PairCase circle = pair;
  const std::array<Vector2<float>, 1> centre{Vector2<float>{1, 2}};
  circle.b.polygon = make_polygon<float>(centre, 0.5F);
  std::string line;
  append_program_line(line, circle, ScalarType::float64);
  CHECK_THAT(line, Catch::Contains("\"normals\": []}"));
  CHECK(read_pair(line) == circle);
}

TEST_CASE("Normals that are not the polygon's own are refused") {
  std::string line;
  append_program_line(line, turned_pair(), ScalarType::float64);
  const std::size_t at = line.find("\"normals\": [[") + 13;
  CHECK_THAT(complaint_about(std::string(line).insert(at, "7")),
             Catch::Contains("a.normals[0]") && Catch::Contains("is not the outward unit normal"));
}

TEST_CASE("A manifold line is in world coordinates, its local points in A's frame") {
  PairCase pair = read_pair(test::good_case());
  pair.a.pose = {{3, -2}, {0, 1}};
  Manifold<double> manifold = sample_manifold();
  manifold.normal = {0, -1};
  manifold.points[1].position = {0.5, -7e-9};
  std::string line;
  append_answer(line, pair, "clip", manifold);
  CHECK(
      line ==
      R"({"collider": "clip", "normal": [1,0], "reference": "b", "points": [)"
      R"({"position": [2.8,-1.9], "local": [0.1,0.2], "depth": 0.3, "features": ["v3","f0"]}, )"
      R"({"position": [3.000000007,-1.5], "local": [0.5,-7e-09], "depth": 0, "features": ["f2","v1"]}]})");
}

TEST_CASE("Answers without points are short") {
  const PairCase pair = turned_pair();
  std::string line;
  append_answer(line, pair, "clip", Manifold<double>());
  CHECK(line == R"({"collider": "clip", "points": []})");
  line.clear();
  append_answer(line, pair, "odd \"name\"", Unsupported{"9 vertices"});
  CHECK(line == R"({"collider": "odd \"name\"", "unsupported": "9 vertices"})");
}

TEST_CASE("Answers read back") {
  const PairCase pair = turned_pair();
  const Manifold<double> manifold = sample_manifold();
  const NamedAnswer answer = read_back(pair, manifold);
  const auto& read = std::get<Manifold<double>>(answer.answer);
  CHECK(answer.collider == "clip");
  CHECK(read.count == 2);
  CHECK(read.reference == Side::b);
  CHECK(read.points == manifold.points);
  CHECK((read.normal - manifold.normal).norm() < 1e-15);
  CHECK(std::get<Manifold<double>>(read_back(pair, Manifold<double>()).answer).count == 0);
  CHECK(std::get<Unsupported>(read_back(pair, Unsupported{"why"}).answer).why == "why");
}

TEST_CASE("A normal that is not unit is recorded and read as it is") {
  PairCase pair = turned_pair();
  pair.a.pose.rotation = {0.600003F, 0.800003F};
  Manifold<double> manifold = sample_manifold();
  manifold.normal *= 3;
  const NamedAnswer answer = read_back(pair, manifold);
  const auto& read = std::get<Manifold<double>>(answer.answer);
  CHECK((read.normal - manifold.normal).norm() < 1e-15);
}

TEST_CASE("An answer that is not finite is recorded as null and read as NaN") {
  Manifold<double> manifold = sample_manifold();
  manifold.points[0].depth = std::numeric_limits<double>::infinity();
  const NamedAnswer answer = read_back(turned_pair(), manifold);
  CHECK(std::isnan(std::get<Manifold<double>>(answer.answer).points[0].depth));
}

TEST_CASE("Garbage is escaped and shortened before it is shown") {
  CHECK(printable("plain") == "plain");
  CHECK(printable("\x1b[31m\n\xff") == "\\x1b[31m\\x0a\\xff");
  CHECK(printable(std::string(100, 'x'), 10) == "xxxxxxxxxx...");
}
