#pragma once

#include <optional>

#include "exact/curve.hpp"
#include "judging/admissible.hpp"
#include "judging/compare.hpp"
#include "judging/errors/answer_error.hpp"

namespace manifuzz {

/// How far an answer's figures may lie from the penetration curve, by its declaration; bounds.md
/// derives them.
struct CurveBounds {
  double consistency = 0;   ///< of a depth against the curve at the reported normal, world lengths
  double minimality = 0;    ///< of the depth at the normal against the least
  double along = 0;         ///< of a contact point, along the tangent
  double across = 0;        ///< of a contact point, along the normal
  double narrow = 0;        ///< how wide a core is that rounding may turn over
  double touching = 0;      ///< of the least depth against 0
  double normal = 0;        ///< of the normal's length against 1
  double direction = 0;     ///< of the normal against the nearest direction
  double world_vertex = 0;  ///< of each vertex that a face's normal is taken from
};

/// How far a collider may stop short of the least depth, as it declares: a world length.
double tolerance_of(const exact::Truth& truth, const Declaration& declaration);

CurveBounds curve_bounds(const PairCase& pair, const Declaration& declaration, double extent);

/// What the penetration curve makes of an answer. What is not claimed, or not judged once something
/// else is wrong, is none.
struct CurveJudgement {
  Kind kind = Kind::none;
  double magnitude = 0;              ///< a world length; of a normal's length its error
  double bound = 0;                  ///< within which it would be right
  bool is_by_tolerance = false;      ///< right, but only by the tolerance that it declares
  std::optional<double> excess{};    ///< D(n) - D*, a world length
  std::optional<bool> consistent{};  ///< the depth is the curve's at the reported normal
  std::optional<bool> minimal{};     ///< no other normal has clearly less depth
  std::optional<bool> witness{};     ///< every point lies where it claims, with that overlap
  double missing = 0;                ///< depth of a second point that is left out, a world length
};

/// Judges a manifold, complete or not, or a penetration, in A's frame whatever the collider's. Uses
/// these bounds, or those of its declaration.
CurveJudgement judge_by_curve(const exact::Truth& truth, const Declaration& declaration,
                              const Answer& answer, const CurveBounds& bounds);
inline CurveJudgement judge_by_curve(const exact::Truth& truth, const Declaration& declaration,
                                     const Answer& answer) {
  return judge_by_curve(truth, declaration, answer,
                        curve_bounds(truth.pair(), declaration, truth.extent()));
}

/// How wrong an answer is that this judgement finds wrong: all that is beyond its bounds, along the
/// normal that it names, or, where that is reversed, along the normal turned about.
AnswerError curve_error(const exact::Truth& truth, const Declaration& declaration,
                        const Answer& answer, const CurveJudgement& judgement);

/// A depth along a normal.
struct AlongNormal {
  Vector2<double> normal{0, 0};  ///< in A's frame
  double depth = 0;              ///< a world length; of points the deepest's
};

/// What an answer says of the pair as a whole; none where it names no normal.
std::optional<AlongNormal> said_along(const Answer& answer);

/// Whether the answer says that they touch.
bool touches(const Answer& answer);

/// Whether the normal of an answer with a contact points from B to A: turned about it would have
/// the least depth, and the depth that it gives.
bool is_reversed(const exact::Truth& truth, const ColliderAnswer& given);

}  // namespace manifuzz
