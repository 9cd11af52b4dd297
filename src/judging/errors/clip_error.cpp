#include "judging/errors/clip_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "exact/curve.hpp"
#include "judging/errors/place_error.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {
namespace {

using exact::Clip;
using exact::FaceOf;

/// A manifold against the clips that it may be.
class AgainstClips {
 public:
  AgainstClips(const Manifold<double>& manifold, const Admissible& right)
      : manifold_(manifold),
        right_(right),
        truth_(*right.truth),
        size_(truth_.size()),
        bound_(right.bounds.separation / size_) {}

  AnswerError least() {
    for (const Clip* const clip : right_.candidates) hold_against(*clip, 0);
    for (const FaceOf face : exact::all_faces(truth_.stored())) {
      const double excess = excess_of(face);
      if (best_ && excess > best_->total()) continue;  // no clip of this face is nearer
      for (const int edge : truth_.incident_edges(face, right_.bounds.incident_dot)) {
        const Clip& clip = truth_.clip(face, edge);
        if (std::ranges::count(right_.candidates, &clip) == 0) hold_against(clip, excess);
      }
    }
    return *best_;
  }

 private:
  /// What a reported point is taken for: one of the clip's points, or one too many.
  static constexpr int kExtra = 2;
  using Matching = std::array<int, 2>;

  /// By how much separations must change for the face to be the reference: what it falls short of
  /// its side's best, and that side's best of what the tie bias asks for. A share of the size.
  double excess_of(FaceOf face) const {
    const TieBias& bias = right_.tie_bias;
    const Side side = face.side;
    const exact::DoubleDouble of_side = truth_.fine_separation(truth_.greatest(side));
    const double behind_best = exact::leading(of_side - truth_.fine_separation(face));
    const exact::DoubleDouble favoured = truth_.fine_separation(truth_.greatest(bias.towards));
    const exact::DoubleDouble other_best =
        truth_.fine_separation(truth_.greatest(other(bias.towards)));
    const double lead =
        exact::leading(other_best - exact::DoubleDouble(1 - bias.relative) * favoured -
                       exact::DoubleDouble(bias.absolute));
    const double behind_other = std::max(side == bias.towards ? lead : -lead, 0.0);
    return (behind_best + behind_other) / size_;
  }

  void keep(const AnswerError& reading) {
    if (!best_ || is_less_wrong(reading, *best_)) best_ = reading;
  }

  void hold_against(const Clip& clip, double excess) {
    const Admissible within = with_face_of(right_, clip);
    const ClipFigures figures(clip);
    AnswerError of_face;
    const bool is_right_face = std::ranges::count(right_.candidates, &clip) > 0;
    if (!is_right_face) of_face.add_beyond(Component::excess, excess, bound_);
    of_face.add(Component::normal, normal_error(manifold_, figures), within.bounds.normal);
    const auto choices = [&](int point) { return point < manifold_.count ? kExtra + 1 : 1; };
    for (int first = 0; first < choices(0); ++first) {
      for (int second = 0; second < choices(1); ++second) {
        const Matching matching{first, second};
        if (!is_matching(matching, within, clip)) continue;
        keep(matched(of_face, matching, figures, within));
      }
    }
  }

  /// Whether each point is one that the clip has, or one too many where there are more than it
  /// keeps.
  bool is_matching(const Matching& matching, const Admissible& within, const Clip& clip) const {
    const auto kept = std::ranges::count_if(points_of(clip), [&](const exact::ClipPoint& point) {
      return compare_depth(clip, point, -depth_bound(within, clip, point)) >= 0;
    });
    const auto points = std::span(matching).first(static_cast<std::size_t>(manifold_.count));
    const auto extra = std::ranges::count(points, kExtra);
    const auto is_of_clip = [&](int k) { return k == kExtra || k < clip.count; };
    return extra <= std::max(manifold_.count - kept, std::ptrdiff_t{0}) &&
           std::ranges::all_of(points, is_of_clip);
  }

  AnswerError matched(AnswerError reading, const Matching& matching, const ClipFigures& figures,
                      const Admissible& within) const {
    const Clip& clip = *figures.clip;
    std::array<bool, 2> is_there{};
    for (int i = 0; i < manifold_.count; ++i) {
      const int k = matching[i];
      if (k == kExtra) {
        // However small: a point that must not be there is no right one.
        reading.add_beyond(Component::extra, extra_of(manifold_.points[i]), bound_);
        continue;
      }
      is_there[k] = true;
      const ManifoldError off = point_error(manifold_.points[i], figures, k);
      const exact::ClipPoint& point = clip.points[k];
      reading.add(Component::position, off.position / size_,
                  position_bound(within, clip, point) / size_);
      reading.add(Component::depth, off.depth / size_, depth_bound(within, clip, point) / size_);
      // The edge must reach the face for the point to be one.
      reading.add(Component::position, clip.gap() / size_, within.bounds.separation / size_);
    }
    for (int k = 0; k < clip.count; ++k) {
      const exact::ClipPoint& point = clip.points[k];
      if (is_there[k] || is_optional(within, clip, point)) continue;
      reading.add(Component::missing, point.depth() / size_,
                  depth_bound(within, clip, point) / size_);
    }
    return reading;
  }

  double extra_of(const ContactPoint<double>& point) const {
    return std::max(point.depth, distance_from_both(truth_, point.position)) / size_;
  }

  const Manifold<double>& manifold_;
  const Admissible& right_;
  const exact::Truth& truth_;
  double size_;
  double bound_;  ///< a separation's, as a share of the size
  std::optional<AnswerError> best_;
};

/// A contact that must not be there at all.
AnswerError phantom_error(const Manifold<double>& manifold, const Admissible& right) {
  AnswerError error;
  const double size = right.truth->size();
  double worst = std::abs(right.from_contact());
  for (int i = 0; i < manifold.count; ++i) {
    worst = std::max({worst, manifold.points[i].depth,
                      distance_from_both(*right.truth, manifold.points[i].position)});
  }
  error.add_beyond(Component::extra, worst / size, right.bounds.separation / size);
  return error;
}

}  // namespace

AnswerError clip_error(const Manifold<double>& manifold, const Admissible& right) {
  if (manifold.count == 0) {
    AnswerError error;
    const double size = right.truth->size();
    error.add_beyond(Component::missing, right.from_contact() / size,
                     right.bounds.separation / size);
    return error;
  }
  if (!right.may_touch) return phantom_error(manifold, right);
  return AgainstClips(manifold, right).least();
}

Kind kind_of_clip(const AnswerError& error, const Manifold<double>& manifold,
                  const Admissible& right) {
  if (!error.component) return Kind::features;
  switch (*error.component) {
    case Component::normal:
      return Kind::normal;
    case Component::position:
      return Kind::position;
    case Component::depth:
      return Kind::depth;
    case Component::missing:
      return manifold.count == 0 ? Kind::missed_contact : Kind::count;
    case Component::extra:
      return right.may_touch ? Kind::count : Kind::phantom_contact;
    case Component::excess:
      return Kind::not_minimal;
  }
  return Kind::none;
}

Component component_of(Kind kind) {
  switch (kind) {
    case Kind::missed_contact:
    case Kind::count:
      return Component::missing;
    case Kind::phantom_contact:
      return Component::extra;
    case Kind::normal:
    case Kind::reversed:
      return Component::normal;
    case Kind::depth:
    case Kind::inconsistent:
      return Component::depth;
    case Kind::not_minimal:
      return Component::excess;
    default:
      return Component::position;
  }
}

}  // namespace manifuzz
