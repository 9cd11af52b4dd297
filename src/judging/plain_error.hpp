#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "judging/admissible.hpp"
#include "oracle/exact/approximate.hpp"
#include "oracle/exact/double_double.hpp"

namespace manifuzz {

/// The largest errors of a manifold's figures against the right manifold nearest to it.
struct PlainError {
  double normal = 0;    ///< length of the difference of two unit vectors
  double position = 0;  ///< world length
  double depth = 0;     ///< world length
};

/// An error, free of any bound, and the largest share of its bound that one of its points takes.
struct MeasuredError {
  PlainError error;
  PlainError share;  ///< of the bound, 1 being as far off as a right collider may be
  const exact::Clip* clip = nullptr;  ///< the right manifold that it was held against
};

/// The figures of a right manifold, to well past double.
struct FineClip {
  using Number = exact::Approximate<exact::DoubleDouble>;

  FineClip(const PairCase& pair, const exact::Clip& of);

  const exact::Clip* clip;
  exact::Point<exact::Element<Number>> normal;
  std::array<exact::Located<Number>, 2> points;
};

/// Those of one case, each worked out once.
class FineClips {
 public:
  const FineClip& of(const PairCase& pair, const exact::Clip& clip);

 private:
  std::vector<std::unique_ptr<const FineClip>> known_;
};

/// Of a manifold with points against one clip that has some.
MeasuredError error_against(const Manifold<double>& manifold, const FineClip& truth,
                            const Admissible& right);

/// Of a manifold with points that is one of the right ones; values are known to well past double.
std::optional<MeasuredError> measure_error(const Manifold<double>& manifold,
                                           const Admissible& right, FineClips& fine);
std::optional<MeasuredError> measure_error(const Manifold<double>& manifold,
                                           const Admissible& right);

/// Of any manifold with points, right or wrong, against the clip nearest to it; none where nothing
/// may touch.
std::optional<MeasuredError> nearest_error(const Manifold<double>& manifold,
                                           const Admissible& right, FineClips& fine);

/// The largest error of any manifold, right or wrong, against the clip nearest to it: a contact
/// that was missed, or seen across a gap, is off by its depth. In world lengths; the normal's is
/// left out.
PlainError plain_error(const Manifold<double>& manifold, const Admissible& right);

}  // namespace manifuzz
