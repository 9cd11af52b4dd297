#pragma once

#include <cstdint>
#include <optional>

#include "measure/referee.hpp"

namespace manifuzz {

/// Changes from one frame of a walk to the next that the truth does not ask for.
struct Changes {
  std::uint64_t with_margin = 0;   ///< what decides was beyond the bound in both frames
  std::uint64_t within_bound = 0;  ///< rounding may decide
  std::uint64_t first = 0;         ///< the frame of the first with margin

  friend bool operator==(const Changes&, const Changes&) = default;
};

struct WalkChanges {
  std::uint64_t touching = 0;  ///< frames, by the truth
  Changes flickers;            ///< of the reference
  Changes jumps;               ///< of a point, farther than the truth's and both bounds
  Changes features;            ///< or the number of points

  friend bool operator==(const WalkChanges&, const WalkChanges&) = default;
};

/// Counts one collider's changes through the frames of a walk. What the truth itself does is no
/// fault: only what changes while the truth's own choice does not, is counted.
class WalkChangeCounter {
 public:
  /// The next frame; `answer` as `Referee::completed` gives it.
  void add(std::uint64_t frame, Referee& referee, const Declaration& declaration,
           const Answer& answer);
  const WalkChanges& changes() const { return changes_; }

 private:
  /// What is kept of a frame in which there was a contact, by the collider and by the truth.
  struct Frame {
    Manifold<double> manifold;
    Manifold<double> truth;
    std::optional<Side> reference{};      ///< where it is decided
    std::optional<exact::FaceOf> only{};  ///< the only right reference face, with the only right...
    int incident = 0;                     ///< ...incident edge
    double bound = 0;                     ///< of the points' positions
  };
  static Frame frame_of(const Manifold<double>& manifold, const Manifold<double>& truth,
                        const Admissible& right);
  void compare(std::uint64_t frame, const Frame& now);

  WalkChanges changes_;
  std::optional<Frame> before_;
};

}  // namespace manifuzz
