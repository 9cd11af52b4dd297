#include <fmt/format.h>

#include "base/json_tree.hpp"
#include "exchange/json.hpp"

namespace manifuzz {
namespace {

Vector2<double> read_pair_of_numbers(const JsonView& array) {
  if (array.length("an array of two numbers") != 2)
    array.fail("an array of two numbers is expected");
  return {array[0].number(), array[1].number()};
}

/// "f2" or "v0", its index one that the polygon has.
Feature read_feature(const JsonView& value, const Body& body) {
  const std::string_view text = value.string();
  const bool named = text.size() == 2 && (text[0] == 'f' || text[0] == 'v');
  const int index = named ? text[1] - '0' : -1;
  if (index < 0 || index >= body.polygon.count) {
    value.fail(fmt::format("f or v and an index below {} is expected", body.polygon.count));
  }
  return {text[0] == 'f' ? Feature::Kind::face : Feature::Kind::vertex,
          static_cast<unsigned char>(index)};
}

Vector2<double> read_position(const JsonView& point, const PairCase& pair) {
  if (const auto local = point.find("local")) return read_pair_of_numbers(*local);
  if (const auto world = point.find("position")) {
    return to_local(pair.a.pose, read_pair_of_numbers(*world));
  }
  point.fail("neither \"position\" nor \"local\" is there; one of them is expected");
}

Side read_side(const JsonView& value) {
  const std::string_view side = value.string();
  if (side != "a" && side != "b") value.fail("the reference is \"a\" or \"b\"");
  return side == "a" ? Side::a : Side::b;
}

}  // namespace

Answer read_outside_answer(const JsonView& object, const PairCase& pair) {
  if (const auto unsupported = object.find("unsupported")) {
    return Unsupported{std::string(unsupported->string())};
  }
  const JsonView points = object.at("points");
  PartialManifold result;
  Manifold<double>& manifold = result.manifold;
  if (points.length("an array of 0 to 2 points") > manifold.points.size()) {
    points.fail(fmt::format("has {} points; a manifold has 0 to 2", points.length()));
  }
  manifold.count = static_cast<int>(points.length());
  if (manifold.count > 0) {
    const Vector2<double> normal = read_pair_of_numbers(object.at("normal"));
    const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
    manifold.normal = rotate_back<double>(rotation, normal) / std::sqrt(rotation.dot(rotation));
    const auto reference = object.find("reference");
    result.names_reference = reference.has_value();
    if (reference) manifold.reference = read_side(*reference);
  }
  result.names_features = manifold.count > 0;
  for (int i = 0; i < manifold.count; ++i) {
    const JsonView point = points[static_cast<std::size_t>(i)];
    manifold.points[i].position = read_position(point, pair);
    manifold.points[i].depth = point.at("depth").number();
    const auto features = point.find("features");
    if (!features) {
      result.names_features = false;
    } else {
      if (features->length() != 2) features->fail("[A's feature, B's feature] is expected");
      manifold.points[i].features = {read_feature((*features)[0], pair.a),
                                     read_feature((*features)[1], pair.b)};
    }
  }
  order_points(manifold);
  return result;
}

}  // namespace manifuzz
