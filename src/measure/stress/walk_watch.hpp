#pragma once

#include <optional>

#include "measure/referee.hpp"
#include "measure/stress/step_tally.hpp"

namespace manifuzz {

/// Watches one collider through the frames of a walk. What the truth itself does is no fault: only
/// what changes while the truth's own choice does not, is counted.
class WalkWatch {
 public:
  /// The next frame; `answer` as it was heard.
  void see(std::uint64_t frame, Referee& referee, const Declaration& declaration,
           const Answer& answer);
  const WalkTally& tally() const { return tally_; }

 private:
  /// What is kept of a frame in which there was a contact, by the collider and by the truth.
  struct Seen {
    Manifold<double> manifold;
    Manifold<double> truth;
    std::optional<Side> reference{};      ///< where it is decided
    std::optional<exact::FaceOf> only{};  ///< the only right reference face, with the only right...
    int incident = 0;                     ///< ...incident edge
    double bound = 0;                     ///< of the points' positions
  };
  static Seen seen(const Manifold<double>& manifold, const Manifold<double>& truth,
                   const Admissible& right);
  void compare(std::uint64_t frame, const Seen& now);

  WalkTally tally_;
  std::optional<Seen> before_;
};

}  // namespace manifuzz
