#include "exchange/json.hpp"

#include <charconv>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"

namespace manifuzz {
namespace {

Vector2<float> read_vector(const JsonView& array) {
  expect_two(array, "an array of two numbers");
  return {array[0].number_as_float(), array[1].number_as_float()};
}

Rounding read_rounding(const JsonView& name, std::size_t vertices) {
  const std::string_view rounding = name.string();
  if (rounding != "round" && rounding != "mitre") {
    name.fail(
        fmt::format("unknown rounding \"{}\"; \"round\" or \"mitre\" is", printable(rounding)));
  }
  if (rounding == "mitre" && vertices < kMinVertices) {
    name.fail(
        "only polygons of 3 to 8 vertices may be \"mitre\"; circles and capsules are \"round\"");
  }
  return rounding == "round" ? Rounding::round : Rounding::mitre;
}

ConvexPolygon<float> read_shape(const JsonView& array, float radius,
                                const std::optional<JsonView>& rounding) {
  std::array<Vector2<float>, kMaxVertices> vertices;
  const std::size_t count = array.length("an array of 1 to 8 vertices");
  if (count > kMaxVertices) array.fail(describe(PolygonDefect::too_many));
  for (std::size_t i = 0; i < count; ++i) vertices[i] = read_vector(array[i]);
  const std::span<const Vector2<float>> corners(vertices.data(), count);
  const auto defect = find_shape_defect(corners, radius);
  if (defect) array.fail(describe(*defect));
  return make_polygon(corners, radius,
                      rounding ? read_rounding(*rounding, count) : Rounding::mitre);
}

float read_radius(const JsonView& number) {
  const float radius = number.number_as_float();
  if (radius < 0) number.fail(fmt::format("{} is negative; a radius is 0 or more", radius));
  return radius;
}

/// Fails, naming `value`, unless it is one.
void expect_rotation(const JsonView& value, const Vector2<float>& rotation) {
  if (is_unit_rotation(rotation)) return;
  value.fail(
      fmt::format("[{}, {}] is not a rotation; it is [cos, sin], cos^2 + sin^2 within {} of 1",
                  rotation.x(), rotation.y(), kRotationTolerance));
}

ConvexPolygon<float> read_members(const JsonView& object) {
  const auto radius = object.find("radius");
  return read_shape(object.at("vertices"), radius ? read_radius(*radius) : 0,
                    object.find("rounding"));
}

using AppendFloat = void (*)(std::string&, float);
using AppendNormals = void (*)(std::string&, const ConvexPolygon<float>&);

/// A point has none.
int face_count(const ConvexPolygon<float>& polygon) {
  return polygon.count == 1 ? 0 : polygon.count;
}

/// Fails unless they are the polygon's own, as a line to a program has them.
void expect_normals(const JsonView& array, const ConvexPolygon<float>& polygon) {
  constexpr float kRounding = 1e-6F;
  const int faces = face_count(polygon);
  const std::size_t count = array.length("an array of normals");
  if (count != static_cast<std::size_t>(faces)) {
    array.fail(fmt::format("has {} elements; {} are expected, one for each face", count, faces));
  }
  for (int i = 0; i < faces; ++i) {
    const JsonView one = array[static_cast<std::size_t>(i)];
    if ((read_vector(one) - polygon.normals[i]).norm() <= kRounding) continue;
    one.fail(
        fmt::format("is not the outward unit normal of face {}; leave normals out, they "
                    "follow from the vertices",
                    i));
  }
}

/// How a case is written.
struct CaseStyle {
  // The white space before a member that is not on the line of the one before it; empty: all are on
  // one line.
  std::string_view break_in_case{};
  std::string_view break_in_body{};
  AppendFloat append_float = append_number;
  AppendNormals append_normals = nullptr;  ///< none: they follow from the vertices
};

/// The float as a double: all its digits, so that whoever reads it in either has the same value.
void append_all_digits(std::string& out, float value) {
  append_number(out, static_cast<double>(value));
}

template <class Scalar>
void append_normals(std::string& out, const ConvexPolygon<float>& polygon) {
  const ConvexPolygon<Scalar> of_scalar = polygon_cast<Scalar>(polygon);
  for (int i = 0; i < face_count(polygon); ++i) {
    if (i > 0) out += ',';
    append_vector(out, Vector2<double>(of_scalar.normals[i].template cast<double>()));
  }
}

void append_float_vector(std::string& out, const Vector2<float>& v, AppendFloat append_float) {
  append_float(out += '[', v.x());
  append_float(out += ',', v.y());
  out += ']';
}

/// Appends a comma and the key of the next member.
void append_key(std::string& out, std::string_view line_break, std::string_view key) {
  out.append(",").append(line_break.empty() ? " " : line_break);
  out.append("\"").append(key).append("\": ");
}

/// What a polygon is, a member after the other: a line break before each.
void append_members(std::string& out, const ConvexPolygon<float>& polygon, const CaseStyle& style) {
  out.append(style.break_in_body) += "\"vertices\": [";
  for (int i = 0; i < polygon.count; ++i) {
    if (i > 0) out += ',';
    append_float_vector(out, polygon.vertices[i], style.append_float);
  }
  out += ']';
  append_key(out, style.break_in_body, "radius");
  style.append_float(out, polygon.radius);
  if (!polygon.is_round()) return;
  append_key(out, style.break_in_body, "rounding");
  out += "\"round\"";
}

void append_body(std::string& out, const Body& body, const CaseStyle& style) {
  append_members(out += '{', body.polygon, style);
  append_key(out, style.break_in_body, "position");
  append_float_vector(out, body.pose.position, style.append_float);
  append_key(out, style.break_in_body, "rotation");
  append_float_vector(out, body.pose.rotation, style.append_float);
  if (style.append_normals != nullptr) {
    append_key(out, style.break_in_body, "normals");
    style.append_normals(out += '[', body.polygon);
    out += ']';
  }
  out.append(style.break_in_case) += '}';
}

/// Without the closing brace.
void append_case(std::string& out, const PairCase& pair, const CaseStyle& style) {
  out.append("{").append(style.break_in_case) += "\"format\": \"";
  out.append(format_of(pair)) += '"';
  append_key(out, style.break_in_case, "a");
  append_body(out, pair.a, style);
  append_key(out, style.break_in_case, "b");
  append_body(out, pair.b, style);
}

}  // namespace

std::string_view format_of(const PairCase& pair) {
  return is_round(pair) ? kCurvedCaseFormat : kCaseFormat;
}

void expect_two(const JsonView& array, std::string_view expected) {
  if (array.length(expected) != 2) {
    array.fail(fmt::format("has {} elements; {} is expected", array.length(), expected));
  }
}

Body read_body(const JsonView& object) {
  object.expect_keys({"vertices", "radius", "rounding", "position", "rotation", "normals"});
  Body body{read_members(object), {}};
  if (const auto normals = object.find("normals")) expect_normals(*normals, body.polygon);
  if (const auto position = object.find("position")) body.pose.position = read_vector(*position);
  if (const auto rotation = object.find("rotation")) {
    body.pose.rotation = read_vector(*rotation);
    expect_rotation(*rotation, body.pose.rotation);
  }
  return body;
}

ConvexPolygon<float> read_polygon(const JsonView& object) {
  object.expect_keys({"vertices", "radius", "rounding"});
  return read_members(object);
}

void append_polygon(std::string& out, const ConvexPolygon<float>& polygon) {
  append_members(out += '{', polygon, {});
  out += '}';
}

Pose<float> read_pose(const JsonView& array) {
  constexpr std::string_view expected = "[x, y, cos, sin]";
  if (array.length(expected) != 4) {
    array.fail(fmt::format("has {} elements; {} is expected", array.length(), expected));
  }
  Pose<float> pose;
  pose.position = {array[0].number_as_float(), array[1].number_as_float()};
  pose.rotation = {array[2].number_as_float(), array[3].number_as_float()};
  expect_rotation(array, pose.rotation);
  return pose;
}

void append_pose(std::string& out, const Pose<float>& pose) {
  std::string_view separator = "[";
  for (const Vector2<float>& pair : {pose.position, pose.rotation}) {
    for (const float number : pair) {
      append_number(out.append(separator), number);
      separator = ",";
    }
  }
  out += ']';
}

std::string feature_name(Feature feature) {
  return fmt::format(FMT_COMPILE("{}{}"), feature.kind == Feature::Kind::face ? 'f' : 'v',
                     feature.index);
}

std::optional<Feature> find_feature(std::string_view name) {
  if (!name.starts_with('f') && !name.starts_with('v')) return std::nullopt;
  Feature feature{name[0] == 'f' ? Feature::Kind::face : Feature::Kind::vertex, 0};
  const char* const end = name.data() + name.size();
  const auto [read_to, error] = std::from_chars(name.data() + 1, end, feature.index);
  if (error != std::errc() || read_to != end) return std::nullopt;
  return feature;
}

void append_case_line(std::string& out, const PairCase& pair) {
  append_case(out, pair, {});
  out += '}';
}

void append_program_line(std::string& out, const PairCase& pair, ScalarType scalar) {
  const AppendNormals normals =
      scalar == ScalarType::float64 ? append_normals<double> : append_normals<float>;
  append_case(out, pair, {.append_float = append_all_digits, .append_normals = normals});
  out += '}';
}

void append_case_start(std::string& out, const PairCase& pair) {
  append_case(out, pair, {.break_in_case = "\n  ", .break_in_body = "\n    "});
}

Side read_side(const JsonView& value) {
  const std::string_view name = value.string();
  if (name != "a" && name != "b") value.fail("\"a\" or \"b\" is expected");
  return name == "a" ? Side::a : Side::b;
}

TieBias read_tie_bias(const JsonView& value) {
  if (!value.is_object()) return {.absolute = value.magnitude()};
  value.expect_keys({"absolute", "relative", "towards"});
  TieBias bias;
  if (const auto absolute = value.find("absolute")) bias.absolute = absolute->magnitude();
  if (const auto relative = value.find("relative")) bias.relative = relative->number();
  if (!value.find("absolute") && !value.find("relative")) {
    value.fail("\"absolute\" or \"relative\" is expected");
  }
  if (const auto towards = value.find("towards")) bias.towards = read_side(*towards);
  return bias;
}

namespace {

/// A float's own digits, where it is one.
std::string shortest(double value) {
  const auto as_float = static_cast<float>(value);
  const bool is_float = static_cast<double>(as_float) == value;
  return is_float ? fmt::format("{}", as_float) : fmt::format("{}", value);
}

}  // namespace

std::string in_words(const TieBias& bias) {
  if (bias == TieBias{.absolute = bias.absolute}) return shortest(bias.absolute);
  return fmt::format("{} and {:.6g}% towards {}", shortest(bias.absolute), 100 * bias.relative,
                     bias.towards == Side::a ? 'a' : 'b');
}

}  // namespace manifuzz
