#include "exchange/json.hpp"

#include <charconv>
#include <iterator>
#include <limits>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "base/json.hpp"
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

/// The white space before a member that is not on the line of the one before it; empty: all are on
/// one line.
struct LineBreaks {
  std::string_view in_case;
  std::string_view in_body;
};

/// Appends a comma and the key of the next member.
void append_key(std::string& out, std::string_view line_break, std::string_view key) {
  out.append(",").append(line_break.empty() ? " " : line_break);
  out.append("\"").append(key).append("\": ");
}

void append_body(std::string& out, const Body& body, const LineBreaks& breaks) {
  out.append("{").append(breaks.in_body) += "\"vertices\": [";
  for (int i = 0; i < body.polygon.count; ++i) {
    if (i > 0) out += ',';
    append_vector(out, body.polygon.vertices[i]);
  }
  out += ']';
  append_key(out, breaks.in_body, "radius");
  append_number(out, body.polygon.radius);
  append_key(out, breaks.in_body, "position");
  append_vector(out, body.pose.position);
  append_key(out, breaks.in_body, "rotation");
  append_vector(out, body.pose.rotation);
  out.append(breaks.in_case) += '}';
}

/// Without the closing brace.
void append_case(std::string& out, const PairCase& pair, const LineBreaks& breaks) {
  out.append("{").append(breaks.in_case) += "\"format\": \"";
  out.append(kCaseFormat) += '"';
  append_key(out, breaks.in_case, "a");
  append_body(out, pair.a, breaks);
  append_key(out, breaks.in_case, "b");
  append_body(out, pair.b, breaks);
}

void append_point(std::string& out, const PairCase& pair, const ContactPoint<double>& point) {
  out += "{\"position\": ";
  append_vector(out, to_world(pair, point.position));
  out += ", \"local\": ";
  append_vector(out, point.position);
  out += ", \"depth\": ";
  append_number(out, point.depth);
  fmt::format_to(std::back_inserter(out), FMT_COMPILE(", \"features\": [\"{}\",\"{}\"]}}"),
                 feature_name(point.features.a), feature_name(point.features.b));
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

/// Reads a manifold as a corpus file records it, or as a program answers. A corpus file has every
/// key and no other, null for a number that is not finite, and any feature, since what was recorded
/// may be nonsense. A program may leave out what is optional and add what it likes.
class ManifoldReader {
 public:
  ManifoldReader(const PairCase& pair, bool is_recorded) : pair_(pair), is_recorded_(is_recorded) {}

  ReportedManifold manifold(const JsonView& object) const {
    ReportedManifold result;
    const JsonView points = object.at("points");
    const std::size_t count = points.length("an array of 0 to 2 points");
    if (count > result.points.size()) {
      points.fail(fmt::format("has {} points; a manifold has 0 to 2", count));
    }
    result.count = static_cast<int>(count);
    if (count == 0) return result;
    result.normal = vector(object.at("normal"));
    if (const auto reference = member(object, "reference")) result.reference = side(*reference);
    for (std::size_t i = 0; i < count; ++i) result.points[i] = point(points[i]);
    return result;
  }

 private:
  std::optional<JsonView> member(const JsonView& object, std::string_view key) const {
    return is_recorded_ ? object.at(key) : object.find(key);
  }

  double number(const JsonView& value) const {
    if (is_recorded_ && value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    return value.number();
  }

  Vector2<double> vector(const JsonView& array) const {
    expect_two(array, "an array of two numbers");
    return {number(array[0]), number(array[1])};
  }

  static Side side(const JsonView& value) {
    const std::string_view name = value.string();
    if (name != "a" && name != "b") value.fail("the reference is \"a\" or \"b\"");
    return name == "a" ? Side::a : Side::b;
  }

  Feature feature(const JsonView& value, const Body& body) const {
    const auto feature = find_feature(value.string());
    const bool is_known = feature && (is_recorded_ || feature->index < body.polygon.count);
    if (is_known) return *feature;
    value.fail(fmt::format("\"{}\" is not a feature; f or v and an index{} is expected",
                           printable(value.string()),
                           is_recorded_ ? "" : fmt::format(" below {}", body.polygon.count)));
  }

  ReportedPoint point(const JsonView& object) const {
    if (is_recorded_) object.expect_keys({"position", "local", "depth", "features"});
    ReportedPoint result;
    const auto local = member(object, "local");
    const auto world = member(object, "position");
    if (!local && !world) {
      object.fail("neither \"position\" nor \"local\" is there; one of them is expected");
    }
    if (local) result.local = vector(*local);
    if (world && (is_recorded_ || !local)) result.world = vector(*world);
    result.depth = number(object.at("depth"));
    if (const auto features = member(object, "features")) {
      expect_two(*features, "[A's feature, B's feature]");
      result.features = {feature((*features)[0], pair_.a), feature((*features)[1], pair_.b)};
    }
    return result;
  }

  const PairCase& pair_;
  bool is_recorded_;
};

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

void append_case_start(std::string& out, const PairCase& pair) {
  append_case(out, pair, {"\n  ", "\n    "});
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

NamedAnswer read_recorded_answer(const JsonView& object, const PairCase& pair) {
  object.expect_keys({"collider", "unsupported", "normal", "reference", "points"});
  const std::string collider(object.at("collider").string());
  if (const auto unsupported = object.find("unsupported")) {
    return {collider, Unsupported{std::string(unsupported->string())}};
  }
  const ReportedManifold recorded = ManifoldReader(pair, true).manifold(object);
  return {collider, in_frame_of_a(recorded, {.is_ordered = true}, pair).manifold};
}

Answer read_reported_answer(const JsonView& object, const PairCase& pair,
                            const Conventions& conventions) {
  if (const auto unsupported = object.find("unsupported")) {
    return Unsupported{std::string(unsupported->string())};
  }
  return in_frame_of_a(ManifoldReader(pair, false).manifold(object), conventions, pair);
}

}  // namespace manifuzz
