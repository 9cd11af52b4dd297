#include "report/sequence/strip_frames.hpp"

#include <algorithm>
#include <set>

#include "report/sequence/sequence_report.hpp"

namespace manifuzz {
namespace {

/// The point that is to blame in the deciding frame was born there; nothing where it is no point.
std::optional<std::size_t> birth_of_blamed(const JudgedSequence& judged) {
  const SequenceJudgement& judgement = judged.judgement;
  if (judgement.frame >= judgement.frames.size()) return std::nullopt;
  const FrameJudgement& verdict = judgement.frames[judgement.frame];
  // A point that is gone is of the frame before.
  const bool is_gone = verdict.kind == Kind::extent && judgement.frame > 0;
  const auto points = points_in(judged, judgement.frame - (is_gone ? 1 : 0));
  if (!verdict.point || *verdict.point >= points.size()) return std::nullopt;
  return static_cast<std::size_t>(points[*verdict.point].born);
}

bool has_birth(const JudgedSequence& judged, std::size_t frame) {
  return std::ranges::any_of(points_in(judged, frame), [frame](const KeptPoint& point) {
    return point.born == static_cast<int>(frame);
  });
}

}  // namespace

std::vector<std::size_t> frames_that_matter(const JudgedSequence& judged) {
  const std::size_t count = judged.given.frames.size();
  std::vector<std::size_t> wanted{judged.judgement.frame};
  if (const auto birth = birth_of_blamed(judged)) wanted.push_back(*birth);
  if (judged.judgement.frame > 0) wanted.push_back(judged.judgement.frame - 1);
  wanted.push_back(judged.judgement.frame + 1);
  wanted.push_back(0);
  for (std::size_t k = 0; k < count; ++k) {
    if (has_birth(judged, k)) wanted.push_back(k);
  }
  for (std::size_t k = 0; k < count; ++k) wanted.push_back(k);
  std::set<std::size_t> chosen;
  for (const std::size_t frame : wanted) {
    if (frame < count && chosen.size() < kStripMax) chosen.insert(frame);
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace manifuzz
