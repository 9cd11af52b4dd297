#include "report/case_lines.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "exchange/json.hpp"
#include "judging/completed.hpp"

namespace manifuzz {
namespace {

bool is_finite(const Manifold<double>& manifold) {
  for (int i = 0; i < manifold.count; ++i) {
    const auto& point = manifold.points[i];
    if (!point.position.allFinite() || !std::isfinite(point.depth)) return false;
  }
  return manifold.count == 0 || manifold.normal.allFinite();
}

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

void append_collision(std::string& line, const Collider& collider, const PairCase& pair) {
  const Answer answer = ask(collider, pair);
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    throw UserError(fmt::format("$: {} gives no answer: {}", collider.declaration.name, lost->why));
  }
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold != nullptr && !is_finite(*manifold)) {
    throw UserError(
        fmt::format("$: {} answers with a number that is not finite; smaller "
                    "coordinates are expected",
                    collider.declaration.name));
  }
  append_answer(line, pair, collider.declaration.name, answer);
}

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
