#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "judging/admissible.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {

/// An answer is grossly off where it errs by more than this share of the size; a normal, by more
/// than this length.
inline constexpr double kGrossShare = 0.01;

/// What an answer comes to.
enum class Assessment {
  unsupported,
  /// Not even in A's frame do the collider's roundoffs leave 95% of the size: its errors are
  /// measured, and nothing else is held against it.
  ill_posed,
  right,        ///< nothing is wrong with it but its errors
  missed,       ///< no contact, though they overlap by more than the tolerance
  phantom,      ///< a contact, though they are apart by more than the tolerance
  gross,        ///< grossly off
  wrong_count,  ///< not off, but a point that must be there is not, or there is one too many
  lost,         ///< the collider died, hung, or answered nonsense
};

/// Errors of an answer's figures against the right manifold nearest to it.
struct FigureErrors {
  float depth = 0;
  float position = 0;
  float normal = 0;
};

struct Measured {
  Assessment assessment = Assessment::right;
  bool has_errors = false;  ///< it has points, and there is something to hold them against
  FigureErrors of_size{};   ///< as shares of the size; the normal's a length
  /// As shares of the bounds that a collider of its scalar has in A's frame: of what the input
  /// determines. A bound is 15 roundoffs of the extent (26 in double), times the case's condition.
  FigureErrors of_bound{};
  /// Depth's or position's, whichever is larger, in roundoffs of the extent: 2^-24, 2^-53 in
  /// double.
  float of_extent = 0;
  /// How bad a wrong answer is, to tell the worst: its error, or the separation's distance from
  /// contact, as a share of the size.
  float wrongness = 0;
};

/// Whether that is against the collider.
inline bool is_wrong(Assessment assessment) {
  return assessment > Assessment::right;
}

/// All that is right for one case, for colliders of several declarations.
class Referee {
 public:
  explicit Referee(const PairCase& pair) : truth_(std::make_shared<const exact::Truth>(pair)) {}

  const exact::Truth& truth() const { return *truth_; }
  /// What is right for such a collider, found once for all that declare alike.
  const Admissible& right_for(const Declaration& declaration);
  /// The answer as it is measured: a partial manifold completed, nonsense lost.
  Answer heard(const Declaration& declaration, Answer answer);
  /// Of an answer that was heard.
  Measured measure(const Declaration& declaration, const Answer& answer);

  /// The truth's own manifold under the collider's bias: the reference that the bias leaves, the
  /// first of equal incident edges; its figures to the last digit of double. None where they are
  /// apart.
  const Manifold<double>& truth_for(const Declaration& declaration);

 private:
  struct Ruling {
    ScalarType scalar;
    RoundingFrame frame;
    double tie_bias;
    Admissible right;
    Bounds in_a_frame;
    std::optional<Manifold<double>> of_truth{};
    /// Colliders that declare alike often answer alike.
    std::vector<std::pair<Manifold<double>, Measured>> measured{};
  };
  Ruling& ruling_for(const Declaration& declaration);
  Measured measure(Ruling& ruling, const Manifold<double>& manifold);
  Measured errors_of(const Ruling& ruling, const Manifold<double>& manifold, bool& is_right);
  Assessment assess(const Ruling& ruling, const Manifold<double>& manifold,
                    const FigureErrors& of_size, bool is_right);
  bool has_wrong_count(const Ruling& ruling, const Manifold<double>& manifold);

  /// What rounding may decide: the separation's bound, or 1% of the size where the bound is wider,
  /// for no distance from the origin excuses more.
  double tolerance_of(const Ruling& ruling) const;

  std::shared_ptr<const exact::Truth> truth_;
  ClipFiguresCache fine_;
  std::vector<std::unique_ptr<Ruling>> rulings_;
};

/// What float makes of the truth: each figure rounded once.
Manifold<double> rounded_once(const Manifold<double>& truth);

}  // namespace manifuzz
