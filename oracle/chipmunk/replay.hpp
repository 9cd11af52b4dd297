#pragma once

#include <array>

#include "judging/faults/replayed.hpp"

namespace manifuzz::munk {

/// What a replay may do otherwise than the port, to tell whether an answer is wrong by it: bits.
enum class Fault : unsigned {
  world = 1,            ///< corners are rounded in the world, not about A's position
  ends = 2,             ///< a place on a long edge is its end where its share rounds to that
  support_edge = 4,     ///< dots tell which of two faces is met, not how far an edge is turned
  distance = 8,         ///< a distance is along the normal of shapes that were swapped
  polygon_radius = 16,  ///< CircleToPoly has a polygon's radius on the wrong side
  length = 32           ///< lengths are longer before something is divided
};

/// What a port of Chipmunk's has of its own.
struct Port {
  double to_length = 0;     ///< by which lengths and runs are longer before something is divided
  double of_polygon = -1;   ///< by which CircleToPoly multiplies the polygon's radius
  bool is_guarded = false;  ///< ClosestT gives 0 where both points are one
  unsigned mended = 0;      ///< the faults that it is without, as bits; of no port
};

/// Chipmunk itself, which adds the least positive double: it matters beside zero alone.
inline constexpr Port kChipmunk{.to_length = 0x1p-1022, .of_polygon = 1};
/// cp, in whose doubles 1e-15 is added where Chipmunk adds the least positive one.
inline constexpr Port kCp{.to_length = 1e-15, .of_polygon = 1};
/// Munk2D of pymunk.
inline constexpr Port kMunk{.to_length = 0x1p-1022, .is_guarded = true};

/// A pair of points, on A's surface and on B's, in the world.
struct Touch {
  Vector2<double> on_a{0, 0};
  Vector2<double> on_b{0, 0};
  double distance = 0;
};

/// What ShapesCollide gives.
struct Found {
  int count = 0;                 ///< of points
  Vector2<double> normal{0, 0};  ///< in the world, from A to B
  std::array<Touch, 2> points;
  bool has_equal_corners = false;  ///< an edge that EPA was to expand had no length
  Vector2<double> origin{0, 0};    ///< in the world, from where points are measured
};

/// The port without these faults, which are bits.
Port mended(const Port& port, unsigned faults);

/// All that a port does with a pair, in its order and in doubles.
Found found_by(const Port& port, const PairCase& pair);

/// What its adapter answers: of polygons the points on the edge that is not the reference's.
replayed::Contact contact_of(const Found& found, Side reference);

/// Whether the answer is what that port makes of the case.
bool is_given_by(const Port& port, const Deviation& deviation);
/// Whether it is what one of the ports makes of it.
bool is_given_by_any(const Deviation& deviation);
/// Whether it would be right, with its points on either edge where the answer had none that says.
bool is_right(const Deviation& deviation, const Found& found);

}  // namespace manifuzz::munk
