#include "exchange/kept_json.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/json.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {
namespace {

constexpr std::array<std::string_view, 3> kCarrierNames{"a", "b", "world"};

void append_point(std::string& out, const PairCase& pair, const KeptPoint& point) {
  out += fmt::format("{{\"id\": {}, \"born\": {}, \"position\": ", point.id, point.born);
  append_vector(out, without_negative_zeros(to_world(pair, point.anchor_a)));
  append_number(out += ", \"depth\": ", point.depth);
  append_vector(out += ", \"normal\": ", without_negative_zeros(point.normal));
  append_vector(out += ", \"anchor_a\": ", point.anchor_a);
  append_vector(out += ", \"anchor_b\": ", point.anchor_b);
  out.append(", \"travels_with\": \"").append(name_of(point.travels_with)).append("\"}");
}

}  // namespace

std::string_view name_of(TravelsWith carrier) {
  return kCarrierNames[static_cast<std::size_t>(carrier)];
}

void append_kept_answer(std::string& out, const PairCase& pair, std::string_view collider,
                        const FrameNumber& number, const KeptAnswer& answer) {
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    throw UserError(
        fmt::format("frame {}: {} gives no answer: {}", number.frame, collider, lost->why));
  }
  append_string(out += "{\"collider\": ", collider);
  out += fmt::format(", \"sequence\": {}, \"frame\": {}, ", number.sequence, number.frame);
  if (const auto* const unsupported = std::get_if<Unsupported>(&answer)) {
    append_string(out += "\"unsupported\": ", unsupported->why);
    out += '}';
    return;
  }
  std::string_view separator = "\"points\": [";
  const auto& points = std::get<KeptManifold>(answer).points;
  for (const KeptPoint& point : points) {
    append_point(out.append(separator), pair, point);
    separator = ", ";
  }
  out += points.empty() ? "\"points\": []}" : "]}";
}

void append_frame_line(std::string& out, const PairCase& pair, const FrameNumber& number,
                       ScalarType scalar) {
  std::string line;
  append_program_line(line, pair, scalar);
  out += fmt::format("{{\"sequence\": {}, \"frame\": {}, {}", number.sequence, number.frame,
                     std::string_view(line).substr(1));
}

namespace {

/// Ids without a name of a program's own lie below all that it may give.
constexpr int kFirstUnnamed = std::numeric_limits<int>::min();

Vector2<double> read_place(const JsonView& array) {
  expect_two(array, "an array of two numbers");
  return {array[0].number(), array[1].number()};
}

int read_count(const JsonView& value) {
  const std::uint64_t count = value.whole_number();
  if (count > std::numeric_limits<int>::max()) value.fail("is too large");
  return static_cast<int>(count);
}

/// One of these words, the first where there is none.
std::size_t read_word(const JsonView& object, std::string_view key,
                      std::span<const std::string_view> words) {
  const auto value = object.find(key);
  if (!value) return 0;
  const auto found = std::ranges::find(words, value->string());
  if (found == words.end()) {
    value->fail(fmt::format("\"{}\" is expected", fmt::join(words, "\" or \"")));
  }
  return static_cast<std::size_t>(found - words.begin());
}

ShapeLength read_length(const JsonView& object, std::string_view key) {
  constexpr std::array<std::string_view, 2> measures{"reach", "angular_disc"};
  const auto value = object.find(key);
  if (!value) return {};
  if (!value->is_object()) return {.absolute = value->magnitude()};
  value->expect_keys({"absolute", "relative", "measure"});
  const auto number = [&](std::string_view name) {
    const auto member = value->find(name);
    return member ? member->magnitude() : 0;
  };
  return {number("absolute"), number("relative"),
          static_cast<ShapeMeasure>(read_word(*value, "measure", measures))};
}

}  // namespace

KeptPoint KeptReader::read_point(const JsonView& object,
                                 const std::optional<JsonView>& normal_of_all,
                                 const PairCase& pair) {
  KeptPoint point;
  const auto id = object.find("id");
  point.id = id ? read_count(*id) : kFirstUnnamed + unnamed_++;
  const auto born = object.find("born");
  point.born = born ? read_count(*born) : born_.emplace(point.id, frame_).first->second;
  point.depth = object.at("depth").number();
  const auto normal = object.find("normal");
  point.normal = read_place(normal || !normal_of_all ? object.at("normal") : *normal_of_all);
  if (normal_from_b_) point.normal = -point.normal;
  point.travels_with = static_cast<TravelsWith>(read_word(object, "travels_with", kCarrierNames));
  if (object.find("anchor_a") || object.find("anchor_b")) {
    point.anchor_a = read_place(object.at("anchor_a"));
    point.anchor_b = read_place(object.at("anchor_b"));
    return point;
  }
  const auto local = object.find("local");
  const Vector2<double> on_a =
      local ? to_world(pair, read_place(*local)) : read_place(object.at("position"));
  point.anchor_a = to_local(pair.a.pose, on_a);
  point.anchor_b = to_local(pair.b.pose, on_a - point.depth * point.normal);
  return point;
}

KeptAnswer KeptReader::read(const JsonView& object, const PairCase& pair) {
  const auto unsupported = object.find("unsupported");
  if (unsupported) return Unsupported{std::string(unsupported->string())};
  KeptManifold manifold;
  const auto normal_of_all = object.find("normal");
  for (const JsonView& point : object.at("points").elements("an array of points")) {
    manifold.points.push_back(read_point(point, normal_of_all, pair));
  }
  ++frame_;
  return manifold;
}

Keeping read_keeping(const JsonView& object) {
  object.expect_keys({"gap", "drift", "turn", "since", "match", "match_by", "points_max"});
  constexpr std::array<std::string_view, 2> since{"birth", "refresh"};
  constexpr std::array<std::string_view, 4> match_by{"both", "either", "a", "b"};
  Keeping keeping{.gap = read_length(object, "gap"),
                  .drift = read_length(object, "drift"),
                  .since = static_cast<StaleSince>(read_word(object, "since", since)),
                  .match = read_length(object, "match"),
                  .match_by = static_cast<MatchBy>(read_word(object, "match_by", match_by))};
  if (const auto turn = object.find("turn")) keeping.turn = turn->magnitude();
  if (const auto most = object.find("points_max")) keeping.points_max = read_count(*most);
  return keeping;
}

}  // namespace manifuzz
