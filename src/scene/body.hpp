#pragma once

#include <cstdint>
#include <span>

#include "afresh/defect.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz::scene {

/// A body of a scene, for as long as it is in it: what is added in its place later has another
/// generation. (A place comes round to a generation again after 2^31 removals.)
struct BodyHandle {
  std::uint32_t index = 0;       ///< of its place in the scene
  std::uint32_t generation = 0;  ///< odd; 0 names no body

  friend bool operator==(const BodyHandle&, const BodyHandle&) = default;
};

/// Where a body stands from this step on, in the world.
struct Move {
  BodyHandle body;   ///< which one
  Pose<float> pose;  ///< in the world
};

/// Two bodies that touch, in a cache line. A is the one of lower index.
struct alignas(64) Contact {
  BodyHandle a;              ///< the manifold is in its frame
  BodyHandle b;              ///< the normal points to it
  Manifold<float> manifold;  ///< of 1 or 2 points, in A's frame; of none where one is a sensor
};

/// A contact that has another index than before: what is kept by index goes with it.
struct RenumberedContact {
  std::uint32_t from = 0;  ///< its index before
  std::uint32_t to = 0;    ///< its index from now on
};

/// Two bodies that touch no longer; one of them may be gone.
struct EndedContact {
  BodyHandle a;  ///< the one of lower index
  BodyHandle b;  ///< the other
};

/// What was done with the candidate pairs of a step: counts that add up to `candidates`.
struct PairCounts {
  std::size_t at_rest = 0;     ///< neither body moved: not looked at
  std::size_t separated = 0;   ///< proven to be apart
  std::size_t recycled = 0;    ///< touching ones, carried along: 0 in strict mode
  std::size_t collided = 0;    ///< by the kernel
  std::size_t candidates = 0;  ///< pairs that there were when they were looked at
};

/// What the parts of a step did; all are counts.
struct StepCounts {
  PairCounts pairs;               ///< what was done with the candidates
  std::size_t moved = 0;          ///< bodies that moved, were added or got another shape
  std::size_t left_boxes = 0;     ///< of them, those that left their fattened box
  std::size_t pairs_added = 0;    ///< candidates that were none before
  std::size_t pairs_dropped = 0;  ///< candidates that are none any more
  std::size_t proofs = 0;         ///< made of pairs that are apart, for longer than this step
};

/// Valid until the scene is next changed.
struct StepResult {
  /// All that touch. A contact keeps its index while it touches, but for those renumbered; the
  /// order depends on nothing but what was done to the scene.
  std::span<const Contact> contacts;
  std::span<const std::uint32_t> began;  ///< indices of contacts that did not touch before
  /// Contacts that took the places of ended ones since the last step, in the order in which they
  /// did; before any began.
  std::span<const RenumberedContact> renumbered;
  std::span<const EndedContact> ended;  ///< since the last step, removed bodies' too
  std::size_t stayed = 0;               ///< all contacts but those that began
  StepCounts counts;                    ///< what was done, and what was skipped
};

/// The first move of a step that is refused, and why.
struct RefusedMove {
  std::size_t index = 0;  ///< among the moves of the step
  Defect defect{};        ///< why
};

/// What a scene takes.
struct Memory {
  std::size_t bodies = 0;  ///< bytes
  std::size_t pairs = 0;   ///< bytes, of contacts and of those that wait for the kernel too
};

}  // namespace manifuzz::scene
