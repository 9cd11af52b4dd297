#include "judging/plain_error.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

using Fine = FineClip::Number;

double length(const Fine& x, const Fine& y) {
  return exact::leading(sqrt(x * x + y * y).value);
}

struct PointError {
  double position = 0;
  double depth = 0;
};

PointError error_of(const ContactPoint<double>& reported, const exact::Located<Fine>& truth) {
  return {length(Fine(reported.position.x()) - truth.position.x,
                 Fine(reported.position.y()) - truth.position.y),
          std::abs(exact::leading((Fine(reported.depth) - truth.depth).value))};
}

double largest(const PlainError& share) {
  return std::max({share.normal, share.position, share.depth});
}

}  // namespace

FineClip::FineClip(const PairCase& pair, const exact::Clip& of)
    : clip(&of), normal(exact::true_normal<Number>(pair, of.reference)) {
  for (int k = 0; k < of.count; ++k) {
    points[k] = exact::locate<Number>(pair, of, of.points[k].end);
  }
}

const FineClip& FineClips::of(const PairCase& pair, const exact::Clip& clip) {
  const auto known = std::ranges::find(known_, &clip, [](const auto& fine) { return fine->clip; });
  if (known != known_.end()) return **known;
  return *known_.emplace_back(std::make_unique<const FineClip>(pair, clip));
}

MeasuredError error_against(const Manifold<double>& manifold, const FineClip& truth,
                            const Admissible& right) {
  const exact::Clip& clip = *truth.clip;
  MeasuredError worst;
  worst.clip = &clip;
  worst.error.normal = length(Fine(manifold.normal.x()) - truth.normal.x,
                              Fine(manifold.normal.y()) - truth.normal.y);
  worst.share.normal = worst.error.normal / right.bounds.normal;
  for (int i = 0; i < manifold.count; ++i) {
    std::array<PointError, 2> errors;
    for (int k = 0; k < clip.count; ++k) errors[k] = error_of(manifold.points[i], truth.points[k]);
    const int k = clip.count > 1 && errors[1].position < errors[0].position ? 1 : 0;
    const PointError& off = errors[k];
    worst.error.position = std::max(worst.error.position, off.position);
    worst.error.depth = std::max(worst.error.depth, off.depth);
    worst.share.position =
        std::max(worst.share.position, off.position / position_bound(right, clip, clip.points[k]));
    worst.share.depth =
        std::max(worst.share.depth, off.depth / depth_bound(right, clip, clip.points[k]));
  }
  return worst;
}

PlainError plain_error(const Manifold<double>& manifold, const Admissible& right) {
  const bool may_be_empty = right.may_be_apart || !right.may_touch;
  if (manifold.count == 0 && may_be_empty) return {};
  if (manifold.count == 0 || right.candidates.empty()) {
    return {.normal = 0, .position = 0, .depth = right.from_contact()};
  }
  FineClips fine;
  const auto nearest = nearest_error(manifold, right, fine);
  return nearest ? nearest->error : PlainError{};
}

std::optional<MeasuredError> nearest_error(const Manifold<double>& manifold,
                                           const Admissible& right, FineClips& fine) {
  const auto distance = [](const MeasuredError& measured) {
    return measured.error.position + measured.error.depth;
  };
  std::optional<MeasuredError> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || clip->count == 0) continue;
    const MeasuredError measured = error_against(manifold, fine.of(right.pair(), *clip), right);
    if (!nearest || distance(measured) < distance(*nearest)) nearest = measured;
  }
  return nearest;
}

std::optional<MeasuredError> measure_error(const Manifold<double>& manifold,
                                           const Admissible& right) {
  FineClips fine;
  return measure_error(manifold, right, fine);
}

std::optional<MeasuredError> measure_error(const Manifold<double>& manifold,
                                           const Admissible& right, FineClips& fine) {
  std::optional<MeasuredError> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || mismatch(manifold, *clip, right).kind != Kind::none) continue;
    const MeasuredError measured = error_against(manifold, fine.of(right.pair(), *clip), right);
    if (!nearest || largest(measured.share) < largest(nearest->share)) nearest = measured;
  }
  return nearest;
}

}  // namespace manifuzz
