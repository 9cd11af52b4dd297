#include "judging/properties_shared.hpp"

#include <cmath>

namespace manifuzz {

std::optional<Admissible> decided(const PairCase& pair, const Declaration& declaration) {
  Admissible right = admissible(pair, declaration);
  if (is_ill_posed(pair, right.bounds) || right.candidates.size() != 1) return std::nullopt;
  const exact::Clip& only = *right.candidates.front();
  const double undecided = declaration.tie_bias + right.bounds.separation;
  const bool leads = right.truth->compare_lead_of_b(undecided) > 0 ||
                     right.truth->compare_lead_of_b(-undecided) < 0;
  if (!leads || right.may_be_apart || only.count < 2 || may_miss(right, only)) return std::nullopt;
  for (const exact::ClipPoint& point : only.points) {
    if (!features_decided(right, only, point) || is_at_zero_depth(right, only, point)) {
      return std::nullopt;
    }
  }
  return right;
}

ManifoldError tolerance(const Admissible& right) {
  ManifoldError within{.normal = 2 * right.bounds.normal};
  const exact::Clip& clip = *right.candidates.front();
  for (const exact::ClipPoint& point : points_of(clip)) {
    widen(within, {.position = 2 * position_bound(right, clip, point),
                   .depth = 2 * depth_bound(right, clip, point)});
  }
  return within;
}

Outcome same_manifold(const PairCase& pair, const Manifold<double>& expected,
                      const Manifold<double>& got, const ManifoldError& within, Features features) {
  const double unit = size(pair);
  if (expected.count != got.count) return fails("another number of points", 1);
  if (expected.count == 0) return holds();
  if (expected.reference != got.reference) return fails("another reference polygon", 1);
  const double turn = (expected.normal - got.normal).norm();
  if (!(turn <= within.normal)) return fails("another normal", turn);
  for (int i = 0; i < expected.count; ++i) {
    const auto& p = expected.points[i];
    const auto& q = got.points[i];
    const double off = (p.position - q.position).norm();
    if (!(off <= within.position)) return fails("another position", off / unit);
    const double deeper = std::abs(p.depth - q.depth);
    if (!(deeper <= within.depth)) return fails("another depth", deeper / unit);
    if (features == Features::compared && p.features != q.features) {
      return fails("other features", 0);
    }
  }
  return holds();
}

}  // namespace manifuzz
