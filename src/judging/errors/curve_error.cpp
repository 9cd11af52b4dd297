#include <algorithm>
#include <cmath>

#include "judging/by_curve.hpp"
#include "judging/curve_answer.hpp"
#include "judging/errors/place_error.hpp"

namespace manifuzz {
namespace {

using exact::Along;

/// The error of an answer that a judgement finds wrong, in shares of the size.
class CurveError {
 public:
  CurveError(const CurveAnswer& answer, const CurveJudgement& judged)
      : answer_(answer), judged_(judged), size_(answer.truth().size()) {}

  AnswerError measure() {
    const Said& said = answer_.said();
    if (judged_.kind == Kind::missed_contact) {
      add_length(Component::missing, judged_.magnitude, judged_.bound);
    } else if (judged_.kind == Kind::phantom_contact) {
      const double claimed = std::max(farthest_from_both(), said.depth);
      add_length(Component::extra, std::max(claimed, judged_.magnitude), judged_.bound);
    } else if (judged_.kind != Kind::none && said.normal && !said.normal->isZero(0)) {
      measure_along(*said.normal);
    } else if (judged_.kind != Kind::none) {
      error_.add_beyond(Component::normal, judged_.magnitude, judged_.bound);
      measure_along_nearest();
    }
    return error_;
  }

 private:
  /// An error that exceeds its bound, both world lengths.
  void add_length(Component of, double length, double within) {
    error_.add_beyond(of, length / size_, within / size_);
  }

  /// Without a direction of its own: along that of the least depth with which it is the least
  /// wrong.
  void measure_along_nearest() {
    std::optional<AnswerError> least;
    for (const Vector2<double>& minimum : answer_.curve().minima(answer_.within().minimality)) {
      CurveError reading = *this;
      reading.measure_along(minimum);
      if (!least || is_less_wrong(reading.error_, *least)) least = reading.error_;
    }
    if (least) error_ = *least;
  }

  void measure_along(Vector2<double> normal) {
    const double length = normal.stableNorm();
    if (!std::isfinite(normal.squaredNorm())) normal = normal.stableNormalized();
    const bool is_reversed = judged_.kind == Kind::reversed;
    const Along along(answer_.truth(), is_reversed ? Vector2<double>(-normal) : normal);
    error_.add(Component::normal, std::abs(length - 1), answer_.within().normal);
    if (is_reversed) error_.add_beyond(Component::normal, 2, answer_.within().normal);
    const double depth = answer_.said().depth;
    // Across a gap any normal will do.
    const bool is_minimal = is_reversed || depth < 0 || answer_.is_minimal(along);
    if (!is_minimal) add_excess(along);
    const double off = answer_.is_depth(along, depth) ? 0 : answer_.depth_error(along);
    if (off > 0) add_length(Component::depth, off, answer_.within().consistency);
    if (answer_.said().manifold == nullptr) return;
    add_positions(along, off, is_minimal);
    add_second_point();
  }

  void add_excess(const Along& along) {
    if (answer_.is_least(along)) {
      error_.add_beyond(Component::normal, answer_.nearest().error(along.local_normal()),
                        answer_.nearest().bound());
    } else {
      add_length(Component::excess, std::abs(answer_.curve().excess(along)),
                 answer_.within().minimality);
    }
  }

  /// `off`: by how much the depth is wrong, which is counted apart.
  void add_positions(const Along& along, double off, bool is_minimal) {
    // Along a normal that is not the least, right points may lie on two lines, and as far from a
    // thin shape as they are deep.
    const double overlap = std::clamp(answer_.said().depth, 0.0, std::max(along.depth(), 0.0));
    double farthest = is_minimal ? farthest_witness(along, off) : farthest_from_both() - overlap;
    // The points of a reversed normal may be those of the right one, or follow it.
    if (judged_.kind == Kind::reversed) {
      const Along as_given(answer_.truth(), *answer_.said().normal);
      farthest = std::min(farthest, farthest_witness(as_given, off));
    }
    const double within = answer_.within().along + answer_.tolerance();
    if (judged_.kind == Kind::witness || farthest > within) {
      add_length(Component::position, farthest, within);
    }
  }

  void add_second_point() {
    const Manifold<double>& manifold = *answer_.said().manifold;
    if (judged_.kind == Kind::extent) {
      add_length(Component::position, judged_.magnitude, judged_.bound);
    } else if (judged_.kind == Kind::count && manifold.count < 2) {
      add_length(Component::missing, judged_.missing, judged_.bound);
    } else if (judged_.kind == Kind::count) {
      add_length(Component::extra, std::min(manifold.points[0].depth, manifold.points[1].depth),
                 judged_.bound);
    }
  }

  double farthest_from_both() const {
    const Manifold<double>* const manifold = answer_.said().manifold;
    double farthest = 0;
    for (int i = 0; manifold != nullptr && i < manifold->count; ++i) {
      farthest =
          std::max(farthest, distance_from_both(answer_.truth(), manifold->points[i].position));
    }
    return farthest;
  }

  double farthest_witness(const Along& along, double off) const {
    const Declaration& declaration = answer_.declaration();
    const auto heights = heights_of(declaration.points, answer_.truth().pair());
    double farthest = 0;
    for (int i = 0; i < answer_.said().manifold->count; ++i) {
      const ContactPoint<double>& point = answer_.said().manifold->points[i];
      const double least =
          declaration.shares_depth ? std::min(point.depth, -declaration.speculative) : point.depth;
      farthest =
          std::max(farthest, witness_error(answer_.truth(), along.local_normal(),
                                           {point, heights, least - off, point.depth + off}));
      if (answer_.is_where_claimed(point)) continue;
      farthest = std::max(farthest, distance_from_vertices(answer_.truth(), point.position));
    }
    return farthest;
  }

  const CurveAnswer& answer_;
  const CurveJudgement& judged_;
  double size_;
  AnswerError error_;
};

}  // namespace

AnswerError curve_error(const exact::Truth& truth, const Declaration& declaration,
                        const Answer& answer, const CurveJudgement& judgement) {
  const Said said = said_by(answer);
  const CurveAnswer read(truth, declaration, said,
                         curve_bounds(truth.pair(), declaration, truth.extent()),
                         tolerance_of(truth, declaration));
  return CurveError(read, judgement).measure();
}

}  // namespace manifuzz
