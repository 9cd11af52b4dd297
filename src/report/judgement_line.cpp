#include "report/judgement_line.hpp"

#include <cmath>

#include "base/text.hpp"
#include "exchange/json.hpp"

namespace manifuzz {
namespace {

/// The largest bound of the points of the first right manifold; `least` where there are none.
double widest(const Admissible& right, double least,
              double (*bound)(const Admissible&, const exact::Clip&, const exact::ClipPoint&)) {
  if (right.candidates.empty()) return least;
  const exact::Clip& first = *right.candidates.front();
  double most = least;
  for (int i = 0; i < first.count; ++i) most = std::max(most, bound(right, first, first.points[i]));
  return most;
}

void append_key(std::string& line, std::string_view key, double value) {
  line += key;
  if (std::isfinite(value)) {
    append_number(line, value);
  } else {
    line += "null";
  }
}

void append_admissible(std::string& line, const Admissible& right) {
  line += ", \"admissible\": [";
  std::string_view separator;
  for (const Manifold<double>& manifold : right_manifolds(right)) {
    line += separator;
    append_manifold_object(line, right.pair(), manifold);
    separator = ", ";
  }
  line += ']';
}

}  // namespace

void append_judgement(std::string& line, const Admissible& right, const Judgement& judgement) {
  const exact::Truth& truth = *right.truth;
  const double condition = right.candidates.empty() ? NAN : 1 / right.candidates.front()->cosine;
  append_key(line, "{\"separation\": ", leading(truth.fine_separation(truth.greatest())));
  line += ", \"touching\": ";
  line += standing(truth).touching ? "true" : "false";
  append_admissible(line, right);
  append_key(line, ", \"condition\": ", condition);
  append_key(line, ", \"bound\": {\"separation\": ", right.bounds.separation);
  append_key(line, ", \"position\": ", widest(right, right.bounds.position, position_bound));
  append_key(line, ", \"depth\": ", widest(right, right.bounds.separation, depth_bound));
  append_key(line, ", \"normal\": ", right.bounds.normal);
  line += "}, \"verdict\": ";
  append_string(line, to_string(judgement.bucket.verdict));
  line += ", \"bucket\": ";
  append_string(line, to_string(judgement.bucket));
  line += '}';
}

}  // namespace manifuzz
