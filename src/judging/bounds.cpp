#include "judging/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz {
namespace {

/// In units of the roundoff; bounds.md derives them.
struct Constants {
  double separation;
  double incident_dot;
  double normal;
  double position;
};
constexpr Constants kOfFloat{15, 9, 6, 10};
constexpr Constants kOfDouble{26, 17, 12, 14};
constexpr double kOfWorldNormal = 9;  ///< more for a double one's normal in world coordinates
constexpr double kOfAngles = 8;       ///< more of each for one that takes angles
constexpr double kOfVertices = 2;     ///< more for a float one's normal, if it is none of the given
constexpr double kOfWorldVertex = 3.42;
constexpr double kOfScaledVertex = 3;  ///< more for a double one's, which has to scale it

double smallest(ScalarType scalar) {
  return scalar == ScalarType::float32
             ? static_cast<double>(std::numeric_limits<float>::denorm_min())
             : std::numeric_limits<double>::denorm_min();
}

/// Beyond it a float collider's sums and differences overflow.
constexpr double kFloatReachMax = static_cast<double>(std::numeric_limits<float>::max()) / 4;

}  // namespace

double rotation_defect(const Body& body) {
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  return std::abs(rotation.dot(rotation) - 1);
}

double roundoff(ScalarType scalar) {
  return scalar == ScalarType::float32 ? std::numeric_limits<float>::epsilon() / 2.0
                                       : std::numeric_limits<double>::epsilon() / 2.0;
}

Bounds bounds(const PairCase& pair, const Declaration& declaration) {
  return bounds(pair, declaration, extent(pair));
}

Bounds bounds(const PairCase& pair, const Declaration& declaration, double extent) {
  const bool narrow = declaration.scalar == ScalarType::float32;
  const bool in_world = declaration.frame == RoundingFrame::world;
  const Constants& of = narrow ? kOfFloat : kOfDouble;
  const double of_angles = declaration.takes_angles ? kOfAngles : 0;
  const bool are_given = declaration.normals == NormalsFrom::given ||
                         declaration.normals == NormalsFrom::given_as_floats;
  const double of_vertices = narrow && !are_given ? kOfVertices : 0;
  const double of_normal = of.normal + of_vertices + (in_world && !narrow ? kOfWorldNormal : 0);
  const double u = roundoff(declaration.scalar);
  double reach = extent + total_radius(pair);
  const double underflow = of.separation * smallest(declaration.scalar);
  const double of_rotations =
      (narrow ? rotation_defect(pair.a) + rotation_defect(pair.b) : 0) + of_angles * u;
  const double of_lengths = of_rotations * reach + underflow;
  const bool has_float_normals = !narrow && declaration.normals == NormalsFrom::given_as_floats;
  const double of_float_normals = has_float_normals ? roundoff(ScalarType::float32) : 0;
  const double of_turned_lengths = 2 * of_float_normals * reach;
  const double of_turned_radii = is_round(pair) ? of_float_normals * total_radius(pair) : 0;
  const double in_world_reach = reach + std::max(pair.a.pose.position.cast<double>().norm(),
                                                 pair.b.pose.position.cast<double>().norm());
  if (in_world) reach = in_world_reach;
  if (narrow && reach > kFloatReachMax) {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    return {unbounded, unbounded, unbounded, unbounded};
  }
  const double of_world_vertex = (kOfWorldVertex + (narrow ? 0 : kOfScaledVertex)) * u;
  const bool are_of_world = declaration.normals == NormalsFrom::world_vertices;
  return {
      .separation = (of.separation + of_vertices) * u * reach + of_lengths + of_turned_lengths,
      .incident_dot = (of.incident_dot + 2 * of_vertices) * u + of_rotations + 4 * of_float_normals,
      .normal = of_normal * u + of_rotations + of_float_normals,
      .position = of.position * u * reach + of_lengths + of_turned_radii,
      .vertex = declaration.takes_angles && !narrow ? u : 0,
      .world_vertex = are_of_world ? of_world_vertex * in_world_reach : 0};
}

}  // namespace manifuzz
