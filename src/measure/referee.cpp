#include "measure/referee.hpp"

#include <algorithm>
#include <limits>

#include "judging/judge.hpp"
#include "judging/outside.hpp"

namespace manifuzz {
namespace {

/// To float; what is beyond it, or no number, is the largest float.
float bounded(double value) {
  constexpr float most = std::numeric_limits<float>::max();
  return value < static_cast<double>(most) ? static_cast<float>(value) : most;
}

FigureErrors figures(const PlainError& error, double length) {
  return {bounded(error.depth / length), bounded(error.position / length), bounded(error.normal)};
}

double roundoff_of(ScalarType scalar) {
  return scalar == ScalarType::float32 ? 0x1p-24 : 0x1p-53;
}

bool is_gross(const FigureErrors& of_size) {
  constexpr auto gross = static_cast<float>(kGrossShare);
  return of_size.depth > gross || of_size.position > gross || of_size.normal > gross;
}

Assessment assessment_of(const Mismatch& mismatch, const Measured& measured) {
  switch (mismatch.kind) {
    case Kind::none:
    case Kind::features:
      return Assessment::right;
    case Kind::missed_contact:
      return Assessment::missed;
    case Kind::phantom_contact:
      return Assessment::phantom;
    case Kind::count:
      return Assessment::wrong_count;
    default:
      return is_gross(measured.of_size) ? Assessment::gross : Assessment::right;
  }
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
  const bool decides = !is_ill_posed(truth_->size(), ruling.in_a_frame);
  const Measured measured =
      decides ? measure(ruling, *manifold) : Measured{.assessment = Assessment::ill_posed};
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
  return ruling.of_truth.emplace(true_manifold(truth_->pair(), clip));
}

Measured Referee::errors_of(const Ruling& ruling, const Manifold<double>& manifold,
                            bool& is_right) {
  auto error = measure_error(manifold, ruling.right, fine_);
  is_right = error.has_value();
  if (!is_right) error = nearest_error(manifold, ruling.right, fine_);
  if (!error) return {};
  Admissible in_a_frame = ruling.right;
  in_a_frame.bounds = ruling.in_a_frame;
  const MeasuredError of_input =
      ruling.frame == RoundingFrame::local
          ? *error
          : error_against(manifold, fine_.of(truth_->pair(), *error->clip), in_a_frame);
  const double worse = std::max(error->error.depth, error->error.position);
  return {.has_errors = true,
          .of_size = figures(error->error, truth_->size()),
          .of_bound = figures(of_input.share, 1),
          .of_extent = bounded(worse / (roundoff_of(ruling.scalar) * truth_->extent()))};
}

Measured Referee::measure(Ruling& ruling, const Manifold<double>& manifold) {
  const double tolerance = tolerance_of(ruling);
  Measured measured;
  bool is_right = false;
  if (manifold.count > 0) measured = errors_of(ruling, manifold, is_right);
  if (manifold.count == 0 && truth_->compare_separation(-tolerance) < 0) {
    measured.assessment = Assessment::missed;
  } else if (manifold.count > 0 && truth_->compare_contact(tolerance) > 0) {
    measured.assessment = Assessment::phantom;
  } else if (!is_right) {
    measured.assessment = assessment_of(mismatch(manifold, ruling.right), measured);
  }
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
