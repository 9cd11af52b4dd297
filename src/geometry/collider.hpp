#pragma once

#include <functional>
#include <string>
#include <variant>

#include "geometry/manifold.hpp"

namespace manifuzz {

enum class ScalarType { float32, float64 };

/// Where a collider rounds: in a frame that travels with the pair, or in world coordinates.
enum class RoundingFrame { local, world };

/// What a collider says of itself. It is judged by this, and by nothing else.
struct Declaration {
  std::string name;
  std::string version;
  std::string description;  ///< one line for `list colliders`
  ScalarType scalar = ScalarType::float32;
  RoundingFrame frame = RoundingFrame::local;
  double tie_bias = 0;  ///< a length: B's face is the reference only where it leads by more
  int max_vertices = kMaxVertices;
};

/// A collider cannot take this input, and says why. Not an error.
struct Unsupported {
  std::string why;
};

using Answer = std::variant<Manifold<double>, Unsupported>;

/// Anything that turns a pair case into a manifold. The last three are empty where a collider does
/// not offer them.
struct Collider {
  Declaration declaration;
  std::function<Answer(const PairCase&)> collide;
  std::function<Collider(double tie_bias)> with_tie_bias;
  std::function<Answer(const PairCase&, const Vector2<double>& normal)> from_normal;
  std::function<Collider()> in_double;
};

}  // namespace manifuzz
