#include "measure/referee.hpp"

#include <algorithm>
#include <limits>

#include "judging/completed.hpp"
#include "judging/judge.hpp"

namespace manifuzz {
namespace {

/// To float; what is beyond it, or no number, is the largest float.
float bounded(double value) {
  constexpr float most = std::numeric_limits<float>::max();
  return value < static_cast<double>(most) ? static_cast<float>(value) : most;
}

FigureErrors figures(const ManifoldError& error, double length) {
  return {bounded(error.depth / length), bounded(error.position / length), bounded(error.normal)};
}

double roundoff_of(ScalarType scalar) {
  return scalar == ScalarType::float32 ? 0x1p-24 : 0x1p-53;
}

bool is_gross(const FigureErrors& of_size) {
  constexpr auto gross = static_cast<float>(kGrossShare);
  return of_size.depth > gross || of_size.position > gross || of_size.normal > gross;
}

/// Whether the manifold has a point of its own, within `reach`, for each that must be there, and
/// none besides. One may stand for two that are within bound of each other.
bool has_points_of(const exact::Clip& clip, const Manifold<double>& manifold,
                   const Admissible& right, double reach) {
  const auto has = [&](int k, int i) {
    const exact::ClipPoint& point = clip.points[k];
    if (is_optional(right, clip, point)) return true;
    return i < manifold.count &&
           (manifold.points[i].position - point.position()).stableNorm() <= reach;
  };
  if (manifold.count > clip.count) return false;
  if (clip.count == 1) return has(0, 0);
  const double bound = std::max(position_bound(right, clip, clip.points[0]),
                                position_bound(right, clip, clip.points[1]));
  if (compare_apart(clip, 2 * bound) <= 0) return has(0, 0) || has(1, 0);
  return (has(0, 0) && has(1, 1)) || (has(0, 1) && has(1, 0));
}

}  // namespace

Referee::Ruling& Referee::ruling_for(const Declaration& declaration) {
  for (const auto& ruling : rulings_) {
    if (ruling->scalar == declaration.scalar && ruling->frame == declaration.frame &&
        ruling->tie_bias == declaration.tie_bias) {
      return *ruling;
    }
  }
  Declaration in_a_frame = declaration;
  in_a_frame.frame = RoundingFrame::local;
  rulings_.push_back(std::make_unique<Ruling>(Ruling{
      declaration.scalar, declaration.frame, declaration.tie_bias, admissible(truth_, declaration),
      bounds(truth_->pair(), in_a_frame, truth_->extent())}));
  return *rulings_.back();
}

const Admissible& Referee::right_for(const Declaration& declaration) {
  return ruling_for(declaration).right;
}

double Referee::tolerance_of(const Ruling& ruling) const {
  return std::min(ruling.right.bounds.separation, kGrossShare * truth_->size());
}

Answer Referee::heard(const Declaration& declaration, Answer answer) {
  if (std::holds_alternative<PartialManifold>(answer)) {
    answer = completed(std::move(answer), ruling_for(declaration).right);
  }
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr || is_well_formed(truth_->pair(), *manifold)) return answer;
  return Lost{Lost::How::malformed, {}};
}

Measured Referee::measure(const Declaration& declaration, const Answer& answer) {
  if (std::holds_alternative<Unsupported>(answer)) return {.assessment = Assessment::unsupported};
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr) {
    return {.assessment = Assessment::lost, .wrongness = std::numeric_limits<float>::max()};
  }
  Ruling& ruling = ruling_for(declaration);
  const auto before =
      std::ranges::find(ruling.measured, *manifold, &std::pair<Manifold<double>, Measured>::first);
  if (before != ruling.measured.end()) return before->second;
  const Measured measured = measure(ruling, *manifold);
  ruling.measured.emplace_back(*manifold, measured);
  return measured;
}

const Manifold<double>& Referee::truth_for(const Declaration& declaration) {
  Ruling& ruling = ruling_for(declaration);
  if (ruling.of_truth) return *ruling.of_truth;
  if (truth_->compare_contact(0) > 0) return ruling.of_truth.emplace();
  const Side side = truth_->compare_lead_of_b(declaration.tie_bias) > 0 ? Side::b : Side::a;
  const exact::FaceOf face = truth_->greatest(side);
  const exact::Clip& clip = truth_->clip(face, truth_->incident_edges(face, 0).front());
  return ruling.of_truth.emplace(true_manifold(clip));
}

Measured Referee::errors_of(const Ruling& ruling, const Manifold<double>& manifold,
                            bool& is_right) {
  auto error = error_if_right(manifold, ruling.right, fine_);
  is_right = error.has_value();
  if (!is_right) error = nearest_error(manifold, ruling.right, fine_);
  if (!error) return {};
  Admissible in_a_frame = ruling.right;
  in_a_frame.bounds = ruling.in_a_frame;
  const ErrorAgainstClip of_input =
      ruling.frame == RoundingFrame::local
          ? *error
          : error_against(manifold, fine_.of(*error->clip), in_a_frame);
  const double worse = std::max(error->error.depth, error->error.position);
  return {.has_errors = true,
          .of_size = figures(error->error, truth_->size()),
          .of_bound = figures(of_input.of_bound, 1),
          .of_extent = bounded(worse / (roundoff_of(ruling.scalar) * truth_->extent()))};
}

bool Referee::has_wrong_count(const Ruling& ruling, const Manifold<double>& manifold) {
  Admissible right = ruling.right;
  right.bounds.separation = tolerance_of(ruling);
  const double reach = kGrossShare * truth_->size();
  right.bounds.position = std::min(right.bounds.position, reach);
  return std::ranges::none_of(right.candidates, [&](const exact::Clip* clip) {
    if (!has_points_of(*clip, manifold, right, reach)) return false;
    const ManifoldError error = error_against(manifold, fine_.of(*clip), right).error;
    return !is_gross(figures(error, truth_->size()));
  });
}

Assessment Referee::assess(const Ruling& ruling, const Manifold<double>& manifold,
                           const FigureErrors& of_size, bool is_right) {
  if (is_ill_posed(truth_->size(), ruling.in_a_frame)) return Assessment::ill_posed;
  const double tolerance = tolerance_of(ruling);
  if (manifold.count == 0) {
    const bool is_missed = truth_->compare_separation(-tolerance) < 0 ||
                           mismatch(manifold, ruling.right).kind != Kind::none;
    return is_missed ? Assessment::missed : Assessment::right;
  }
  if (truth_->compare_contact(tolerance) > 0) return Assessment::phantom;
  if (is_gross(of_size)) return Assessment::gross;
  const bool is_excused = is_right && tolerance == ruling.right.bounds.separation;
  if (!is_excused && has_wrong_count(ruling, manifold)) return Assessment::wrong_count;
  return Assessment::right;
}

Measured Referee::measure(Ruling& ruling, const Manifold<double>& manifold) {
  Measured measured;
  bool is_right = false;
  if (manifold.count > 0) measured = errors_of(ruling, manifold, is_right);
  measured.assessment = assess(ruling, manifold, measured.of_size, is_right);
  if (measured.assessment == Assessment::missed || measured.assessment == Assessment::phantom) {
    measured.wrongness = bounded(ruling.right.from_contact() / truth_->size());
  } else if (is_wrong(measured.assessment)) {
    measured.wrongness = std::max(measured.of_size.depth, measured.of_size.position);
  }
  return measured;
}

Manifold<double> rounded_once(const Manifold<double>& truth) {
  auto rounded = manifold_cast<double>(manifold_cast<float>(truth));
  // A depth of nothing may be less than nothing by the double's last digit.
  for (auto& point : rounded.points) point.depth = std::max(point.depth, 0.0);
  return rounded;
}

}  // namespace manifuzz
