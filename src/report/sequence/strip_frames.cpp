#include "report/sequence/strip_frames.hpp"

#include <algorithm>
#include <numbers>
#include <set>

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
  const std::size_t count = judged.given.sequence().frames.size();
  std::vector<std::size_t> wanted{judged.judgement.frame};
  if (const auto birth = birth_of_blamed(judged)) wanted.push_back(*birth);
  if (judged.judgement.frame > 0) wanted.push_back(judged.judgement.frame - 1);
  wanted.push_back(judged.judgement.frame + 1);
  wanted.push_back(0);
  for (std::size_t k = 0; k < count; ++k) {
    if (has_birth(judged, k)) wanted.push_back(k);
  }
  for (std::size_t k = 0; k < count && count <= kStripMax; ++k) wanted.push_back(k);
  std::set<std::size_t> chosen;
  for (const std::size_t frame : wanted) {
    if (frame < count && chosen.size() < kStripMax) chosen.insert(frame);
  }
  return {chosen.begin(), chosen.end()};
}

std::pair<Point, Point> StripFrame::spoke(Side side) const {
  const exact::RoughPolygon& polygon = polygons[side];
  const Point middle = middle_of(polygon.corners());
  if (polygon.count > 1) return {middle, polygon.vertices[0]};
  const auto radius = static_cast<double>(pair[side].polygon.radius);
  return {middle, middle + radius * pair[side].pose.rotation.cast<double>()};
}

double StripFrame::degrees_off(std::size_t i) const {
  const Point& normal = points[i].normal;
  return degrees_between(nearest_truth(*this, normal), normal);
}

bool StripFrame::is_to_blame(std::size_t i) const {
  // A point that is gone is of the frame before.
  return is_wrong() && verdict->kind != Kind::extent && verdict->point == i;
}

bool StripFrame::has_wrong_normal(std::size_t i) const {
  return is_to_blame(i) && (verdict->kind == Kind::normal || verdict->kind == Kind::reversed);
}

StripFrame strip_frame(const JudgedSequence& judged, std::size_t number) {
  StripFrame frame{.number = number, .pair = judged.given.sequence().at(number)};
  frame.polygons = exact::place_roughly(frame.pair);
  frame.rims = rims_of(frame.pair, frame.polygons);
  frame.points = points_in(judged, number);
  frame.truth = true_overlap(frame.pair, judged.subject.declaration);
  const auto& verdicts = judged.judgement.frames;
  if (number < verdicts.size()) frame.verdict = &verdicts[number];
  frame.decides = number == judged.judgement.frame;
  return frame;
}

/// The angle between two directions, in degrees.
double degrees_between(const Point& p, const Point& q) {
  return exact::angle_between(p, q) * 180 / std::numbers::pi;
}

/// The true normal that is nearest to this one.
Point nearest_truth(const StripFrame& frame, const Point& normal) {
  return *std::ranges::min_element(
      frame.truth.normals, {}, [&](const Point& truth) { return degrees_between(truth, normal); });
}

}  // namespace manifuzz
