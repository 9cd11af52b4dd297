#pragma once

#include <array>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::ledger_of {

// Matter.Collision.collides, as the adapter calls it: the operations are matter-js's in their
// order, so that but for the cosine, sine and arc tangent, which are V8's there, the numbers are
// the engine's.

/// A body as matter-js places it.
struct BodyOfMatter {
  std::vector<Vector2<double>> vertices;  ///< in the world
  std::vector<Vector2<double>> axes;      ///< of those that three decimals tell apart, the last
  std::vector<Vector2<double>> normals;   ///< of every face, computed likewise
  Vector2<double> position{0, 0};         ///< its centre
};

BodyOfMatter body_of_matter(const Body& body);

/// The least overlap of two bodies along some axes.
struct LeastOverlap {
  Vector2<double> axis{0, 0};  ///< unit, in the world
  double overlap = 0;          ///< along it, a world length; of bodies apart 0 or less
  bool is_of_first = false;    ///< the first body reaches farther into the second along the axis
};

LeastOverlap least_overlap(const BodyOfMatter& first, const BodyOfMatter& second,
                           const std::vector<Vector2<double>>& axes);

/// Two vertices of a body: the farthest along a direction, and the farther of its neighbours.
struct SupportsOfMatter {
  std::array<int, 2> index{};       ///< the farthest, then its neighbour
  std::array<bool, 2> is_inside{};  ///< the other body, by Vertices.contains
  bool is_exchanged = false;        ///< of that one is decided the other way
};

/// What it finds.
struct CollisionOfMatter {
  BodyOfMatter a;                         ///< A as it is placed
  BodyOfMatter b;                         ///< B as it is placed
  Vector2<double> normal{0, 0};           ///< from A to B
  bool is_turned = false;                 ///< the centres give the other sign than the overlap has
  double depth = 0;                       ///< that overlap
  SupportsOfMatter of_a{};                ///< along the normal
  SupportsOfMatter of_b{};                ///< against it
  std::vector<Vector2<double>> points{};  ///< in the world
  bool is_none_inside = false;            ///< the one point is A's support, which is not inside B
  bool is_exchanged = false;  ///< what decides within the slack is decided the other way
};

/// Whether of axes that three decimals do not tell apart the last alone is tried, or all are.
enum class AxesOfMatter { merged, all };

/// Nothing where they do not collide. Where overlaps are within `slack` of each other or of 0,
/// vertices along the normal of each other, or one of the other body's outline, by which V8's
/// cosines may exchange them, what it finds of each; as it is decided here before others.
std::vector<CollisionOfMatter> collisions_of_matter(const PairCase& pair, double slack,
                                                    AxesOfMatter axes = AxesOfMatter::merged);

}  // namespace manifuzz::ledger_of
