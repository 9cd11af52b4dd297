#include "exchange/json.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "base/json_tree.hpp"
#include "base/text.hpp"

namespace manifuzz {
namespace {

void expect_two(const JsonView& array, std::string_view expected) {
  if (array.length(expected) != 2) {
    array.fail(fmt::format("has {} elements; {} is expected", array.length(), expected));
  }
}

Vector2<float> read_vector(const JsonView& array) {
  expect_two(array, "an array of two numbers");
  return {array[0].number_as_float(), array[1].number_as_float()};
}

ConvexPolygon<float> read_polygon(const JsonView& array, float radius) {
  std::array<Vector2<float>, kMaxVertices> vertices;
  const std::size_t count = array.length("an array of 3 to 8 vertices");
  if (count > kMaxVertices) array.fail(describe(PolygonDefect::too_many));
  for (std::size_t i = 0; i < count; ++i) vertices[i] = read_vector(array[i]);
  const std::span<const Vector2<float>> corners(vertices.data(), count);
  const auto defect = find_defect(corners);
  if (defect) array.fail(describe(*defect));
  return make_polygon(corners, radius);
}

float read_radius(const JsonView& number) {
  const float radius = number.number_as_float();
  if (radius < 0) number.fail(fmt::format("{} is negative; a radius is 0 or more", radius));
  return radius;
}

Vector2<float> read_rotation(const JsonView& array) {
  Vector2<float> rotation = read_vector(array);
  if (!is_unit_rotation(rotation)) {
    array.fail(
        fmt::format("[{}, {}] is not a rotation; it is [cos, sin], cos^2 + sin^2 within {} of 1",
                    rotation.x(), rotation.y(), kRotationTolerance));
  }
  return rotation;
}

template <class Scalar>
void append_vector(std::string& out, const Vector2<Scalar>& v) {
  out += '[';
  append_number(out, v.x());
  out += ',';
  append_number(out, v.y());
  out += ']';
}

void append_feature(std::string& out, Feature feature) {
  const char kind = feature.kind == Feature::Kind::face ? 'f' : 'v';
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("\"{}{}\""), kind, feature.index);
}

void append_point(std::string& out, const PairCase& pair, const ContactPoint<double>& point) {
  out += "{\"position\": ";
  append_vector(out, to_world(pair, point.position));
  out += ", \"local\": ";
  append_vector(out, point.position);
  out += ", \"depth\": ";
  append_number(out, point.depth);
  out += ", \"features\": [";
  append_feature(out, point.features.a);
  out += ',';
  append_feature(out, point.features.b);
  out += "]}";
}

void append_manifold(std::string& out, const PairCase& pair, const Manifold<double>& manifold) {
  if (manifold.count > 0) {
    out += "\"normal\": ";
    append_vector(out, world_normal(pair, manifold.normal));
    out += manifold.reference == Side::a ? ", \"reference\": \"a\", " : ", \"reference\": \"b\", ";
  }
  out += "\"points\": [";
  for (int i = 0; i < manifold.count; ++i) {
    if (i > 0) out += ", ";
    append_point(out, pair, manifold.points[i]);
  }
  out += ']';
}

double read_answered_number(const JsonView& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.number();
}

Vector2<double> read_answered_vector(const JsonView& array) {
  expect_two(array, "an array of two numbers");
  return {read_answered_number(array[0]), read_answered_number(array[1])};
}

/// A recorded answer may be nonsense, so any index that a feature can hold is read.
Feature read_feature(const JsonView& value) {
  const std::string_view text = value.string();
  const char* const end = text.data() + text.size();
  unsigned char index = 0;
  const bool named = text.starts_with('f') || text.starts_with('v');
  if (!named || std::from_chars(text.data() + 1, end, index).ptr != end || text.size() < 2) {
    value.fail(
        fmt::format("\"{}\" is not a feature; f or v and an index is expected", printable(text)));
  }
  return {text[0] == 'f' ? Feature::Kind::face : Feature::Kind::vertex, index};
}

ContactPoint<double> read_point(const JsonView& object) {
  object.expect_keys({"position", "local", "depth", "features"});
  read_answered_vector(object.at("position"));
  const JsonView features = object.at("features");
  expect_two(features, "[A's feature, B's feature]");
  return {read_answered_vector(object.at("local")),
          read_answered_number(object.at("depth")),
          {read_feature(features[0]), read_feature(features[1])}};
}

Manifold<double> read_manifold(const JsonView& object, const PairCase& pair) {
  Manifold<double> manifold;
  const JsonView points = object.at("points");
  if (points.length("an array of 0 to 2 points") > manifold.points.size()) {
    points.fail(fmt::format("has {} points; a manifold has 0 to 2", points.length()));
  }
  manifold.count = static_cast<int>(points.length());
  if (manifold.count == 0) return manifold;
  const std::string_view reference = object.at("reference").string();
  if (reference != "a" && reference != "b") {
    object.at("reference").fail("the reference is \"a\" or \"b\"");
  }
  manifold.reference = reference == "a" ? Side::a : Side::b;
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  manifold.normal = rotate_back<double>(rotation, read_answered_vector(object.at("normal"))) /
                    std::sqrt(rotation.dot(rotation));  // undoes `world_normal`
  for (int i = 0; i < manifold.count; ++i) {
    manifold.points[i] = read_point(points[static_cast<std::size_t>(i)]);
  }
  return manifold;
}

}  // namespace

Body read_body(const JsonView& object) {
  object.expect_keys({"vertices", "radius", "position", "rotation"});
  Body body;
  const auto radius = object.find("radius");
  body.polygon = read_polygon(object.at("vertices"), radius ? read_radius(*radius) : 0);
  if (const auto position = object.find("position")) body.pose.position = read_vector(*position);
  if (const auto rotation = object.find("rotation")) body.pose.rotation = read_rotation(*rotation);
  return body;
}

void append_body(std::string& out, const Body& body, std::string_view separator) {
  out += "\"vertices\": [";
  for (int i = 0; i < body.polygon.count; ++i) {
    if (i > 0) out += ',';
    append_vector(out, body.polygon.vertices[i]);
  }
  out += ']';
  out.append(separator) += "\"radius\": ";
  append_number(out, body.polygon.radius);
  out.append(separator) += "\"position\": ";
  append_vector(out, body.pose.position);
  out.append(separator) += "\"rotation\": ";
  append_vector(out, body.pose.rotation);
}

void append_case_line(std::string& out, const PairCase& pair) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{{\"format\": \"{}\", \"a\": {{"),
                 kCaseFormat);
  append_body(out, pair.a);
  out += "}, \"b\": {";
  append_body(out, pair.b);
  out += "}}";
}

void append_answer(std::string& out, const PairCase& pair, std::string_view collider,
                   const Answer& answer) {
  out += "{\"collider\": ";
  append_string(out, collider);
  out += ", ";
  if (const auto* unsupported = std::get_if<Unsupported>(&answer)) {
    out += "\"unsupported\": ";
    append_string(out, unsupported->why);
  } else {
    append_manifold(out, pair, std::get<Manifold<double>>(answer));
  }
  out += '}';
}

void append_manifold_object(std::string& out, const PairCase& pair,
                            const Manifold<double>& manifold) {
  out += '{';
  append_manifold(out, pair, manifold);
  out += '}';
}

NamedAnswer read_answer(const JsonView& object, const PairCase& pair) {
  object.expect_keys({"collider", "unsupported", "normal", "reference", "points"});
  const std::string collider(object.at("collider").string());
  if (const auto unsupported = object.find("unsupported")) {
    return {collider, Unsupported{std::string(unsupported->string())}};
  }
  return {collider, read_manifold(object, pair)};
}

}  // namespace manifuzz
