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

/// What is found of one answer. Missed and phantom are decided by the same bounds as all else:
/// every other definition would call an answer wrong that a right collider may give, or excuse one
/// that none gives.
enum class Assessment {
  unsupported,
  /// Not even in A's frame do the collider's roundoffs leave 95% of the size: its errors are
  /// measured, and nothing else is held against it.
  ill_posed,
  right,        ///< nothing is wrong with it but its errors
  missed,       ///< no contact, though every right manifold has one
  phantom,      ///< a contact, though no right manifold has one
  gross,        ///< grossly off
  wrong_count,  ///< not off, but a point that must be there is not, or there is one too many
  lost,         ///< the collider died, hung, or answered nonsense
};

/// Whether that is against the collider.
inline bool is_wrong(Assessment assessment) {
  return assessment > Assessment::right;
}

/// One answer against the right manifold nearest to it.
struct Measured {
  Assessment assessment = Assessment::right;
  bool has_errors = false;  ///< it has points, and there is something to hold them against
  ManifoldError error{};    ///< world lengths
  ManifoldError of_size{};  ///< as shares of the size
  /// As shares of the bounds that a collider of its scalar has in A's frame: of what the input
  /// determines. A bound is 15 roundoffs of the extent (26 in double), times the case's condition.
  ManifoldError of_bound{};
  /// Depth's or position's, whichever is larger, in roundoffs of the extent: 2^-24, 2^-53 in
  /// double.
  double of_extent = 0;
  /// How bad a wrong answer is, to tell the worst: its error, or the separation's distance from
  /// contact, as a share of the size.
  float wrongness = 0;
};

/// Measures answers to one case, of colliders of several declarations: for bench, stress and scene
/// alike.
class Referee {
 public:
  explicit Referee(const PairCase& pair) : truth_(std::make_shared<const exact::Truth>(pair)) {}

  const exact::Truth& truth() const { return *truth_; }
  /// What is right for such a collider, found once for all that declare alike: within its bounds,
  /// but where these grow with the distance from the origin, it is allowed no more than in A's
  /// frame, or a gross error where that is more.
  const Admissible& right_for(const Declaration& declaration);
  /// The answer as it is measured: a partial manifold completed, one that is not well formed lost.
  Answer completed(const Declaration& declaration, Answer answer);
  /// Of a completed answer.
  Measured measure(const Declaration& declaration, const Answer& answer);

  /// The truth's own manifold under the collider's bias: the reference that the bias leaves, the
  /// first of equal incident edges; its figures to the last digit of double. None where they are
  /// apart.
  const Manifold<double>& truth_for(const Declaration& declaration);

 private:
  struct Rules {
    ScalarType scalar;
    RoundingFrame frame;
    double tie_bias;
    Admissible right;
    Bounds in_a_frame;
    std::optional<Manifold<double>> truth{};
    /// Colliders that declare alike often answer alike.
    std::vector<std::pair<Manifold<double>, Measured>> measured{};
  };
  Rules& rules_for(const Declaration& declaration);
  Measured measure(const Rules& rules, const Manifold<double>& manifold);
  bool has_right_count(const Admissible& right, const Manifold<double>& manifold);

  std::shared_ptr<const exact::Truth> truth_;
  ClipFiguresCache figures_;
  std::vector<std::unique_ptr<Rules>> rules_;
};

/// What float makes of the truth: each figure rounded once.
Manifold<double> rounded_once(const Manifold<double>& truth);

}  // namespace manifuzz
