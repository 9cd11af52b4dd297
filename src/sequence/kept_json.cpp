#include "sequence/kept_json.hpp"

#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exchange/json.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz {
namespace {

void append_point(std::string& out, const PairCase& pair, const KeptPoint& point) {
  fmt::format_to(std::back_inserter(out), "{{\"id\": {}, \"born\": {}, \"position\": ", point.id,
                 point.born);
  append_vector(out, without_negative_zeros(to_world(pair, point.anchor_a)));
  append_number(out += ", \"depth\": ", point.depth);
  append_vector(out += ", \"normal\": ", without_negative_zeros(point.normal));
  append_vector(out += ", \"anchor_a\": ", point.anchor_a);
  append_vector(out += ", \"anchor_b\": ", point.anchor_b);
  out.append(", \"travels_with\": \"").append(name_of(point.travels_with)).append("\"}");
}

}  // namespace

std::string_view name_of(TravelsWith carrier) {
  constexpr std::array<std::string_view, 3> names{"a", "b", "world"};
  return names[static_cast<std::size_t>(carrier)];
}

void append_kept_answer(std::string& out, const PairCase& pair, std::string_view collider,
                        const FrameNumber& number, const KeptAnswer& answer) {
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    throw UserError(
        fmt::format("frame {}: {} gives no answer: {}", number.frame, collider, lost->why));
  }
  append_string(out += "{\"collider\": ", collider);
  fmt::format_to(std::back_inserter(out), ", \"sequence\": {}, \"frame\": {}, ", number.sequence,
                 number.frame);
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

}  // namespace manifuzz
