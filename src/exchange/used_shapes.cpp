#include <fmt/format.h>

#include "base/json.hpp"
#include "exchange/json.hpp"

namespace manifuzz {

void append_shapes(std::string& out, const UsedShapes& used) {
  out += ", \"shapes\": {";
  for (const Side side : {Side::a, Side::b}) {
    const UsedVertices& of_side = used[side];
    out += side == Side::a ? "\"a\": " : ", \"b\": ";
    if (of_side.round_radius) out += "{\"vertices\": ";
    out += '[';
    for (int i = 0; i < of_side.count; ++i) {
      if (i > 0) out += ", ";
      append_vector(out, of_side.all[i]);
    }
    out += ']';
    if (!of_side.round_radius) continue;
    append_number(out += ", \"radius\": ", *of_side.round_radius);
    out += '}';
  }
  out += '}';
}

UsedVertices read_used_vertices(const JsonView& shape) {
  if (shape.is_object()) {
    shape.expect_keys({"vertices", "radius"});
    UsedVertices rounded = read_used_vertices(shape.at("vertices"));
    rounded.round_radius = shape.at("radius").number_as_float();
    return rounded;
  }
  const std::size_t count = shape.length("an array of vertices");
  if (count < 1 || count > kMaxVertices) {
    shape.fail(fmt::format("has {} vertices; 1 to {} are expected", count, kMaxVertices));
  }
  UsedVertices used;
  used.count = static_cast<int>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const JsonView vertex = shape[i];
    expect_two(vertex, "an array of two numbers");
    used.all[i] = {vertex[0].number(), vertex[1].number()};
  }
  return used;
}

}  // namespace manifuzz
