#include "report/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exchange/json.hpp"
#include "judging/by_curve.hpp"
#include "judging/unjudged.hpp"

namespace manifuzz {
namespace {

/// What is wrong with a collider's answer.
std::string wrong_in_words(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const std::string& name = asked.declaration.name;
  const PairCase& pair = judged.given.pair();
  const double error = error_of_kind(judged.judgement);
  // It is a share of the size; people want to see the length.
  const std::string off = brief(error * size(pair));
  switch (judged.judgement.bucket.kind) {
    case Kind::missed_contact:
      return fmt::format("{} reports no contact, true {}", name, truth_in_words(pair));
    case Kind::phantom_contact:
      return fmt::format("{} reports contact across a {}", name, truth_in_words(pair));
    case Kind::normal:
      return fmt::format("the normal of {} is off by {}", name, brief(error));
    case Kind::position:
      return fmt::format("a point of {} is off by {}", name, off);
    case Kind::depth:
      return fmt::format("a depth of {} is off by {}", name, off);
    case Kind::count:
      return error_of(judged.judgement).component == Component::extra
                 ? fmt::format("{} reports a point too many, {} off", name, off)
                 : fmt::format("{} leaves out a point that is {} deep", name, off);
    case Kind::features:
      return fmt::format("{} names the wrong features", name);
    case Kind::reversed:
      return fmt::format("the normal of {} points from B to A", name);
    case Kind::inconsistent:
      return fmt::format("the depth of {} is off by {}", name, off);
    case Kind::not_minimal:
      return fmt::format("along the normal of {} they overlap by {} more than the least", name,
                         off);
    case Kind::altered_shape:
      return fmt::format("{} used shapes that are off by {}", name, off);
    case Kind::witness:
      return fmt::format("a point of {} is not where they overlap as it says", name);
    default:
      return fmt::format("{} reports {}", name, answer_in_words(asked));
  }
}

/// By tie class.
constexpr std::array<std::string_view, kTieClassNames.size()> kTieWords{
    "they differ within their bounds",
    "two reference faces are nearer than rounding or bias can tell",
    "two incident edges are nearer than rounding can tell", "a depth is zero within rounding",
    "the incident edge ends at a side plane within rounding"};

/// What verdicts mean that say more than their names do; {0} is the subject, {1} the oracle.
constexpr std::array<std::string_view, 7> kVerdictWords{"agree: both are right, and say the same",
                                                        "tie: they differ, and both are right",
                                                        "known: {1} is wrong, as the ledger says",
                                                        "subject_wrong: {0} is wrong",
                                                        "oracle_wrong: {1} is wrong",
                                                        "both_wrong: both are wrong",
                                                        "ill_posed: rounding hides the answer"};

std::string agreement(const JudgedCase& judged) {
  const std::string names =
      fmt::format("{} and {}", judged.subject.declaration.name, judged.oracle.declaration.name);
  const std::string truth = truth_in_words(judged.given.pair());
  if (!touches(judged.subject.answer)) return "agree: " + names + " report no contact, " + truth;
  return fmt::format("agree within rounding: {} report {}", names, answer_in_words(judged.subject));
}

/// Whoever crashed, timed out or answered nonsense.
const DeclaredAnswer& one_that_failed(const JudgedCase& judged) {
  return judged.judgement.bucket.fault == Fault::subject ? judged.subject : judged.oracle;
}

std::string silent_or_nonsense(const JudgedCase& judged, std::string_view what) {
  const DeclaredAnswer& asked = one_that_failed(judged);
  return fmt::format("{} {}", asked.declaration.name, what);
}

/// What became of an answer that the ledger knows to be lost or nonsense.
std::string lost_in_words(const JudgedCase& judged) {
  const auto* const lost = std::get_if<Lost>(&one_that_failed(judged).answer);
  if (lost == nullptr || lost->how == Lost::How::malformed) {
    return silent_or_nonsense(judged, "answered nonsense");
  }
  return silent_or_nonsense(
      judged, lost->how == Lost::How::crashed ? "died on this case" : "gave no answer in time");
}

std::string unsupported_in_words(const JudgedCase& judged) {
  for (const DeclaredAnswer* asked : {&judged.subject, &judged.oracle}) {
    const auto* const unsupported = std::get_if<Unsupported>(&asked->answer);
    if (unsupported == nullptr) continue;
    return fmt::format("{} cannot take this case: {}", asked->declaration.name, unsupported->why);
  }
  return "a collider cannot take this case";
}

std::string features_key(const FeaturePair& features) {
  return feature_name(features.a) + "/" + feature_name(features.b);
}

/// Who fails, and the verb: "box2d is wrong on".
std::string failing_in_words(const JudgedCase& judged) {
  const Bucket& finding = judged.judgement.bucket;
  if (finding.fault == Fault::both) return "both are wrong on";
  if (finding.fault != Fault::none) {
    const bool is_subject = finding.fault == Fault::subject;
    return (is_subject ? judged.subject : judged.oracle).declaration.name + " is wrong on";
  }
  if (finding.verdict == Verdict::agree) return "somebody is wrong on";
  return fmt::format("the verdict is {} on", to_string(finding.verdict));
}

std::ptrdiff_t count_of(const Neighbourhood& neighbourhood, Cell::State state) {
  return std::ranges::count(neighbourhood.cells, state, &Cell::state);
}

}  // namespace

std::string brief(double value) {
  const double size = std::abs(value);
  if (size >= 1e4 && size < 1e6) return fmt::format("{:.0f}", value);  // shorter than 2e+04
  return fmt::format("{:.4g}", value == 0 ? 0 : value);
}

std::string face_name(Side side, int face) {
  return fmt::format("{} face {}", side == Side::a ? 'A' : 'B', face);
}

std::string place_name(Side side, Feature feature) {
  if (feature.kind == Feature::Kind::face) return face_name(side, feature.index);
  return fmt::format("{} vertex {}", side == Side::a ? 'A' : 'B', feature.index);
}

std::string shape_in_words(const ConvexPolygon<float>& shape) {
  // Round corners of radius 0 are told too: a pair of them is judged as round.
  const bool has_round_corners = shape.count >= kMinVertices && shape.is_round();
  const bool has_radius = shape.radius > 0 || has_round_corners;
  const std::string radius = has_radius ? ", radius " + brief(shape.radius) : "";
  if (shape.count == 1) return "circle" + radius;
  if (shape.count == 2) return (shape.radius > 0 ? "capsule" : "segment") + radius;
  return fmt::format("{} vertices", shape.count) + radius +
         (has_round_corners ? ", round corners" : "");
}

std::string truth_in_words(const PairCase& pair) {
  const exact::Truth truth(pair);
  const double separation = exact::separation_of(truth);
  const double above = separation - total_radius(pair);
  if (above > 0) return fmt::format("gap {}", brief(above));
  if (total_radius(pair) > 0) return fmt::format("depth {}", brief(-above));
  return fmt::format("overlap {}", brief(-separation));
}

std::string answer_in_words(const DeclaredAnswer& asked) {
  if (const auto* const lost = std::get_if<Lost>(&asked.answer)) return lost->why;
  if (const auto* const penetration = std::get_if<Penetration>(&asked.answer)) {
    if (!penetration->touches) return "no contact";
    if (!penetration->normal) return "contact";
    return "depth " + brief(penetration->depth);
  }
  const Manifold<double>* const manifold = asked.manifold();
  if (manifold == nullptr) return "unsupported: " + std::get<Unsupported>(asked.answer).why;
  const auto& [first, second] = manifold->points;
  if (asked.count() == 0) return "no contact";
  if (asked.count() == 1) return fmt::format("1 point, depth {}", brief(first.depth));
  return fmt::format("2 points, depths {} and {}", brief(first.depth), brief(second.depth));
}

std::string verdict_sentence(const JudgedCase& judged) {
  switch (judged.judgement.bucket.verdict) {
    case Verdict::agree:
      return agreement(judged);
    case Verdict::tie:
      return fmt::format("tie, both are right: {}",
                         kTieWords[static_cast<std::size_t>(judged.judgement.bucket.tie_class)]);
    case Verdict::known:
      return "oracle wrong (known): " + (is_of_lost(judged.judgement.bucket)
                                             ? lost_in_words(judged)
                                             : wrong_in_words(judged, judged.oracle));
    case Verdict::subject_wrong:
      return "subject wrong: " + wrong_in_words(judged, judged.subject);
    case Verdict::oracle_wrong:
      return "oracle wrong: " + wrong_in_words(judged, judged.oracle);
    case Verdict::both_wrong:
      return fmt::format("both wrong: {}, and {} is wrong too",
                         wrong_in_words(judged, judged.subject), judged.oracle.declaration.name);
    case Verdict::ill_posed:
      return fmt::format("ill-posed: rounding moves these {} by more than 5% of the smaller one",
                         is_round(judged.given.pair()) ? "shapes" : "polygons");
    case Verdict::unsupported:
      return "unsupported: " + unsupported_in_words(judged);
    case Verdict::crashed:
      return "crashed: " + silent_or_nonsense(judged, "died on this case");
    case Verdict::timed_out:
      return "timed out: " + silent_or_nonsense(judged, "gave no answer in time");
    case Verdict::malformed:
      return "malformed: " + silent_or_nonsense(judged, "answered nonsense");
  }
  return {};
}

std::string verdict_and_why(const JudgedCase& judged) {
  const std::string sentence = verdict_sentence(judged);
  if (!is_of_lost(judged.judgement.bucket)) return sentence;
  const DeclaredAnswer& asked = one_that_failed(judged);
  const auto why = why_lost(judged.given.pair(), {asked.declaration, asked.answer});
  return why ? fmt::format("{}: {}", sentence, *why) : sentence;
}

std::string statement_in_words(const ContactSummary& statement) {
  const char clipping = statement.reference == Side::a ? 'A' : 'B';
  using enum ContactSummary::Kind;
  if (statement.kind == nothing) return "no manifold";
  if (statement.kind == apart) return "no contact";
  if (statement.kind == no_clip) {
    return fmt::format("they touch, but the best face, {}'s, clips all away", clipping);
  }
  if (statement.count == 0) return "they touch";  // all that is said of round shapes
  std::string words = fmt::format("{} clips, {}: {}", clipping, counted(statement.count, "point"),
                                  features_key(statement.features[0]));
  if (statement.count > 1) words += " and " + features_key(statement.features[1]);
  return words;
}

std::string grid_in_words(const Grid& grid) {
  return fmt::format(
      "vertex {} of {} moved by up to {} steps each way in its x and y, a step being {} ({})",
      grid.vertex.index, grid.vertex.side == Side::a ? 'A' : 'B', grid.reach,
      counted(grid.step, "ulp"), brief(grid.step * grid.ulp));
}

std::string severity_in_words(const JudgedCase& judged, const Neighbourhood& neighbourhood) {
  const Severity found = severity(neighbourhood, judged.judgement.bucket);
  std::string words =
      fmt::format("severity {:.3g}: {} {} of {}", found.share(), failing_in_words(judged),
                  found.failing, counted(found.valid, "neighbour"));
  if (const auto invalid = count_of(neighbourhood, Cell::State::invalid)) {
    words += fmt::format("; on {} more the polygon is not convex", invalid);
  }
  if (const auto left = count_of(neighbourhood, Cell::State::not_asked)) {
    words += fmt::format("; {} {} not asked", left, left == 1 ? "was" : "were");
  }
  return words;
}

const exact::Clip* candidate_to_show(const Admissible& right, const DeclaredAnswer& subject) {
  const auto find = [&](const auto& wanted) -> const exact::Clip* {
    const auto found = std::ranges::find_if(right.candidates, wanted);
    return found == right.candidates.end() ? nullptr : *found;
  };
  const exact::Clip* const own = find([&](const exact::Clip* clip) {
    return subject.count() > 0 && mismatch(*subject.manifold(), *clip, right).kind == Kind::none;
  });
  if (own != nullptr) return own;
  const exact::Clip* const met =
      find([&](const exact::Clip* clip) { return compare_gap(*clip, 0) <= 0; });
  if (met != nullptr || right.candidates.empty()) return met;
  return right.candidates.front();
}

std::string verdict_in_words(Verdict verdict, const std::string& subject,
                             const std::string& oracle) {
  const auto place = static_cast<std::size_t>(verdict);
  if (place >= kVerdictWords.size()) return std::string(to_string(verdict));
  return fmt::format(fmt::runtime(kVerdictWords[place]), subject, oracle);
}

std::string escape_markdown(std::string_view text) {
  constexpr std::string_view special = "\\`*_{}[]<>()#|~&$@!";
  std::string out;
  for (const char c : text) {
    if (special.find(c) != special.npos) out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

std::string code_block(std::string_view text, std::string_view language) {
  std::string fence = "```";
  while (text.find(fence) != text.npos) fence += '`';
  const std::string_view end = text.ends_with('\n') ? "" : "\n";
  return fmt::format("{}{}\n{}{}{}\n", fence, language, text, end, fence);
}

}  // namespace manifuzz
