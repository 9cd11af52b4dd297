#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/kept_json.hpp"
#include "external/external_collider.hpp"

namespace manifuzz {
namespace {

/// One of two words, the first of which is what is meant where there is none.
template <class Choice>
Choice choice_in(const JsonView& object, std::string_view key,
                 std::initializer_list<std::string_view> names) {
  const auto value = object.find(key);
  if (!value) return Choice{};
  const auto* const found = std::ranges::find(names, value->string());
  if (found == names.end()) {
    value->fail(fmt::format("\"{}\" is expected", fmt::join(names, "\" or \"")));
  }
  return static_cast<Choice>(found - names.begin());
}

bool flag_in(const JsonView& object, std::string_view key, bool usual) {
  const auto value = object.find(key);
  return value ? value->boolean() : usual;
}

double number_in(const JsonView& object, std::string_view key) {
  const auto value = object.find(key);
  return value ? value->number() : 0;
}

int vertices_max_in(const JsonView& object) {
  const auto value = object.find("vertices_max");
  if (!value) return kMaxVertices;
  if (value->whole_number() < 3) value->fail("3 or more is expected");
  return static_cast<int>(std::min<std::uint64_t>(value->whole_number(), kMaxVertices));
}

/// "clip", "never", or an angle in radians.
SecondPoint second_point_in(const JsonView& value) {
  if (!value.is_string()) {
    const double angle = value.number();
    if (!(angle >= 0 && angle <= std::numbers::pi / 2)) {
      value.fail(fmt::format("{} is not a valid angle; one from 0 to pi / 2 is expected", angle));
    }
    return SecondPoint::within(angle);
  }
  const std::string_view word = value.string();
  if (word != "clip" && word != "never") {
    value.fail(fmt::format("'{}' is unknown; \"clip\", \"never\" or an angle is", printable(word)));
  }
  return word == "never" ? SecondPoint::never() : SecondPoint{};
}

/// 3 or more, unless it says what it does with curved shapes.
int vertices_min_in(const JsonView& object) {
  const auto value = object.find("vertices_min");
  if (!value) return object.find("second_point") ? 1 : kMinVertices;
  if (value->whole_number() < 1 || value->whole_number() > kMinVertices) {
    value->fail("1, 2 or 3 is expected");
  }
  return static_cast<int>(value->whole_number());
}

ShapeFamily family_in(const JsonView& value) {
  const auto* const found = std::ranges::find(kShapeFamilyNames, value.string());
  if (found == kShapeFamilyNames.end()) {
    value.fail(fmt::format("\"{}\" is expected", fmt::join(kShapeFamilyNames, "\" or \"")));
  }
  return static_cast<ShapeFamily>(found - kShapeFamilyNames.begin());
}

std::vector<std::array<ShapeFamily, 2>> declines_in(const JsonView& object) {
  std::vector<std::array<ShapeFamily, 2>> declines;
  const auto value = object.find("declines");
  if (!value) return declines;
  for (const JsonView& pair : value->elements()) {
    const auto both = pair.elements();
    if (both.size() != 2) pair.fail("two families of shapes are expected");
    declines.push_back({family_in(both[0]), family_in(both[1])});
  }
  return declines;
}

LeastPolygon least_polygon_in(const JsonView& object) {
  const auto least = object.find("least_polygon");
  if (!least) return {};
  least->expect_keys({"turn", "area"});
  return {number_in(*least, "turn"), number_in(*least, "area")};
}

/// What is left out is taken to be the least that a collider can promise: float, in the world.
Declaration read_declaration(const JsonView& object, const std::string& usual_name) {
  object.expect_keys({"name",          "version",          "scalar",       "frame",
                      "tie_bias",      "vertices_max",     "takes_radius", "points",
                      "normal",        "snippet",          "claims",       "clips",
                      "depths",        "one_point_enough", "speculative",  "least_depth",
                      "rotation",      "alters_shapes",    "tolerance",    "vertices_min",
                      "takes_round",   "second_point",     "keeping",      "declines",
                      "least_polygon", "normals"});
  const auto bias = object.find("tie_bias");
  const auto tolerance = object.find("tolerance");
  const auto second_point = object.find("second_point");
  if (tolerance) tolerance->expect_keys({"absolute", "relative", "source"});
  return {
      .name = object.string_or("name", usual_name),
      .version = object.string_or("version", "unknown"),
      .description = "a program",
      .scalar = choice_in<ScalarType>(object, "scalar", {"float32", "float64"}),
      .frame = choice_in<bool>(object, "frame", {"world", "local"}) ? RoundingFrame::local
                                                                    : RoundingFrame::world,
      .takes_angles = choice_in<bool>(object, "rotation", {"matrix", "angle"}),
      .normals = choice_in<NormalsFrom>(object, "normals", {"given", "vertices", "world_vertices"}),
      .tie_bias = bias ? read_tie_bias(*bias) : TieBias{},
      .max_vertices = vertices_max_in(object),
      .takes_radius = flag_in(object, "takes_radius", true),
      .min_vertices = vertices_min_in(object),
      .takes_round = flag_in(object, "takes_round", second_point.has_value()),
      .least_polygon = least_polygon_in(object),
      .declines = declines_in(object),
      .second_point = second_point ? second_point_in(*second_point) : SecondPoint{},
      .claims =
          choice_in<Claims>(object, "claims", {"manifold", "point", "separation", "touching"}),
      .clips = flag_in(object, "clips", true),
      .points = choice_in<PointsAt>(object, "points",
                                    {"clip", "midpoint", "vertex", "surface_a", "surface_b"}),
      .shares_depth = choice_in<bool>(object, "depths", {"point", "shared"}),
      .one_point_enough = flag_in(object, "one_point_enough", false),
      .speculative = number_in(object, "speculative"),
      .least_depth = number_in(object, "least_depth"),
      .alters_shapes = flag_in(object, "alters_shapes", false),
      .tolerance = tolerance ? Tolerance{number_in(*tolerance, "absolute"),
                                         number_in(*tolerance, "relative")}
                             : Tolerance{},
      .tolerance_source = tolerance ? tolerance->string_or("source", "") : "",
      .normal_from_b = choice_in<bool>(object, "normal", {"a_to_b", "b_to_a"}),
      .snippet = object.string_or("snippet", "")};
}

/// "planck" of "node scripts/planck.mjs --fast".
std::string name_in(const std::string& command) {
  std::string name;
  std::size_t start = 0;
  while (start < command.size()) {
    const std::size_t end = std::min(command.find(' ', start), command.size());
    const std::string word = command.substr(start, end - start);
    if (!word.empty() && word.front() != '-') name = word;
    start = end + 1;
  }
  name = name.substr(name.rfind('/') + 1);  // npos + 1 is 0
  name = name.substr(0, name.find('.'));
  return is_collider_name(name) ? name : "command";
}

}  // namespace

PairCase overlapping_boxes() {
  const std::array<Vector2<float>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  PairCase pair{{make_polygon<float>(corners), {}}, {make_polygon<float>(corners), {}}};
  pair.b.pose.position = {1.5F, 0.25F};
  return pair;
}

ProgramDeclaration program_declaration(const std::string& command, const std::string& line) {
  const JsonTree tree = parse_json(line.empty() ? "{\"declaration\": {}}" : line);
  try {
    const JsonView object = JsonView(tree).at("declaration");
    ProgramDeclaration read{.declaration = read_declaration(object, name_in(command)),
                            .keeping = {}};
    check_declaration(read.declaration, "$.declaration.");
    if (const auto keeping = object.find("keeping")) read.keeping = read_keeping(*keeping);
    return read;
  } catch (const UserError& error) {
    throw UserError(fmt::format("'{}' declares: {}", printable(command, 200), error.what()));
  }
}

}  // namespace manifuzz
