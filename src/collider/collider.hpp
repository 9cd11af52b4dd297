#pragma once

#include <functional>
#include <span>
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
  bool takes_radius = true;  ///< false: rounded polygons are not asked
  std::string snippet{};     ///< of a program that shows one case; report/upstream.hpp fills it in
};

/// A collider cannot take this input, and says why. Not an error.
struct Unsupported {
  std::string why;
};

/// A manifold from a collider outside, which may leave out what a judge can tell for itself.
struct PartialManifold {
  Manifold<double> manifold{};
  bool names_reference = false;
  bool names_features = false;  ///< of every point
  bool has_midpoints = false;   ///< points halfway between both surfaces, as Box2D 3 has them
};

/// There is no answer: the collider died, hung, or said what is no manifold.
struct Lost {
  enum class How { crashed, timed_out, malformed };
  How how = How::crashed;
  std::string why{};
};

using Answer = std::variant<Manifold<double>, Unsupported, PartialManifold, Lost>;

/// Anything that turns a pair case into a manifold. All but the first two are empty where a
/// collider does not offer them.
struct Collider {
  Declaration declaration;
  std::function<Answer(const PairCase&)> collide;
  std::function<Collider(double tie_bias)> with_tie_bias;
  std::function<Answer(const PairCase&, const Vector2<double>& normal)> from_normal;
  std::function<Collider()> in_double;
  /// Of a collider in a process of its own: answers to many cases at once, cheaper than one by one.
  /// `go_on` is asked several times a second; returns how many were answered, all unless it says
  /// no or the collider has lost too many in a row.
  std::function<std::size_t(std::span<const PairCase>, std::span<Answer>,
                            const std::function<bool()>& go_on)>
      collide_many;

  double seconds_max = 0;  ///< of one in a process of its own: how long over a case, its start too

  /// Whether it runs in a process of its own, so that a crash of it ends nothing else.
  bool is_isolated() const { return static_cast<bool>(collide_many); }
};

}  // namespace manifuzz
