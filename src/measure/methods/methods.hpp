#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collider/sequence_collider.hpp"
#include "measure/bench/bench.hpp"

namespace manifuzz {

// The article's ways to contact points beside each other, in one run: what each takes, by how much
// it is off, what it leaves out, and how it fares from frame to frame.

/// One way to contact points, in one implementation.
struct MethodSubject {
  std::string method;  ///< the way, for people: "clipping", "points kept"
  /// Its name, how pairs are timed (empty: they are not), and its answers to one pair.
  BenchSubject bench;
  /// In place of that collider, of one that keeps points over frames.
  std::function<SequenceCollider()> keeper{};
};

/// The ways of this repository; engines are the caller's to add.
std::vector<MethodSubject> own_methods();

/// What is off and what is left out, over many pairs or frames.
struct MethodErrors {
  ErrorSpreads of_extent;  ///< as `bench` has it: in units of 2^-24 of the extent; normals of 2^-24
  ErrorSpreads of_size;    ///< shares of the size
  std::uint64_t contacts = 0;  ///< pairs or frames that clearly touch
  std::uint64_t missed = 0;    ///< of these, those without a point
  std::uint64_t phantom = 0;   ///< those with one that are clearly apart
  std::uint64_t cases = 0;     ///< answered
  double points_missing = 0;   ///< on average of contacts: the clip's points, less those there are
  double extent_lost = 0;      ///< on average of contacts with an extent: the share not spanned
};

/// What shows only from frame to frame. Of frames in which rounding decides nothing.
struct FrameErrors {
  /// For contacts that get two points and last: frames until both are there and span 95% of the
  /// clip, 1 being at once. The median; none where fewer than half ever have them.
  std::optional<double> frames_to_complete{};
  double completed = 0;  ///< the share of such contacts that ever have both
  double lingering = 0;  ///< the share of points said to touch where the shapes do not
  double flicker =
      0;  ///< the share of frames in which the number of points changes, the clip's not
};

/// One subject over one workload.
struct MethodRow {
  std::string method;
  BenchSubject subject;
  std::string depths;  ///< of the pairs: "mixed", "apart", "shallow", "deep"; "frames" of motions
  WorkloadSpec spec;
  std::optional<Timing> timing;  ///< a pair, or a frame; none where it runs in another process
  MethodErrors errors;
  std::optional<FrameErrors> frames;  ///< of motions
};

struct MethodsOptions {
  std::uint64_t seed = 1;
  std::size_t judged = 5'000;   ///< pairs a workload
  std::size_t sequences = 250;  ///< of each motion
  TimingOptions timing;
};

/// Below this share of the size an overlap is shallow.
inline constexpr double kShallow = 0.05;

/// Mixed pairs first, then each vertex count, each depth; at last the motions' frames, of polygons
/// without radius.
std::vector<MethodRow> run_methods(const std::vector<MethodSubject>& subjects,
                                   const MethodsOptions& options,
                                   const std::function<void(std::size_t)>& on_workload);

/// How many workloads there are.
std::size_t method_workload_count();

}  // namespace manifuzz
