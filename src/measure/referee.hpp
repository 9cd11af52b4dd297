#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json_fwd.hpp>

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

/// One answer against the right manifold nearest to it; of one that no clip makes, its normal and
/// its depth against the least.
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
  /// The answer as it is measured: whole, or lost where it is not well formed.
  Answer whole(const Declaration& declaration, Answer answer);
  /// Measures a completed answer.
  Measured measure(const Declaration& declaration, const Answer& answer);

  /// The truth's own manifold under the collider's bias: the reference that the bias leaves, the
  /// first of equal incident edges; its figures to the last digit of double. None where they are
  /// apart.
  const Manifold<double>& truth_for(const Declaration& declaration);

 private:
  struct Rules {
    ScalarType scalar;
    RoundingFrame frame;
    bool takes_angles;
    TieBias tie_bias;
    Admissible right;
    Bounds in_a_frame;
    std::optional<Manifold<double>> truth{};
    /// Colliders that declare alike often answer alike.
    std::vector<std::pair<Manifold<double>, Measured>> measured{};
  };
  Rules& rules_for(const Declaration& declaration);
  Measured measure(const Rules& rules, const Manifold<double>& manifold);
  Measured measure_by_curve(const Declaration& declaration, const Answer& answer);
  bool has_right_count(const Admissible& right, const Manifold<double>& manifold);

  std::shared_ptr<const exact::Truth> truth_;
  ClipFiguresCache figures_;
  std::vector<std::unique_ptr<Rules>> rules_;
};

/// What float makes of the truth: each figure rounded once.
Manifold<double> rounded_once(const Manifold<double>& truth);

/// How one error is spread over many contacts: each figure is one of the values, the nearest rank,
/// none lies between two. All 0 where there is no contact.
struct Spread {
  double median = 0;
  double p999 = 0;  ///< the 99.9th percentile
  double max = 0;
  std::uint64_t worst = 0;  ///< the case of the largest, the first of equals

  friend bool operator==(const Spread&, const Spread&) = default;
};

struct ErrorSpreads {
  Spread depth;
  Spread position;
  Spread normal;

  friend bool operator==(const ErrorSpreads&, const ErrorSpreads&) = default;
};

/// The upper one of two; not of nothing.
double median(std::vector<double> values);

/// To float; what is beyond it, or no number, is the largest float.
float to_float(double value);

/// `cases`: the case of each value.
Spread spread_of(std::vector<float> values, std::span<const std::uint64_t> cases);

/// The errors of many contacts, kept as floats for there are many.
class ErrorList {
 public:
  void add(std::uint64_t index, const ManifoldError& error);
  ErrorSpreads spreads() const;
  std::span<const std::uint64_t> cases() const { return cases_; }  ///< of each, as it was added

 private:
  std::vector<std::uint64_t> cases_;
  std::vector<float> depth_;
  std::vector<float> position_;
  std::vector<float> normal_;
};

/// {"median", "p999", "max"}.
nlohmann::ordered_json spread_json(const Spread& spread);

/// {"depth", "position", "normal"}, each a spread, to which `add_worst` may add its worst case.
nlohmann::ordered_json spreads_json(
    const ErrorSpreads& spreads,
    const std::function<void(nlohmann::ordered_json& json, const Spread& spread)>& add_worst = {});

/// One collider over many cases: how often it was assessed as what, and its errors.
struct ErrorStatistics {
  std::uint64_t cases = 0;
  std::uint64_t unsupported = 0;
  std::uint64_t ill_posed = 0;
  std::uint64_t contacts = 0;  ///< with points that were measured
  std::uint64_t missed = 0;
  std::uint64_t phantom = 0;
  std::uint64_t wrong_count = 0;
  std::uint64_t gross = 0;
  std::uint64_t lost = 0;
  ErrorSpreads of_size;  ///< `Measured` says in what units
  ErrorSpreads of_bound;
  Spread of_extent;
  std::uint64_t worst_wrong = 0;  ///< the case of the wrong answer that is farthest off
  float wrongness = 0;            ///< how far, as a share of the size

  std::uint64_t well_posed() const { return cases - unsupported - ill_posed; }
  std::uint64_t wrong() const { return missed + phantom + wrong_count + gross + lost; }

  friend bool operator==(const ErrorStatistics&, const ErrorStatistics&) = default;
};

/// Collects what a collider is measured by, case by case.
class ErrorCollector {
 public:
  enum class Errors { kept, counted };  ///< counted alone: no spreads, and no memory for them
  explicit ErrorCollector(Errors errors = Errors::kept) : errors_(errors) {}

  void add(std::uint64_t index, const Measured& measured);
  ErrorStatistics statistics() const;

 private:
  Errors errors_;
  ErrorStatistics counts_;
  ErrorList of_size_;
  ErrorList of_bound_;
  std::vector<float> of_extent_;
};

}  // namespace manifuzz
