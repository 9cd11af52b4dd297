#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exact/curve.hpp"
#include "judging/bounds.hpp"
#include "report/rows.hpp"
#include "report/sequence/sequence_report.hpp"
#include "report/words.hpp"
#include "sequence/frame_judge.hpp"
#include "sequence/motions.hpp"

namespace manifuzz {
namespace {

/// What is wrong in a frame of a kind; `off` is by how much, `is_kept`: with a point that is not
/// new.
std::string wrong_in_words(Kind kind, bool is_kept, const std::string& off) {
  switch (kind) {
    case Kind::missed_contact:
      return "nothing is kept, and they overlap by " + off;
    case Kind::phantom_contact:
      return "a new point where they are apart by " + off;
    case Kind::normal:
      return (is_kept ? "the normal did not turn with its body: off by "
                      : "a new point's normal is off by ") +
             off;
    case Kind::depth:
      return "no point is as deep as they overlap: short by " + off;
    case Kind::position:
      return "an anchor has moved on its body by " + off;
    case Kind::reversed:
      return "a new point's normal points from B to A";
    case Kind::inconsistent:
      return "a depth is not what lies between its anchors, off by " + off;
    case Kind::not_minimal:
      return "along a new point's normal they overlap by " + off + " more than the least";
    case Kind::witness:
      return "a new point is not where they overlap as it says, off by " + off;
    case Kind::extent:
      return "a point is gone that should be kept: " + off + " of the contact is lost";
    case Kind::lingering:
      return "a point is kept past what is declared, by " + off;
    default:
      return std::string(name_of(kind, kKindNames));
  }
}

/// The angle between unit vectors that differ by so much.
std::string turn_in_words(double difference) {
  const double degrees = 360 / std::numbers::pi * std::asin(std::min(difference / 2, 1.0));
  return degrees < 10 ? fmt::format("{:.2g} degrees", degrees)
                      : fmt::format("{:.0f} degrees", degrees);
}

/// "0.02 of the smaller shape".
std::string length_in_words(const ShapeLength& length) {
  if (length.relative == 0) return brief(length.absolute);
  const std::string share = brief(length.relative) + " of the smaller shape";
  return length.absolute == 0 ? share : brief(length.absolute) + " and " + share;
}

}  // namespace

TrueOverlap true_overlap(const PairCase& pair, const Declaration& subject) {
  const exact::Truth truth(pair);
  const exact::PenetrationCurve curve(truth, exact::skin_of(truth));
  const double bound = bounds(pair, subject).separation;
  TrueOverlap contact{curve.least(), {}};
  for (const Vector2<double>& normal : curve.minima(std::isfinite(bound) ? bound : 0)) {
    contact.normals.push_back(world_normal(pair, normal));
  }
  return contact;
}

std::vector<KeptPoint> points_in(const JudgedSequence& judged, std::size_t frame) {
  if (frame >= judged.answers.size()) return {};
  const auto* const kept = std::get_if<KeptManifold>(&judged.answers[frame]);
  return kept != nullptr ? kept->points : std::vector<KeptPoint>();
}

std::string frame_in_words(const JudgedSequence& judged, std::size_t frame) {
  if (frame >= judged.answers.size()) return "not asked";
  const KeptAnswer& answer = judged.answers[frame];
  if (const auto* const lost = std::get_if<Lost>(&answer)) return printable(lost->why, 200);
  if (const auto* const cannot = std::get_if<Unsupported>(&answer)) {
    return "unsupported: " + printable(cannot->why, 200);
  }
  if (frame >= judged.judgement.frames.size()) {
    const auto why = why_malformed(judged.subject.keeping, judged.answers, frame);
    return why ? "malformed: " + *why : "not judged";
  }
  const FrameJudgement& verdict = judged.judgement.frames[frame];
  if (verdict.is_ill_posed) return "rounding hides the answer";
  if (verdict.kind == Kind::none) return "right";
  const double length = verdict.magnitude * size(judged.given.sequence().at(frame));
  const bool is_direction = verdict.kind == Kind::normal;
  const std::vector<KeptPoint> points = points_in(judged, frame);
  const bool is_kept = verdict.point && *verdict.point < points.size() &&
                       points[*verdict.point].born != static_cast<int>(frame);
  return wrong_in_words(verdict.kind, is_kept,
                        is_direction ? turn_in_words(verdict.magnitude) : brief(length));
}

std::string verdict_sentence(const JudgedSequence& judged) {
  const SequenceJudgement& judgement = judged.judgement;
  const std::string& name = judged.subject.declaration.name;
  const std::string words = frame_in_words(judged, judgement.frame);
  const std::size_t frames = judged.given.sequence().frames.size();
  switch (judgement.bucket.verdict) {
    case Verdict::agree:
      return fmt::format("{} is right in {}{}", name, frames == 1 ? "" : "each of ",
                         counted(frames, "frame"));
    case Verdict::known:
      return fmt::format("{} is wrong in frame {} (known): {}", name, judgement.frame, words);
    case Verdict::subject_wrong:
      return fmt::format("{} is wrong in frame {}: {}", name, judgement.frame, words);
    default:
      return fmt::format("{}, {} in frame {}: {}", to_string(judgement.bucket.verdict), name,
                         judgement.frame, words);
  }
}

std::string keeper_line(const SequenceCollider& keeper) {
  const Declaration& declared = keeper.declaration;
  const Keeping& keeping = keeper.keeping;
  std::string limits =
      fmt::format("keeps up to {}, gap {}, drift {}", counted(keeping.points_max, "point"),
                  length_in_words(keeping.gap), length_in_words(keeping.drift));
  if (std::isfinite(keeping.turn)) limits += fmt::format(", turn {} rad", brief(keeping.turn));
  limits += keeping.since == StaleSince::birth ? " since birth" : " since each refresh";
  return fmt::format("{:<17} {} ({}, {}, {})\n", declared.name, declared.description,
                     declared.version, declared.scalar == ScalarType::float32 ? "float" : "double",
                     limits);
}

std::string list_motions() {
  return lines_of(motions(), [](const Motion& motion) {
    return fmt::format("{:<16} {}\n", motion.name, motion.description);
  });
}

std::string sequence_heading(const CampaignResult& result, std::uint64_t seed) {
  const double seconds = result.seconds();
  return fmt::format(
      "{}: {}, {} in {:.1f} s ({:.0f} frames a second, {}), "
      "seed {}\n",
      result.settings.subject, counted(result.cases(), "sequence"),
      counted(result.frames(), "frame"), seconds,
      seconds > 0 ? static_cast<double>(result.frames()) / seconds : 0, counted(result.jobs, "job"),
      seed);
}

std::string motion_rows(const CampaignResult& result) {
  static constexpr std::string_view row = "{:<18}{:>10}{:>10}{:>10}{:>8}{:>8}{:>8}{:>8}{:>8}\n";
  std::string text = fmt::format(row, "motion", "sequences", "frames", "touching", "right", "wrong",
                                 "known", "lost", "other");
  for (const RegimeResult& motion : result.regimes) {
    std::array<std::uint64_t, kVerdictNames.size()> counts{};
    for (const BucketResult& found : result.buckets) {
      const auto bucket = find_bucket(found.bucket);
      const auto count = found.regimes.find(motion.name);
      if (!bucket || count == found.regimes.end()) continue;
      counts[static_cast<std::size_t>(bucket->verdict)] += count->second;
    }
    const auto of = [&](Verdict verdict) { return counts[static_cast<std::size_t>(verdict)]; };
    std::uint64_t met = 0;
    for (const std::uint64_t count : counts) met += count;
    const std::uint64_t wrong = of(Verdict::subject_wrong);
    const std::uint64_t lost =
        of(Verdict::crashed) + of(Verdict::timed_out) + of(Verdict::malformed);
    const std::uint64_t known = of(Verdict::known);
    text += fmt::format(row, motion.name, motion.cases, motion.frames, motion.touching,
                        motion.cases - met, wrong, known, lost, met - wrong - lost - known);
  }
  return text;
}

}  // namespace manifuzz
