#include "judging/bound_shares.hpp"

#include <algorithm>

#include "judging/by_curve.hpp"
#include "judging/curve_answer.hpp"

namespace manifuzz {

ManifoldError clip_shares(const Manifold<double>& manifold, const Admissible& right) {
  if (manifold.count == 0) return {};
  ClipFiguresCache figures;
  const auto nearest = error_if_right(manifold, right, figures);
  return nearest ? nearest->of_bound : ManifoldError{};
}

ManifoldError curve_shares(const exact::Truth& truth, const ColliderAnswer& given) {
  const Declaration& declaration = given.declaration;
  const Said said = said_by(given.answer);
  const bool is_held_to_bounds = declaration.tie_bias.is_none() && declaration.tolerance.is_none();
  if (!said.touches || !said.normal || said.normal->isZero(0) || !is_held_to_bounds) return {};
  const CurveAnswer answer(truth, declaration, said,
                           curve_bounds(truth.pair(), declaration, truth.extent()));
  const exact::Along along(truth, *said.normal);
  // What little of a gap's slope is left, and roundings, may take a right answer past its bound.
  const bool is_apart = said.depth < 0;  // across a gap any normal will do
  return {.normal = is_apart ? 0 : std::min(answer.normal_share(along), 1.0),
          .depth = std::min(answer.depth_share(along), 1.0)};
}

}  // namespace manifuzz
