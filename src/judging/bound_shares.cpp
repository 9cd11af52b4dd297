#include "judging/bound_shares.hpp"

#include <cmath>

#include "judging/by_curve.hpp"
#include "judging/curve_answer.hpp"

namespace manifuzz {

ManifoldError clip_shares(const Manifold<double>& manifold, const Admissible& right) {
  if (manifold.count == 0) return {};
  ClipFiguresCache figures;
  const auto nearest = error_if_right(manifold, right, figures);
  return nearest ? nearest->of_bound : ManifoldError{};
}

double curve_share(const exact::Truth& truth, const ColliderAnswer& given) {
  const Declaration& declaration = given.declaration;
  const auto said = said_along(given.answer);
  const bool is_held_to_bounds = declaration.tie_bias.is_none() && declaration.tolerance.is_none();
  if (!said || !touches(given.answer) || !is_held_to_bounds) return 0;
  const CurveBounds bounds = with_turned_faces(
      truth, said_by(given.answer), curve_bounds(truth.pair(), declaration, truth.extent()));
  const exact::PenetrationCurve curve(truth, exact::skin_of(truth));
  return std::abs(said->depth - curve.least()) / bounds.minimality;
}

}  // namespace manifuzz
