#pragma once

#include <array>
#include <map>
#include <optional>

#include "exact/arithmetic.hpp"
#include "exact/curve.hpp"
#include "exact/root_sum.hpp"
#include "judging/admissible.hpp"
#include "judging/compare.hpp"

namespace manifuzz {

/// By how much a manifold's figures differ from a right manifold's: the largest of its points. As a
/// share, each figure is divided: by the size (`share_of_size`), or by its bound, 1 being as far
/// off as a right collider may be.
struct ManifoldError {
  double normal = 0;    ///< length of the difference of two unit vectors
  double position = 0;  ///< distance, a world length
  double depth = 0;     ///< |difference|, a world length
};

/// Keeps the larger of each figure.
void widen(ManifoldError& worst, const ManifoldError& other);

/// Position and depth divided by the size; a normal's error is a share already.
ManifoldError share_of_size(const ManifoldError& error, double size);

struct ClipFigures;

/// The error of a manifold's normal against that of a clip.
double normal_error(const Manifold<double>& manifold, const ClipFigures& truth);
/// The error of a reported point's position and depth against one of a clip's points.
ManifoldError point_error(const ContactPoint<double>& reported, const ClipFigures& truth, int k);

/// An error against one clip, free of any bound, and as a share of the bounds.
struct ErrorAgainstClip {
  ManifoldError error;
  ManifoldError of_bound;             ///< the largest share that one of the points takes
  const exact::Clip* clip = nullptr;  ///< the right manifold that it was held against
};

/// The true figures of a clip, in pairs of doubles: to well past double.
struct ClipFigures {
  using Number = exact::Approximate<exact::DoubleDouble>;

  explicit ClipFigures(const exact::Clip& of);

  const exact::Clip* clip;
  exact::Point<exact::Element<Number>> normal;
  std::array<exact::Located<Number>, 2> points;
};

/// The figures of one case's clips, each worked out once.
class ClipFiguresCache {
 public:
  const ClipFigures& of(const exact::Clip& clip) {
    return known_.try_emplace(&clip, clip).first->second;
  }

 private:
  std::map<const exact::Clip*, const ClipFigures> known_;
};

/// The error of a manifold with points against one clip that has some.
ErrorAgainstClip error_against(const Manifold<double>& manifold, const ClipFigures& truth,
                               const Bounds& bounds);

/// The error of a manifold with points that is one of the right ones, against the one of whose
/// bounds it takes the least share.
std::optional<ErrorAgainstClip> error_if_right(const Manifold<double>& manifold,
                                               const Admissible& right, ClipFiguresCache& figures);

/// The error of any manifold with points, right or wrong, against the clip nearest to it; none
/// where nothing may touch.
std::optional<ErrorAgainstClip> nearest_error(const Manifold<double>& manifold,
                                              const Admissible& right, ClipFiguresCache& figures);

/// An error against the penetration curve, free of any bound, and as a share of the bounds.
struct ErrorAgainstCurve {
  ManifoldError error;
  ManifoldError of_bound;
};

/// The error of an answer's normal and depth against the nearest direction of least depth; none
/// where it says that they are apart, or names no normal.
std::optional<ErrorAgainstCurve> error_against(const exact::PenetrationCurve& curve,
                                               const exact::Truth& truth,
                                               const ColliderAnswer& given);

/// The manifold with what it leaves out set as the right manifold nearest to it has it, so that it
/// is judged by what it gave alone. Midpoints are moved to the incident edge.
Manifold<double> completed(const PartialManifold& given, const Admissible& right);

/// The manifold completed as above, but after `model`, a manifold of the case.
Manifold<double> completed(const PartialManifold& given, const PairCase& pair,
                           const Manifold<double>& model);

/// Whether two answers are equal, the reasons of a lost or declined one apart.
bool is_same(const Answer& one, const Answer& other);

/// A collider's answer, a partial manifold completed; of one that the penetration curve judges, or
/// that used shapes of its own, as it is.
Answer whole(Answer answer, const PairCase& pair, const Declaration& declaration);
Answer whole(Answer answer, const Admissible& right, const Declaration& declaration);

/// What the collider answers now, completed.
Answer ask(const Collider& collider, const PairCase& pair);

}  // namespace manifuzz
