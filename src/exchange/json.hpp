#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/file.hpp"
#include "base/text.hpp"
#include "collider/collider.hpp"

namespace manifuzz {

class JsonView;

/// The value of the key "format" in a pair case of polygons, rounded by mitres if at all.
inline constexpr std::string_view kCaseFormat = "manifuzz/case/1";
/// The value of the key "format" in a pair case with round shapes, which format 1 cannot say.
inline constexpr std::string_view kCurvedCaseFormat = "manifuzz/case/2";
/// The first of these that can say the case.
std::string_view format_of(const PairCase& pair);

/// How a file, a program or a library gives its manifolds where the contract of `Manifold` is
/// another; the defaults are a program's.
struct Conventions {
  bool has_midpoints = false;  ///< points lie halfway between both surfaces, as Box2D 3 has them
  bool normal_from_b = false;  ///< normals point from B to A
  bool normal_in_a = false;    ///< normals are in A's frame, not in the world's
  bool is_ordered = false;     ///< points are in the contract's order, and stay in theirs
  Claims claims = Claims::manifold;  ///< what an answer says, and must say
  bool shares_depth = false;         ///< one depth for all points
  bool says_shapes = false;          ///< it must say which shapes it used

  /// Whether an answer is about the pair as a whole, without points.
  bool is_without_points() const {
    return claims == Claims::touching || claims == Claims::separation;
  }
};

/// The conventions that follow from a declaration.
inline Conventions conventions_of(const Declaration& declaration) {
  return {
      .has_midpoints = declaration.points == PointsAt::midpoint && !is_judged_by_curve(declaration),
      .claims = declaration.claims,
      .shares_depth = declaration.shares_depth,
      .says_shapes = declaration.alters_shapes};
}

/// How an answer contradicts what its collider declares: too many points, depths that differ where
/// all share one, no shapes where it alters them. None where it does not.
std::optional<std::string> contradiction(const Answer& answer, const Conventions& conventions);

/// "a" or "b". Throws UserError that begins with a path.
Side read_side(const JsonView& value);

/// A number, or {"absolute": x, "relative": x, "towards": "a"|"b"}, each of which may be left out.
/// Throws UserError that begins with a path.
TieBias read_tie_bias(const JsonView& value);

/// "0.0005", or "0.001 and 2% towards a".
std::string in_words(const TieBias& bias);

/// A contact point as it is given: its position at least once, the rest where it is known.
struct ReportedPoint {
  std::optional<Vector2<double>> world{};  ///< its position in world coordinates
  std::optional<Vector2<double>> local{};  ///< its position in A's frame, which then counts
  double depth = 0;                        ///< a world length, >= 0
  std::optional<FeaturePair> features{};   ///< each one that its polygon has
};

/// A manifold as it is given, before any convention of it is undone.
struct ReportedManifold {
  int count = 0;                    ///< of points: 0, 1 or 2
  Vector2<double> normal{0, 0};     ///< unit
  std::optional<Side> reference{};  ///< whose face clips
  std::array<ReportedPoint, 2> points{};
  std::optional<UsedShapes> used{};
};

/// The manifold by our own contract: in A's frame, its normal from A to B, its points in order.
/// What was not given stays open, and midpoints stay where they are, since only a reference face
/// tells which way the incident edge lies.
PartialManifold in_frame_of_a(const ReportedManifold& reported, const Conventions& conventions,
                              const PairCase& pair);

/// The normal in A's frame, as these conventions read it.
Vector2<double> normal_in_frame_of_a(const Vector2<double>& normal, const Conventions& conventions,
                                     const PairCase& pair);

/// A collider's answer and its name, as a manifold line has them.
struct NamedAnswer {
  std::string collider;
  Answer answer;
};

/// Stands in a collider's place before a manifold that is right by the exact judge.
inline constexpr std::string_view kJudgeName = "judge";

/// Fails, saying what is expected, unless the array has two elements.
void expect_two(const JsonView& array, std::string_view expected);

/// One body, validated: {"vertices": [[x, y], ...], "radius": 0, "rounding": "round" or "mitre",
/// "position": [x, y], "rotation": [cos, sin]}; all but the vertices may be left out. Throws
/// UserError that begins with a path.
Body read_body(const JsonView& object);

/// A body's shape alone: as a body, but without "position" and "rotation".
ConvexPolygon<float> read_polygon(const JsonView& object);
/// Appends the same on one line.
void append_polygon(std::string& out, const ConvexPolygon<float>& polygon);

/// Where a body stands: [x, y, cos, sin]. Throws UserError that begins with a path.
Pose<float> read_pose(const JsonView& array);
/// Appends the same.
void append_pose(std::string& out, const Pose<float>& pose);

/// The shapes that an answer says it used: [[x, y], ...], or with round corners {"vertices":
/// [[x, y], ...], "radius": r}; as a member of an object, after others.
void append_shapes(std::string& out, const UsedShapes& used);
/// One of them. Throws UserError that begins with a path.
UsedVertices read_used_vertices(const JsonView& shape);

/// "f2" for face 2, "v0" for vertex 0.
std::string feature_name(Feature feature);

/// The feature of that name, of any index up to 255; nothing for any other text.
std::optional<Feature> find_feature(std::string_view name);

/// The vector with 0 for each -0, for people, to whom a zero's sign says nothing.
inline Vector2<double> without_negative_zeros(const Vector2<double>& v) {
  return {v.x() + 0, v.y() + 0};
}

/// Appends [x,y].
template <class Scalar>
void append_vector(std::string& out, const Vector2<Scalar>& v) {
  out += '[';
  append_number(out, v.x());
  out += ',';
  append_number(out, v.y());
  out += ']';
}

/// Appends a pair case as one line, without the line's end.
void append_case_line(std::string& out, const PairCase& pair);

/// Appends the same for a program: every number with all digits, so that it has one value whether
/// it is read as a double or as a float, and the normals, rounded to the scalar that it declares.
void append_program_line(std::string& out, const PairCase& pair, ScalarType scalar);

/// Appends the same as a corpus file begins: a line for each member, and the last brace not yet.
void append_case_start(std::string& out, const PairCase& pair);

/// Appends a manifold line (without the line's end) in the world of `pair`: normal and positions in
/// world coordinates, `local` in A's frame, depths as world lengths.
void append_answer(std::string& out, const PairCase& pair, std::string_view collider,
                   const Answer& answer);

/// Appends {"normal": ..., "reference": ..., "points": [...]}, a manifold line without its
/// collider.
void append_manifold_object(std::string& out, const PairCase& pair,
                            const Manifold<double>& manifold);

/// Reads what `append_answer` wrote, every key required, null for a number that is not finite.
/// Points are taken from `local`; the normal comes back into A's frame to within a rounding. Throws
/// UserError that begins with a path.
NamedAnswer read_recorded_answer(const JsonView& object, const PairCase& pair);

/// Reads what a program answers: {"points": [...], "normal": ...}, which becomes a partial
/// manifold, or {"unsupported": "why"}. Each point has `depth`, unless one beside the points is
/// that of all, and `position` (in the world) or `local` (in A's frame), the normal is in the
/// world; reference and features may be left out, and unknown keys are ignored. One that claims
/// less says {"touching": true}, or {"normal": ..., "depth": ...}. {"shapes": {"a": [[x, y], ...],
/// "b": ...}}, in the polygons' own frames, is what it used. Throws UserError that begins with a
/// path.
Answer read_reported_answer(const JsonView& object, const PairCase& pair,
                            const Conventions& conventions = {});

/// A collider's answers in a file: a line a case, in order, as programs answer them; blank lines
/// are skipped. What is wrong is a UserError that names the file and the line.
class AnswerFile {
 public:
  AnswerFile(const std::string& path, const Conventions& conventions)
      : file_(path), lines_(file_), conventions_(conventions) {}

  /// Answer number `index`, from 0 and never backwards, to this case.
  Answer at(std::size_t index, const PairCase& pair);

  /// Throws where there are more answers.
  void expect_end();

 private:
  Line next_line();

  InputFile file_;
  LineReader lines_;
  Conventions conventions_;
  std::size_t read_ = 0;
};

}  // namespace manifuzz
