#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace manifuzz {

// How wrong an answer is: by how much it, or the shapes, must move for it to be right. The kind of
// a finding, its class, its place among others, what is accepted of it and what reports say follow
// from this measure alone.

/// What an answer can be wrong in.
enum class Component {
  normal,    ///< length of the difference of two unit vectors
  position,  ///< of a point, from where it may be
  depth,     ///< of a point, or of the pair
  missing,   ///< depth of a point that must be there and is not; of a missed contact, the overlap
  extra,     ///< gap, claimed depth, or distance from both shapes, of what must not be there
  excess,    ///< by how much the chosen face or normal is deeper than the best
};
inline constexpr std::array<std::string_view, 6> kComponentNames{"normal",  "position", "depth",
                                                                 "missing", "extra",    "excess"};

/// What a component's figures are shares of, in words.
constexpr std::string_view unit_of(Component component) {
  return component == Component::normal ? "" : " of the size";
}

/// A figure for each component: shares of the smaller shape's size, but for the normal's. What lies
/// within its own bound is 0.
class Errors {
 public:
  double operator[](Component component) const { return all_[static_cast<std::size_t>(component)]; }
  double& operator[](Component component) { return all_[static_cast<std::size_t>(component)]; }
  const std::array<double, kComponentNames.size()>& all() const { return all_; }
  std::array<double, kComponentNames.size()>& all() { return all_; }

  friend bool operator==(const Errors&, const Errors&) = default;

 private:
  std::array<double, kComponentNames.size()> all_{};
};

/// Keeps the larger of each figure.
void widen(Errors& worst, const Errors& other);

/// The error of an answer, read as one of the right ones that is not quite met. All figures as in
/// `Errors`.
struct AnswerError {
  Errors errors;
  double magnitude = 0;                ///< the greatest of them
  double bound = 0;                    ///< within which that one would be right
  std::optional<Component> component;  ///< whose it is; none where no error exceeds its bound

  double total() const;  ///< the sum of all of them

  /// Counts an error that exceeds its bound.
  void add(Component of, double error, double within);
  /// Counts an error that is known to exceed its bound, whatever its figures were rounded to.
  void add_beyond(Component of, double error, double within);
};

/// The worst of several answers, or how two that are right differ, which has a magnitude alone.
struct WorstError {
  double magnitude = 0;
  Errors errors{};

  friend bool operator==(const WorstError&, const WorstError&) = default;
};

/// Keeps the larger of each figure.
void widen(WorstError& worst, const WorstError& other);

/// Whether the answer is nearer to being right in the first reading than in the second: in the sum
/// of its errors, so that one that is far off in one thing is not read as off in all by less.
bool is_less_wrong(const AnswerError& first, const AnswerError& second);

}  // namespace manifuzz
