#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "measure/referee.hpp"

namespace manifuzz {

/// Of all contacts of a step: each is one of the values measured, none between two of them.
struct Spread {
  float median = 0;
  float p999 = 0;
  float max = 0;
  std::uint64_t worst = 0;  ///< the case of the largest, the first of equals

  friend bool operator==(const Spread&, const Spread&) = default;
};

struct FigureSpreads {
  Spread depth;
  Spread position;
  Spread normal;

  friend bool operator==(const FigureSpreads&, const FigureSpreads&) = default;
};

/// Changes from one frame of a walk to the next that the truth does not ask for.
struct Changes {
  std::uint64_t with_margin = 0;   ///< what decides was beyond the bound in both frames
  std::uint64_t within_bound = 0;  ///< rounding may decide
  std::uint64_t first = 0;         ///< the frame of the first with margin

  friend bool operator==(const Changes&, const Changes&) = default;
};

struct WalkTally {
  std::uint64_t touching = 0;  ///< frames, by the truth
  Changes flickers;            ///< of the reference
  Changes jumps;               ///< of a point, farther than the truth's and both bounds
  Changes features;            ///< or the number of points

  friend bool operator==(const WalkTally&, const WalkTally&) = default;
};

/// One collider in one step of a sweep: plain data that lies in shared memory.
struct StepTally {
  std::uint64_t cases = 0;
  std::uint64_t unsupported = 0;
  std::uint64_t ill_posed = 0;
  std::uint64_t contacts = 0;  ///< with points that were measured
  std::uint64_t missed = 0;
  std::uint64_t phantom = 0;
  std::uint64_t wrong_count = 0;
  std::uint64_t gross = 0;
  std::uint64_t lost = 0;
  FigureSpreads of_size;
  FigureSpreads of_bound;
  Spread of_extent;
  std::uint64_t worst_wrong = 0;  ///< the case of the wrong answer that is farthest off
  float wrongness = 0;            ///< how far, as a share of the size
  WalkTally walk;

  std::uint64_t well_posed() const { return cases - unsupported - ill_posed; }
  std::uint64_t wrong() const { return missed + phantom + wrong_count + gross + lost; }

  friend bool operator==(const StepTally&, const StepTally&) = default;
};

/// Collects what a collider is measured by, case by case.
class StepCollector {
 public:
  enum class Errors { kept, counted };  ///< counted alone: no spreads, and no memory for them
  explicit StepCollector(Errors errors = Errors::kept) : errors_(errors) {}

  void add(std::uint64_t index, const Measured& measured);
  StepTally tally() const;

 private:
  struct Contact {
    std::uint64_t index;  ///< of the case
    FigureErrors of_size;
    FigureErrors of_bound;
    float of_extent;
  };
  Errors errors_;
  StepTally counts_;
  std::vector<Contact> contacts_;
};

/// More than one well-posed case in so many wrong breaks a step.
inline constexpr std::uint64_t kWrongEvery = 10'000;

/// Whether a collider has broken: the 99.9th percentile of an error of depth, position or normal
/// exceeds 1% of the size (0.01 of the normal), or one well-posed case in 10^4, rounded up to one
/// case, is wrong.
bool is_broken(const StepTally& step);

/// The first step that is broken; none where none is.
std::optional<std::size_t> breaking_step(std::span<const StepTally> steps);

}  // namespace manifuzz
