#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A body's new place.
struct BodyMove {
  std::uint32_t body = 0;  ///< its index
  Pose<float> pose;
};

/// The manifolds of a scene as Box2D's contact manager gets them (b2_contact_manager.cpp), without
/// its solver: `b2BroadPhase` with its fattened boxes, and `b2CollidePolygons` on every pair that
/// it reports.
class Box2dPairs {
 public:
  explicit Box2dPairs(std::span<const Body> bodies);
  ~Box2dPairs();
  Box2dPairs(const Box2dPairs&) = delete;
  Box2dPairs& operator=(const Box2dPairs&) = delete;

  /// Collides all pairs, or those alone of which a body moved, as sleep allows.
  void step(std::span<const BodyMove> moves, bool skip_unmoved);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace manifuzz
