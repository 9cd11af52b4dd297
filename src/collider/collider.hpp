#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "collider/least_polygon.hpp"
#include "collider/used_shapes.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// What a collider computes in; its roundoff scales every bound.
enum class ScalarType { float32, float64 };

/// Where a collider rounds: in a frame that travels with the pair, or in world coordinates.
enum class RoundingFrame { local, world };

/// What an answer asserts: the contact points, one of them, how far along which normal they
/// overlap, or only that they touch. What is not claimed is not judged.
enum class Claims { manifold, point, separation, touching };

/// Where contact points lie: on the incident edge, halfway between both surfaces, at a vertex of
/// either core, on A's surface, on B's.
enum class PointsAt { clip, midpoint, vertex, surface_a, surface_b };

/// What keeps the reference on one side's face where both have nearly the same separation, as cores
/// have it: the other side's is taken only where its separation is more than (1 - relative) times
/// the favoured one's, and absolute more. (Box2D 2.4 has 0.0005 and 0, Box2D 2.2 0.001 and 0.02.)
struct TieBias {
  double absolute = 0;  ///< a world length
  double relative = 0;  ///< of the favoured side's separation
  Side towards = Side::a;

  bool is_none() const { return absolute == 0 && relative == 0; }
  friend bool operator==(const TieBias&, const TieBias&) = default;
};

/// How far an iterative collider stops short of the least depth, by its documentation: depths and
/// normals may have that much more excess, points be that much off, depths that much too small.
struct Tolerance {
  double absolute = 0;  ///< a world length
  double relative = 0;  ///< of the least depth

  bool is_none() const { return absolute == 0 && relative == 0; }
};

/// What engines tell shapes apart by: one, two, or more vertices, with mitred or round corners.
enum class ShapeFamily { circle, capsule, polygon, rounded };
inline constexpr std::array<std::string_view, 4> kShapeFamilyNames{"circle", "capsule", "polygon",
                                                                   "rounded"};

inline ShapeFamily shape_family(const ConvexPolygon<float>& shape) {
  if (shape.count < kMinVertices)
    return shape.count == 1 ? ShapeFamily::circle : ShapeFamily::capsule;
  return shape.is_round() ? ShapeFamily::rounded : ShapeFamily::polygon;
}

/// Where a collider takes a face's normal from.
enum class NormalsFrom {
  given,            ///< the normals that come with the case
  vertices,         ///< the face's vertices, in the body's own frame
  world_vertices,   ///< the face's vertices once they are rounded in the world
  given_as_floats,  ///< the normals that come with the case, as floats, whatever it computes in
};

/// What a collider declares of itself. It is judged by this, and by nothing else.
struct Declaration {
  std::string name{};         ///< in tables, options and the names of files
  std::string version{};      ///< of the engine or the library that it calls
  std::string description{};  ///< one line for `list colliders`
  ScalarType scalar = ScalarType::float32;
  RoundingFrame frame = RoundingFrame::local;
  bool takes_angles = false;  ///< a rotation reaches it as an angle, and is rounded once more
  NormalsFrom normals = NormalsFrom::given;
  TieBias tie_bias{};
  int max_vertices = kMaxVertices;  ///< of a polygon; with more it is not asked
  bool takes_radius = true;         ///< false: rounded polygons are not asked
  int min_vertices = kMinVertices;  ///< 2: it takes segments and capsules too; 1: circles as well
  bool takes_round = false;         ///< polygons with round corners
  LeastPolygon least_polygon{};     ///< with less it is not asked
  /// Round pairs of which it has no function, either way about, though it takes both shapes.
  std::vector<std::array<ShapeFamily, 2>> declines{};
  SecondPoint second_point{};  ///< of round shapes that touch along edges
  Claims claims = Claims::manifold;
  bool clips =
      true;  ///< a reference face clips an incident edge; else the penetration curve judges
  PointsAt points = PointsAt::clip;
  bool shares_depth = false;      ///< one depth for all points: the deepest's
  bool one_point_enough = false;  ///< of several right points it may give one
  double speculative = 0;         ///< a world length: it reports points across gaps up to it
  double least_depth = 0;         ///< a world length: shallower contacts may be missing
  bool alters_shapes = false;     ///< it may make polygons its own, and says what it used
  Tolerance tolerance{};
  std::string tolerance_source{};  ///< where its documentation, or its code, states it
  bool normal_from_b = false;      ///< in its own terms; answers here have it from A to B
  std::string snippet{};  ///< of a program that shows one case; report/upstream fills it in
};

/// A collider cannot take this input, and says why. Not an error.
struct Unsupported {
  std::string why;
};

/// A manifold of a program or a library, which may leave out what a judge can tell for itself: in
/// A's frame, as `Manifold` is, but for midpoints.
struct PartialManifold {
  Manifold<double> manifold{};
  bool names_reference = false;
  bool names_features = false;       ///< of every point
  bool has_midpoints = false;        ///< points halfway between both surfaces, as Box2D 3 has them
  std::optional<UsedShapes> used{};  ///< in place of the case's polygons, where it says so
};

/// How far they overlap along a normal, or only whether they touch.
struct Penetration {
  bool touches = false;
  std::optional<Vector2<double>> normal{};  ///< from A to B, in A's frame
  double depth = 0;                         ///< along it, a world length; negative across a gap
  std::optional<UsedShapes> used{};         ///< in place of the case's polygons

  friend bool operator==(const Penetration&, const Penetration&) = default;
};

/// There is no answer: the collider died, took too long, or gave what is no manifold.
struct Lost {
  enum class How { crashed, timed_out, malformed };
  How how = How::crashed;
  std::string why{};
};

/// What a collider answers to a case: a manifold in A's frame, whatever the collider's own frame.
using Answer = std::variant<Manifold<double>, Unsupported, PartialManifold, Lost, Penetration>;

/// The manifold of an answer, complete or not; nullptr where there is none.
inline const Manifold<double>* manifold_in(const Answer& answer) {
  if (const auto* const partial = std::get_if<PartialManifold>(&answer)) return &partial->manifold;
  return std::get_if<Manifold<double>>(&answer);
}

/// The shapes that the answer says it used; nullptr where it says nothing of them.
inline const UsedShapes* used_by(const Answer& answer) {
  const std::optional<UsedShapes>* used = nullptr;
  if (const auto* const partial = std::get_if<PartialManifold>(&answer)) used = &partial->used;
  if (const auto* const less = std::get_if<Penetration>(&answer)) used = &less->used;
  return used != nullptr && *used ? &**used : nullptr;
}

/// Whether the penetration curve judges its answers, and not the clips that it may make.
inline bool is_judged_by_curve(const Declaration& declaration) {
  return !declaration.clips || declaration.claims != Claims::manifold;
}

/// Whether the curve judges its answers to this case: round shapes are never judged by clips.
inline bool is_judged_by_curve(const Declaration& declaration, const PairCase& pair) {
  return is_round(pair) || is_judged_by_curve(declaration);
}

/// Whether it says that it has nothing for such a pair.
inline bool declines(const Declaration& declaration, const PairCase& pair) {
  if (!is_round(pair)) return false;
  const ShapeFamily a = shape_family(pair.a.polygon);
  const ShapeFamily b = shape_family(pair.b.polygon);
  return std::ranges::any_of(declaration.declines, [&](const auto& declined) {
    return declined == std::array{a, b} || declined == std::array{b, a};
  });
}

/// Whether it may be asked a case with these shapes, by what it declares of vertices, rounding and
/// the least polygon.
inline bool takes_shapes(const Declaration& declaration, const PairCase& pair) {
  const auto takes = [&](const ConvexPolygon<float>& shape) {
    const bool is_polygon = shape.count >= kMinVertices;
    const bool has_round_corners = is_polygon && shape.is_round();
    const bool has_radius = is_polygon && shape.radius > 0 && is_round(pair);
    const bool is_large_enough = !is_polygon || declaration.least_polygon.is_none() ||
                                 has_at_least(shape, declaration.least_polygon);
    return shape.count >= declaration.min_vertices && shape.count <= declaration.max_vertices &&
           (!has_round_corners || declaration.takes_round) &&
           (!has_radius || declaration.takes_radius || declaration.takes_round) && is_large_enough;
  };
  return takes(pair.a.polygon) && takes(pair.b.polygon) && !declines(declaration, pair);
}

/// Whether it takes any round shapes.
inline bool takes_round_shapes(const Declaration& declaration) {
  return declaration.min_vertices < kMinVertices || declaration.takes_round;
}

/// Anything that turns a pair case into a manifold. All but the first two are empty where a
/// collider does not offer them.
struct Collider {
  Declaration declaration;
  std::function<Answer(const PairCase&)> collide;
  /// Makes a copy of this collider with another tie bias, a world length.
  std::function<Collider(double tie_bias)> with_tie_bias;
  /// The manifold for a known normal: unit, from A to B, in A's frame.
  std::function<Answer(const PairCase&, const Vector2<double>& normal)> from_normal;
  /// Makes a collider that runs the algorithm in double.
  std::function<Collider()> in_double;
  /// A collider in a process of its own answers many cases at once, cheaper than one by one.
  /// `go_on` is asked several times a second; returns how many were answered, all unless it says
  /// no or the collider has lost too many in a row.
  std::function<std::size_t(std::span<const PairCase>, std::span<Answer>,
                            const std::function<bool()>& go_on)>
      collide_many;

  /// Which round pairs it takes, where its declaration does not say it all.
  std::function<bool(const PairCase&)> takes;

  double seconds_max = 0;  ///< of one in a process of its own: how long over a case, its start too

  /// Whether it runs in a process of its own, so that a crash of it ends nothing else.
  bool is_isolated() const { return static_cast<bool>(collide_many); }
};

/// Whether a collider takes a pair.
inline bool takes(const Collider& collider, const PairCase& pair) {
  const bool is_asked = is_round(pair) && collider.takes;
  return takes_shapes(collider.declaration, pair) && (!is_asked || collider.takes(pair));
}

}  // namespace manifuzz
