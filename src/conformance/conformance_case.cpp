#include "conformance/conformance_case.hpp"

#include <cmath>

#include "base/text.hpp"
#include "conformance/right_clips.hpp"
#include "conformance/right_round.hpp"
#include "conformance/widened.hpp"
#include "corpus/corpus.hpp"
#include "exchange/json.hpp"
#include "judging/bounds.hpp"

namespace manifuzz {
namespace {

void append_body(std::string& out, const Body& body) {
  append_polygon(out, body.polygon);
  out.pop_back();
  const Pose<float> none;
  if (body.pose.position != none.position) {
    append_vector(out += ", \"position\": ", body.pose.position);
  }
  if (body.pose.rotation != none.rotation) {
    append_vector(out += ", \"rotation\": ", body.pose.rotation);
  }
  out += '}';
}

}  // namespace

std::optional<std::string> conformance_line(std::string_view name, const PairCase& pair) {
  const Bounds in_float = bounds(pair, port_declaration(ScalarType::float32));
  if (!std::isfinite(in_float.separation) || is_ill_posed(size(pair), in_float)) {
    return std::nullopt;
  }
  std::string line = "{\"format\": \"";
  append_string(line.append(kConformanceFormat) += "\", \"name\": ", name);
  append_body(line += ", \"a\": ", pair.a);
  append_body(line += ", \"b\": ", pair.b);
  line += ", ";
  const exact::Truth truth(pair);
  if (!is_round(pair)) {
    append_right_clips(line, truth);
  } else if (!append_right_round(line, truth)) {
    return std::nullopt;
  }
  line += '}';
  std::erase(line, ' ');  // two megabytes are to hold 2,000 cases
  return line;
}

}  // namespace manifuzz
