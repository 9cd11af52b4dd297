#include <cmath>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exact/curve.hpp"
#include "exchange/json.hpp"
#include "judging/by_curve.hpp"
#include "judging/manifold_error.hpp"
#include "judging/used_shapes.hpp"
#include "report/outputs.hpp"
#include "report/words.hpp"

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
  append_number(line, value);
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

/// The least depth, and the unit normals, in the world, at which it is least within the bound.
void append_penetration(std::string& line, const Admissible& right) {
  const exact::PenetrationCurve curve(*right.truth, exact::skin_of(*right.truth));
  const double bound = std::isfinite(right.bounds.separation) ? right.bounds.separation : 0;
  append_key(line, ", \"penetration\": {\"depth\": ", curve.least());
  line += ", \"normals\": [";
  std::string_view separator;
  for (const Vector2<double>& normal : curve.minima(bound)) {
    line += separator;
    append_vector(line, world_normal(right.pair(), normal));
    separator = ", ";
  }
  line += "]}";
}

/// What the curve makes of an answer, null for what is not claimed.
void append_by_curve(std::string& line, const exact::Truth& truth, const ColliderAnswer& subject,
                     Verdict verdict) {
  CurveJudgement curve;
  // From ill_posed on, nothing was judged.
  if (is_judged_by_curve(subject.declaration, truth.pair()) && verdict < Verdict::ill_posed) {
    const auto altered = altered_by(truth, subject);
    const exact::Truth* const used = altered ? altered->truth.get() : &truth;
    if (used != nullptr) curve = judge_by_curve(*used, subject.declaration, subject.answer);
  }
  append_key(line, ", \"excess\": ", curve.excess.value_or(NAN));
  const auto append = [&line](std::string_view key, const std::optional<bool>& is_so) {
    line += key;
    line += !is_so ? "null" : *is_so ? "true" : "false";
  };
  append(", \"consistent\": ", curve.consistent);
  append(", \"minimal\": ", curve.minimal);
  append(", \"witness\": ", curve.witness);
}

/// Appends how wrong the subject's answer is.
void append_errors(std::string& line, const AnswerError& error) {
  std::string_view separator = ", \"errors\": {";
  for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
    append_key(line, fmt::format("{}\"{}\": ", separator, kComponentNames[i]),
               error.errors.all()[i]);
    separator = ", ";
  }
  append_key(line, "}, \"magnitude\": ", error.magnitude);
}

}  // namespace

void append_judgement(std::string& line, const Admissible& right, const ColliderAnswer& subject,
                      const Judgement& judgement) {
  const exact::Truth& truth = *right.truth;
  const double condition = right.candidates.empty() ? NAN : 1 / right.candidates.front()->cosine;
  append_key(line, "{\"separation\": ", exact::separation_of(truth));
  line += standing(truth).touching ? ", \"touching\": true" : ", \"touching\": false";
  append_admissible(line, right);
  append_penetration(line, right);
  append_by_curve(line, *right.truth, subject, judgement.bucket.verdict);
  append_key(line, ", \"condition\": ", condition);
  append_key(line, ", \"bound\": {\"separation\": ", right.bounds.separation);
  append_key(line, ", \"position\": ", widest(right, right.bounds.position, position_bound));
  append_key(line, ", \"depth\": ", widest(right, right.bounds.separation, depth_bound));
  append_key(line, ", \"normal\": ", right.bounds.normal);
  line += fmt::format("}}, \"verdict\": \"{}\", \"bucket\": \"{}\"",
                      to_string(judgement.bucket.verdict), to_string(judgement.bucket));
  const LedgerEntry* const known = judgement.explanation;
  if (known != nullptr) line += fmt::format(", \"ledger\": \"{0}\", \"cause\": \"{0}\"", known->id);
  append_errors(line, judgement.of_subject);
  line += '}';
}

}  // namespace manifuzz
