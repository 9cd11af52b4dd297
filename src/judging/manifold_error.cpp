#include "judging/manifold_error.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/exact/figures.hpp"

namespace manifuzz {
namespace {

using Fine = ClipFigures::Number;

double length(const Fine& x, const Fine& y) {
  return exact::leading(sqrt(x * x + y * y).value);
}

ManifoldError error_of(const ContactPoint<double>& reported, const exact::Located<Fine>& truth) {
  return {.position = length(Fine(reported.position.x()) - truth.position.x,
                             Fine(reported.position.y()) - truth.position.y),
          .depth = std::abs(exact::leading((Fine(reported.depth) - truth.depth).value))};
}

double largest(const ManifoldError& share) {
  return std::max({share.normal, share.position, share.depth});
}

}  // namespace

void widen(ManifoldError& worst, const ManifoldError& other) {
  worst.normal = std::max(worst.normal, other.normal);
  worst.position = std::max(worst.position, other.position);
  worst.depth = std::max(worst.depth, other.depth);
}

ManifoldError share_of_size(const ManifoldError& error, double size) {
  return {error.normal, error.position / size, error.depth / size};
}

ClipFigures::ClipFigures(const exact::Clip& of)
    : clip(&of), normal(exact::true_normal<Number>(of)) {
  for (int k = 0; k < of.count; ++k) points[k] = exact::locate<Number>(of, of.points[k].end);
}

const ClipFigures& ClipFiguresCache::of(const exact::Clip& clip) {
  const auto known =
      std::ranges::find(known_, &clip, [](const auto& figures) { return figures->clip; });
  if (known != known_.end()) return **known;
  return *known_.emplace_back(std::make_unique<const ClipFigures>(clip));
}

ErrorAgainstClip error_against(const Manifold<double>& manifold, const ClipFigures& truth,
                               const Bounds& bounds) {
  const exact::Clip& clip = *truth.clip;
  ManifoldError error{.normal = length(Fine(manifold.normal.x()) - truth.normal.x,
                                       Fine(manifold.normal.y()) - truth.normal.y)};
  ManifoldError of_bound{.normal = error.normal / bounds.normal};
  for (int i = 0; i < manifold.count; ++i) {
    std::array<ManifoldError, 2> errors;
    for (int k = 0; k < clip.count; ++k) errors[k] = error_of(manifold.points[i], truth.points[k]);
    const int k = clip.count > 1 && errors[1].position < errors[0].position ? 1 : 0;
    const exact::ClipPoint& point = clip.points[k];
    widen(error, errors[k]);
    widen(of_bound, {.position = errors[k].position / position_bound(bounds, clip, point),
                     .depth = errors[k].depth / depth_bound(bounds, clip, point)});
  }
  return {error, of_bound, &clip};
}

ManifoldError plain_error(const Manifold<double>& manifold, const Admissible& right) {
  const bool may_be_empty = right.may_be_apart || !right.may_touch;
  if (manifold.count == 0 && may_be_empty) return {};
  if (manifold.count == 0 || right.candidates.empty()) {
    return {.depth = right.from_contact()};
  }
  ClipFiguresCache figures;
  const auto nearest = nearest_error(manifold, right, figures);
  return nearest ? nearest->error : ManifoldError{};
}

std::optional<ErrorAgainstClip> nearest_error(const Manifold<double>& manifold,
                                              const Admissible& right, ClipFiguresCache& figures) {
  const auto distance = [](const ErrorAgainstClip& measured) {
    return measured.error.position + measured.error.depth;
  };
  std::optional<ErrorAgainstClip> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || clip->count == 0) continue;
    const ErrorAgainstClip measured = error_against(manifold, figures.of(*clip), right.bounds);
    if (!nearest || distance(measured) < distance(*nearest)) nearest = measured;
  }
  return nearest;
}

std::optional<ErrorAgainstClip> error_if_right(const Manifold<double>& manifold,
                                               const Admissible& right) {
  ClipFiguresCache figures;
  return error_if_right(manifold, right, figures);
}

std::optional<ErrorAgainstClip> error_if_right(const Manifold<double>& manifold,
                                               const Admissible& right, ClipFiguresCache& figures) {
  std::optional<ErrorAgainstClip> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || mismatch(manifold, *clip, right).kind != Kind::none) continue;
    const ErrorAgainstClip measured = error_against(manifold, figures.of(*clip), right.bounds);
    if (!nearest || largest(measured.of_bound) < largest(nearest->of_bound)) nearest = measured;
  }
  return nearest;
}

}  // namespace manifuzz
