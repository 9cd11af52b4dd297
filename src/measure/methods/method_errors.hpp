#pragma once

#include <memory>

#include "exact/curve.hpp"
#include "measure/methods/methods.hpp"
#include "measure/methods/touching_points.hpp"

namespace manifuzz {

/// What is true of a pair, found once for all subjects.
struct TrueContact {
  explicit TrueContact(const PairCase& pair);

  std::shared_ptr<const exact::Truth> truth;
  exact::PenetrationCurve curve;
  Admissible for_float;  ///< what is right of a collider in float that rounds in A's frame
  ClipNow clip;          ///< in floats
};

/// Collects one subject's answers, frame after frame, or of pairs each of which is a start.
class MethodCollector {
 public:
  void add(std::uint64_t index, const TrueContact& truth, const Declaration& declaration,
           const TouchingPoints& said, bool is_start);

  MethodErrors errors() const;
  FrameErrors frames() const;

 private:
  /// A contact that has lasted so far.
  struct Lasting {
    int frames = 0;
    std::optional<int> complete_after{};
  };
  void add_errors(std::uint64_t index, const TrueContact& truth, const TouchingPoints& said);
  void add_frame(const TrueContact& truth, const ExtentLeftOut& left, const TouchingPoints& said,
                 bool is_start);
  void end_contact();

  MethodErrors counts_;
  ErrorList of_extent_;
  ErrorList of_size_;
  double points_missing_ = 0;
  double extent_lost_ = 0;
  std::uint64_t extents_ = 0;
  std::uint64_t points_ = 0;
  std::uint64_t lingering_ = 0;
  std::uint64_t steps_ = 0;  ///< from a frame to the next whose clips have as many points
  std::uint64_t flickers_ = 0;
  std::vector<std::optional<int>>
      completed_;  ///< of each contact that lasted: after how many frames
  Lasting lasting_;
  ClipNow clip_before_;
  std::size_t points_before_ = 0;
};

}  // namespace manifuzz
