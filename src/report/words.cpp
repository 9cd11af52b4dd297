#include "report/words.hpp"

#include <cmath>

#include <fmt/format.h>

namespace manifuzz {
namespace {

/// A magnitude is a share of the size; people want to see the length.
double magnitude_length(const JudgedCase& judged) {
  return judged.judgement.magnitude * size(judged.given.pair);
}

/// What is wrong with a collider's answer.
std::string wrong_in_words(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const std::string& name = asked.declaration.name;
  const std::string off = brief(magnitude_length(judged));
  switch (judged.judgement.bucket.kind) {
    case Kind::missed_contact:
      return fmt::format("{} reports no contact, true {}", name, truth_in_words(judged.given.pair));
    case Kind::phantom_contact:
      return fmt::format("{} reports contact across a {}", name, truth_in_words(judged.given.pair));
    case Kind::normal:
      return fmt::format("the normal of {} is off by {}", name, brief(judged.judgement.magnitude));
    case Kind::position:
      return fmt::format("a point of {} is off by {}", name, off);
    case Kind::depth:
      return fmt::format("a depth of {} is off by {}", name, off);
    case Kind::count:
      return fmt::format("{} leaves out a point of depth {}", name, off);
    case Kind::features:
      return fmt::format("{} names the wrong features", name);
    default:
      return fmt::format("{} reports {}", name, answer_in_words(asked));
  }
}

std::string tie_in_words(TieClass tie_class) {
  switch (tie_class) {
    case TieClass::reference:
      return "two reference faces are nearer than rounding or bias can tell";
    case TieClass::incident:
      return "two incident edges are nearer than rounding can tell";
    case TieClass::contact_boundary:
      return "a depth is zero within rounding";
    case TieClass::clip_boundary:
      return "the incident edge ends at a side plane within rounding";
    default:
      return "they differ within their bounds";
  }
}

std::string agreement(const JudgedCase& judged) {
  const std::string names =
      fmt::format("{} and {}", judged.subject.declaration.name, judged.oracle.declaration.name);
  if (judged.subject.count() == 0) {
    return fmt::format("agree: {} report no contact, {}", names, truth_in_words(judged.given.pair));
  }
  return fmt::format("agree within rounding: {} report {}", names, answer_in_words(judged.subject));
}

std::string silent_or_nonsense(const JudgedCase& judged, std::string_view what) {
  const bool of_subject = judged.judgement.bucket.fault == Fault::subject;
  const DeclaredAnswer& asked = of_subject ? judged.subject : judged.oracle;
  return fmt::format("{} {}", asked.declaration.name, what);
}

std::string unsupported_in_words(const JudgedCase& judged) {
  for (const DeclaredAnswer* asked : {&judged.subject, &judged.oracle}) {
    const auto* const unsupported = std::get_if<Unsupported>(&asked->answer);
    if (unsupported == nullptr) continue;
    return fmt::format("{} cannot take this case: {}", asked->declaration.name, unsupported->why);
  }
  return "a collider cannot take this case";
}

}  // namespace

std::string brief(double value) {
  const double size = std::abs(value);
  if (size >= 1e4 && size < 1e6) return fmt::format("{:.0f}", value);  // shorter than 2e+04
  return fmt::format("{:.4g}", value == 0 ? 0 : value);
}

std::string counted(int count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string face_name(Side side, int face) {
  return fmt::format("{} face {}", side == Side::a ? 'A' : 'B', face);
}

std::string truth_in_words(const PairCase& pair) {
  const exact::Truth truth(pair);
  const double separation = leading(truth.fine_separation(truth.greatest()));
  const double above = separation - total_radius(pair);
  if (above > 0) return fmt::format("gap {}", brief(above));
  if (total_radius(pair) > 0) return fmt::format("depth {}", brief(-above));
  return fmt::format("overlap {}", brief(-separation));
}

std::string answer_in_words(const DeclaredAnswer& asked) {
  if (const auto* const lost = std::get_if<Lost>(&asked.answer)) return lost->why;
  const Manifold<double>* const manifold = asked.manifold();
  if (manifold == nullptr) return "unsupported: " + std::get<Unsupported>(asked.answer).why;
  const auto& points = manifold->points;
  switch (asked.count()) {
    case 0:
      return "no contact";
    case 1:
      return fmt::format("1 point, depth {}", brief(points[0].depth));
    default:
      return fmt::format("2 points, depths {} and {}", brief(points[0].depth),
                         brief(points[1].depth));
  }
}

std::string verdict_sentence(const JudgedCase& judged) {
  switch (judged.judgement.bucket.verdict) {
    case Verdict::agree:
      return agreement(judged);
    case Verdict::tie:
      return "tie, both are right: " + tie_in_words(judged.judgement.bucket.tie_class);
    case Verdict::known:
      return "oracle wrong (known): " + wrong_in_words(judged, judged.oracle);
    case Verdict::subject_wrong:
      return "subject wrong: " + wrong_in_words(judged, judged.subject);
    case Verdict::oracle_wrong:
      return "oracle wrong: " + wrong_in_words(judged, judged.oracle);
    case Verdict::both_wrong:
      return fmt::format("both wrong: {}, and {} is wrong too",
                         wrong_in_words(judged, judged.subject), judged.oracle.declaration.name);
    case Verdict::ill_posed:
      return "ill-posed: rounding moves these polygons by more than 5% of the smaller one";
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

}  // namespace manifuzz
