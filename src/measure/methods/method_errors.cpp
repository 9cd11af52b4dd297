#include "measure/methods/method_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz {
namespace {

/// The share of the clip's extent that is enough: what is kept moves by a little without being any
/// the less complete.
constexpr double kSpannedShare = 0.95;

/// In frames: a contact that is over before is not one that lasted.
constexpr int kLasting = 4;

}  // namespace

TrueContact::TrueContact(const PairCase& pair)
    : truth(std::make_shared<const exact::Truth>(pair)),
      curve(*truth, exact::skin_of(*truth)),
      for_float(admissible(truth, Declaration{})),
      clip(clip_now(for_float)) {}

void MethodCollector::add(std::uint64_t index, const TrueContact& truth,
                          const Declaration& declaration, const TouchingPoints& said,
                          bool is_start) {
  if (is_start) {
    end_contact();
    clip_before_ = {};
  }
  if (!said.is_answered) {
    clip_before_ = {};
    return;
  }
  ++counts_.cases;
  if (said.touches && !truth.for_float.may_touch) ++counts_.phantom;
  ExtentLeftOut left;
  if (truth.for_float.must_touch) {
    ++counts_.contacts;
    if (!said.touches) ++counts_.missed;
    left = extent_left_out(*truth.truth, {},
                           bounds(truth.truth->pair(), declaration, truth.truth->extent()),
                           said.ends());
    points_missing_ += left.points;
    if (const auto share = left.share()) {
      extent_lost_ += *share;
      ++extents_;
    }
    if (said.touches) add_errors(index, truth, said);
  }
  add_frame(truth, left, said, is_start);
}

void MethodCollector::add_errors(std::uint64_t index, const TrueContact& truth,
                                 const TouchingPoints& said) {
  // Faces that rounding cannot tell apart are right alike.
  const auto minima = truth.curve.minima(2 * truth.for_float.bounds.separation);
  double normal = INFINITY;
  for (const Vector2<double>& right : minima) {
    normal = std::min(normal, (said.normal - right).norm());
  }
  const double depth = std::abs(said.depth - truth.curve.least());
  constexpr double unit = 0x1p-24;
  const double length = unit * truth.truth->extent();
  of_extent_.add(index, {.normal = normal / unit, .position = 0, .depth = depth / length});
  of_size_.add(index, {.normal = normal, .position = 0, .depth = depth / truth.truth->size()});
}

void MethodCollector::add_frame(const TrueContact& truth, const ExtentLeftOut& left,
                                const TouchingPoints& said, bool is_start) {
  const double off = 2 * (truth.for_float.bounds.position + truth.for_float.bounds.separation);
  points_ += said.points.size();
  lingering_ += static_cast<std::uint64_t>(lingering_points(truth.truth->pair(), said, off));
  if (!is_start && truth.clip.is_decided && truth.clip == clip_before_) {
    ++steps_;
    if (said.points.size() != points_before_) ++flickers_;
  }
  clip_before_ = truth.clip;
  points_before_ = said.points.size();
  if (!truth.clip.is_decided || truth.clip.count < 2) return end_contact();
  ++lasting_.frames;
  const bool is_complete =
      left.points == 0 && left.lost <= (1 - kSpannedShare) * left.run + left.bound;
  if (is_complete && !lasting_.complete_after) lasting_.complete_after = lasting_.frames;
}

void MethodCollector::end_contact() {
  if (lasting_.frames >= kLasting) completed_.push_back(lasting_.complete_after);
  lasting_ = {};
}

MethodErrors MethodCollector::errors() const {
  MethodErrors errors = counts_;
  errors.of_extent = of_extent_.spreads();
  errors.of_size = of_size_.spreads();
  const auto mean = [](double sum, std::uint64_t of) {
    return of > 0 ? sum / static_cast<double>(of) : 0;
  };
  errors.points_missing = mean(points_missing_, counts_.contacts);
  errors.extent_lost = mean(extent_lost_, extents_);
  return errors;
}

FrameErrors MethodCollector::frames() const {
  MethodCollector ended = *this;
  ended.end_contact();
  FrameErrors errors;
  std::vector<double> after;
  double completed = 0;
  for (const std::optional<int>& frames : ended.completed_) {
    after.push_back(frames ? static_cast<double>(*frames)
                           : std::numeric_limits<double>::infinity());
    completed += frames ? 1 : 0;
  }
  const auto share = [](double count, double of) { return of > 0 ? count / of : 0; };
  errors.completed = share(completed, static_cast<double>(after.size()));
  if (errors.completed > 0.5) errors.frames_to_complete = median(after);
  errors.lingering = share(static_cast<double>(lingering_), static_cast<double>(points_));
  errors.flicker = share(static_cast<double>(flickers_), static_cast<double>(steps_));
  return errors;
}

}  // namespace manifuzz
