#include <iterator>
#include <limits>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/json.hpp"

namespace manifuzz {
namespace {

void append_point(std::string& out, const PairCase& pair, const ContactPoint<double>& point) {
  append_vector(out += "{\"position\": ", without_negative_zeros(to_world(pair, point.position)));
  append_vector(out += ", \"local\": ", point.position);
  append_number(out += ", \"depth\": ", point.depth);
  fmt::format_to(std::back_inserter(out), FMT_COMPILE(", \"features\": [\"{}\",\"{}\"]}}"),
                 feature_name(point.features.a), feature_name(point.features.b));
}

void append_manifold(std::string& out, const PairCase& pair, const Manifold<double>& manifold) {
  if (manifold.count > 0) {
    append_vector(out += "\"normal\": ",
                  without_negative_zeros(world_normal(pair, manifold.normal)));
    out += manifold.reference == Side::a ? ", \"reference\": \"a\", " : ", \"reference\": \"b\", ";
  }
  out += "\"points\": [";
  for (int i = 0; i < manifold.count; ++i) {
    if (i > 0) out += ", ";
    append_point(out, pair, manifold.points[i]);
  }
  out += ']';
}

void append_penetration(std::string& out, const PairCase& pair, const Penetration& penetration) {
  out += penetration.touches ? "\"touching\": true" : "\"touching\": false";
  if (!penetration.normal) return;
  append_vector(out += ", \"normal\": ",
                without_negative_zeros(world_normal(pair, *penetration.normal)));
  append_number(out += ", \"depth\": ", penetration.depth);
}

/// Reads a manifold as a corpus file records it, or as a program answers. A corpus file has every
/// key and no other, null for a number that is not finite, and any feature, since what was recorded
/// may be nonsense. A program may leave out what is optional and add what it likes.
class ManifoldReader {
 public:
  ManifoldReader(const PairCase& pair, bool is_recorded) : pair_(pair), is_recorded_(is_recorded) {}

  ReportedManifold manifold(const JsonView& object) const {
    ReportedManifold result;
    result.used = shapes(object);
    const JsonView points = object.at("points");
    const std::size_t count = points.length("an array of 0 to 2 points");
    if (count > result.points.size()) {
      points.fail(fmt::format("has {} points; a manifold has 0 to 2", count));
    }
    result.count = static_cast<int>(count);
    if (count == 0) return result;
    result.normal = vector(object.at("normal"));
    if (const auto reference = member(object, "reference"))
      result.reference = read_side(*reference);
    const auto shared = is_recorded_ ? std::nullopt : object.find("depth");
    for (std::size_t i = 0; i < count; ++i) result.points[i] = point(points[i], shared);
    return result;
  }

  /// `needs_normal`: where they touch, how far along which normal.
  Penetration penetration(const JsonView& object, bool needs_normal,
                          const Conventions& conventions) const {
    Penetration result;
    result.used = shapes(object);
    const auto touching = object.find("touching");
    const auto depth = object.find("depth");
    if (touching) result.touches = touching->boolean();
    if (touching && !needs_normal) return result;
    if (touching && !depth && !result.touches) return result;
    if (const auto points = object.find("points"); points && !touching && !depth) {
      if (points->length("an array") == 0) return result;
    }
    if (!needs_normal) object.fail("\"touching\", true or false, is expected, as it declares");
    result.depth = number(object.at("depth"));
    if (!touching) result.touches = result.depth >= 0;
    result.normal = normal_in_frame_of_a(vector(object.at("normal")), conventions, pair_);
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

  std::optional<UsedShapes> shapes(const JsonView& object) const {
    const auto given = object.find("shapes");
    if (!given) return std::nullopt;
    UsedShapes used;
    for (const Side side : {Side::a, Side::b}) {
      used[side] = read_used_vertices(given->at(side == Side::a ? "a" : "b"));
    }
    return used;
  }

  Vector2<double> vector(const JsonView& array) const {
    expect_two(array, "an array of two numbers");
    return {number(array[0]), number(array[1])};
  }

  Feature feature(const JsonView& value, const Body& body) const {
    const auto feature = find_feature(value.string());
    const bool is_known = feature && (is_recorded_ || feature->index < body.polygon.count);
    if (is_known) return *feature;
    value.fail(fmt::format("\"{}\" is not a feature; f or v and an index{} is expected",
                           printable(value.string()),
                           is_recorded_ ? "" : fmt::format(" below {}", body.polygon.count)));
  }

  ReportedPoint point(const JsonView& object, const std::optional<JsonView>& shared_depth) const {
    if (is_recorded_) object.expect_keys({"position", "local", "depth", "features"});
    ReportedPoint result;
    const auto local = member(object, "local");
    const auto world = member(object, "position");
    if (!local && !world) {
      object.fail("neither \"position\" nor \"local\" is there; one of them is expected");
    }
    if (local) result.local = vector(*local);
    if (world && (is_recorded_ || !local)) result.world = vector(*world);
    const auto own_depth = object.find("depth");
    result.depth = number(own_depth || !shared_depth ? object.at("depth") : *shared_depth);
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

void append_answer(std::string& out, const PairCase& pair, std::string_view collider,
                   const Answer& answer) {
  append_string(out += "{\"collider\": ", collider);
  out += ", ";
  if (const auto* unsupported = std::get_if<Unsupported>(&answer)) {
    append_string(out += "\"unsupported\": ", unsupported->why);
  } else if (const auto* penetration = std::get_if<Penetration>(&answer)) {
    append_penetration(out, pair, *penetration);
  } else {
    append_manifold(out, pair, *manifold_in(answer));
  }
  if (const UsedShapes* const used = used_by(answer)) append_shapes(out, *used);
  out += '}';
}

void append_manifold_object(std::string& out, const PairCase& pair,
                            const Manifold<double>& manifold) {
  append_manifold(out += '{', pair, manifold);
  out += '}';
}

NamedAnswer read_recorded_answer(const JsonView& object, const PairCase& pair) {
  object.expect_keys(
      {"collider", "unsupported", "normal", "reference", "points", "touching", "depth", "shapes"});
  const std::string collider(object.at("collider").string());
  if (const auto touching = object.find("touching")) {
    return {collider,
            ManifoldReader(pair, true).penetration(object, object.find("normal").has_value(), {})};
  }
  if (const auto unsupported = object.find("unsupported")) {
    return {collider, Unsupported{std::string(unsupported->string())}};
  }
  const ReportedManifold recorded = ManifoldReader(pair, true).manifold(object);
  const PartialManifold manifold = in_frame_of_a(recorded, {.is_ordered = true}, pair);
  if (manifold.used) return {collider, manifold};
  return {collider, manifold.manifold};
}

Answer read_reported_answer(const JsonView& object, const PairCase& pair,
                            const Conventions& conventions) {
  if (const auto unsupported = object.find("unsupported")) {
    return Unsupported{std::string(unsupported->string())};
  }
  const ManifoldReader reader(pair, false);
  const Answer answer = conventions.is_without_points()
                            ? Answer(reader.penetration(
                                  object, conventions.claims == Claims::separation, conventions))
                            : in_frame_of_a(reader.manifold(object), conventions, pair);
  if (const auto why = contradiction(answer, conventions)) object.fail(*why);
  return answer;
}

std::optional<std::string> contradiction(const Answer& answer, const Conventions& conventions) {
  const Manifold<double>* const manifold = manifold_in(answer);
  if (conventions.claims == Claims::point && manifold != nullptr && manifold->count > 1) {
    return fmt::format("has {} points; 0 or 1 is expected, as it declares", manifold->count);
  }
  if (conventions.shares_depth && manifold != nullptr && manifold->count > 1 &&
      manifold->points[0].depth != manifold->points[1].depth) {
    return fmt::format("has depths of {} and {}; one is expected for all points, as it declares",
                       manifold->points[0].depth, manifold->points[1].depth);
  }
  const auto* const less = std::get_if<Penetration>(&answer);
  if (less != nullptr && less->normal && !less->touches && less->depth > 0) {
    return "says that they do not touch, and a depth above 0";
  }
  if (conventions.says_shapes && used_by(answer) == nullptr) {
    return "says no shapes; those that it used are expected, as it declares";
  }
  return std::nullopt;
}

Vector2<double> normal_in_frame_of_a(const Vector2<double>& normal, const Conventions& conventions,
                                     const PairCase& pair) {
  const Vector2<double> in_a = conventions.normal_in_a ? normal : local_normal(pair, normal);
  return conventions.normal_from_b ? Vector2<double>(-in_a) : in_a;
}

PartialManifold in_frame_of_a(const ReportedManifold& reported, const Conventions& conventions,
                              const PairCase& pair) {
  PartialManifold result{.names_reference = reported.reference.has_value(),
                         .names_features = reported.count > 0,
                         .has_midpoints = conventions.has_midpoints,
                         .used = reported.used};
  Manifold<double>& manifold = result.manifold;
  manifold.count = reported.count;
  if (manifold.count == 0) return result;
  manifold.reference = reported.reference.value_or(Side::a);
  manifold.normal = normal_in_frame_of_a(reported.normal, conventions, pair);
  for (int i = 0; i < manifold.count; ++i) {
    const ReportedPoint& point = reported.points[i];
    manifold.points[i] = {point.local ? *point.local : to_local(pair.a.pose, point.world.value()),
                          point.depth, point.features.value_or(FeaturePair{})};
    result.names_features = result.names_features && point.features.has_value();
  }
  if (!conventions.is_ordered) order_points(manifold);
  return result;
}

Answer AnswerFile::at(std::size_t index, const PairCase& pair) {
  while (read_ < index) next_line();
  const Line line = next_line();
  try {
    if (line.too_long) throw UserError("longer than 1 MiB");
    const JsonTree tree = parse_json(line.text);
    return read_reported_answer(JsonView(tree), pair, conventions_);
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}:{}: {}", file_.name(), line.number, error.what()));
  }
}

void AnswerFile::expect_end() {
  const auto line = lines_.next();
  if (!line) return;
  throw UserError(fmt::format("{}:{}: more answers than cases; one answer per case is expected",
                              file_.name(), line->number));
}

Line AnswerFile::next_line() {
  const auto line = lines_.next();
  ++read_;
  if (line) return *line;
  throw UserError(file_.name() + ": fewer answers than cases; one answer per case is expected");
}

}  // namespace manifuzz
