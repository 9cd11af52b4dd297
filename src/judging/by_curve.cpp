#include "judging/by_curve.hpp"

#include <cmath>

#include "judging/curve_answer.hpp"
#include "judging/extent.hpp"
#include "judging/second_point.hpp"

namespace manifuzz {
namespace {

using exact::Along;
using exact::PenetrationCurve;

/// A judgement as it is made, one part of the answer after the other.
class ByCurve {
 public:
  explicit ByCurve(const CurveAnswer& answer) : answer_(answer) {}

  CurveJudgement judge() {
    const Said& said = answer_.said();
    const CurveBounds& within = answer_.within();
    if (!answer_.touches_as_it_should()) {
      return found(said.touches ? Kind::phantom_contact : Kind::missed_contact,
                   std::abs(answer_.curve().least()), within.touching);
    }
    if (!said.normal) return result_;
    const double off_unit = std::abs(said.normal->norm() - 1);
    if (!(off_unit <= within.normal)) return found(Kind::normal, off_unit, within.normal);
    const Along along(answer_.truth(), *said.normal);
    result_.excess = answer_.curve().excess(along);
    result_.consistent = answer_.is_depth(along, said.depth);
    // Across a gap any normal will do.
    if (said.touches && said.depth >= 0) result_.minimal = answer_.is_minimal(along);
    const bool is_right = *result_.consistent && result_.minimal.value_or(true);
    if (!is_right && answer_.is_reversed()) return found(Kind::reversed, 2, within.normal);
    if (*result_.consistent && !is_right && answer_.is_least(along)) {
      return found(Kind::normal, answer_.nearest().error(*said.normal), answer_.nearest().bound());
    }
    if (!*result_.consistent) {
      return found(Kind::inconsistent, answer_.depth_error(along), within.consistency);
    }
    if (!result_.minimal.value_or(true)) {
      return found(Kind::not_minimal, std::abs(*result_.excess), within.minimality);
    }
    return said.manifold == nullptr ? result_ : judge_points(along);
  }

 private:
  CurveJudgement judge_points(const Along& along) {
    result_.witness = answer_.has_witnesses(along);
    if (!*result_.witness) return found(Kind::witness, 0, answer_.within().along);
    const Declaration& declaration = answer_.declaration();
    if (declaration.claims != Claims::manifold) return result_;
    const exact::Truth& truth = answer_.truth();
    const Manifold<double>& manifold = *answer_.said().manifold;
    const Bounds of_clip = bounds(truth.pair(), declaration, truth.extent());
    const auto second =
        answer_.is_round()
            ? second_point_mismatch(truth, declaration, of_clip, manifold)
            : extent_mismatch(truth, declaration, of_clip, answer_.tolerance(), manifold);
    if (!second) return result_;
    result_.missing = second->missing;
    return found(second->kind, second->magnitude, second->bound);
  }

  CurveJudgement found(Kind kind, double magnitude, double bound) {
    result_.kind = kind;
    result_.magnitude = magnitude;
    result_.bound = bound;
    return result_;
  }

  const CurveAnswer& answer_;
  CurveJudgement result_;
};

}  // namespace

double tolerance_of(const exact::Truth& truth, const Declaration& declaration) {
  const Tolerance& tolerance = declaration.tolerance;
  if (tolerance.is_none()) return 0;
  const double least = PenetrationCurve(truth, exact::skin_of(truth)).least();
  return tolerance.absolute + tolerance.relative * std::abs(least);
}

CurveBounds curve_bounds(const PairCase& pair, const Declaration& declaration, double extent) {
  const Bounds of_clip = bounds(pair, declaration, extent);
  const double turned = of_clip.normal * (extent + total_radius(pair));
  return {.consistency = of_clip.separation + turned,
          .minimality = 2 * of_clip.separation + turned,
          .along = of_clip.position + of_clip.separation,
          .across = of_clip.position,
          .narrow = of_clip.position,
          .touching = of_clip.separation,
          .normal = of_clip.normal,
          .direction = of_clip.normal,
          .world_vertex = of_clip.world_vertex};
}

CurveJudgement judge_by_curve(const exact::Truth& truth, const Declaration& declaration,
                              const Answer& answer, const CurveBounds& bounds) {
  const Said said = said_by(answer);
  const CurveJudgement strictly = ByCurve(CurveAnswer(truth, declaration, said, bounds)).judge();
  const double tolerance = tolerance_of(truth, declaration);
  if (strictly.kind == Kind::none || tolerance == 0) return strictly;
  CurveJudgement judgement =
      ByCurve(CurveAnswer(truth, declaration, said, bounds, tolerance)).judge();
  judgement.is_by_tolerance = judgement.kind == Kind::none;
  return judgement;
}

std::optional<AlongNormal> said_along(const Answer& answer) {
  const Said said = said_by(answer);
  return said.normal ? std::optional(AlongNormal{*said.normal, said.depth}) : std::nullopt;
}

bool touches(const Answer& answer) {
  return said_by(answer).touches;
}

bool is_reversed(const exact::Truth& truth, const ColliderAnswer& given) {
  const Said said = said_by(given.answer);
  const CurveBounds bounds = curve_bounds(truth.pair(), given.declaration, truth.extent());
  return said.touches && CurveAnswer(truth, given.declaration, said, bounds).is_reversed();
}

}  // namespace manifuzz
