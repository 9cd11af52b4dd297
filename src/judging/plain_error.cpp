#include "judging/plain_error.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

using Fine = exact::Approximate<exact::DoubleDouble>;

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

MeasuredError error_against(const Manifold<double>& manifold, const exact::Clip& clip,
                            const Admissible& right) {
  MeasuredError worst;
  worst.clip = &clip;
  const auto normal = exact::true_normal<Fine>(right.pair(), clip.reference);
  worst.error.normal =
      length(Fine(manifold.normal.x()) - normal.x, Fine(manifold.normal.y()) - normal.y);
  worst.share.normal = worst.error.normal / right.bounds.normal;
  for (int i = 0; i < manifold.count; ++i) {
    std::array<PointError, 2> errors;
    for (int k = 0; k < clip.count; ++k) {
      errors[k] =
          error_of(manifold.points[i], exact::locate<Fine>(right.pair(), clip, clip.points[k].end));
    }
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
  const auto nearest = nearest_error(manifold, right);
  return nearest ? nearest->error : PlainError{};
}

std::optional<MeasuredError> nearest_error(const Manifold<double>& manifold,
                                           const Admissible& right) {
  const auto distance = [](const MeasuredError& measured) {
    return measured.error.position + measured.error.depth;
  };
  std::optional<MeasuredError> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || clip->count == 0) continue;
    const MeasuredError measured = error_against(manifold, *clip, right);
    if (!nearest || distance(measured) < distance(*nearest)) nearest = measured;
  }
  return nearest;
}

std::optional<MeasuredError> measure_error(const Manifold<double>& manifold,
                                           const Admissible& right) {
  std::optional<MeasuredError> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || mismatch(manifold, *clip, right).kind != Kind::none) continue;
    const MeasuredError measured = error_against(manifold, *clip, right);
    if (!nearest || largest(measured.share) < largest(nearest->share)) nearest = measured;
  }
  return nearest;
}

}  // namespace manifuzz
