#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "collider/collider.hpp"
#include "exchange/reported_manifold.hpp"

namespace manifuzz {

class JsonView;

/// The value of the key "format" in a pair case.
inline constexpr std::string_view kCaseFormat = "manifuzz/case/1";

/// A collider's answer and its name, as a manifold line has them.
struct NamedAnswer {
  std::string collider;
  Answer answer;
};

/// Stands in a collider's place before a manifold that is right by the exact judge.
inline constexpr std::string_view kJudgeName = "judge";

/// One body, validated: {"vertices": [[x, y], ...], "radius": 0, "position": [x, y], "rotation":
/// [cos, sin]}; all but the vertices may be left out. Throws UserError that begins with a path.
Body read_body(const JsonView& object);

/// "f2" for face 2, "v0" for vertex 0.
std::string feature_name(Feature feature);

/// The feature of that name, of any index up to 255; nothing for any other text.
std::optional<Feature> find_feature(std::string_view name);

/// Appends a pair case as one line, without the line's end.
void append_case_line(std::string& out, const PairCase& pair);

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
/// manifold, or {"unsupported": "why"}. Each point has `depth` and `position` (in the world) or
/// `local` (in A's frame), the normal is in the world; reference and features may be left out, and
/// unknown keys are ignored. Throws UserError that begins with a path.
Answer read_reported_answer(const JsonView& object, const PairCase& pair,
                            const Conventions& conventions = {});

}  // namespace manifuzz
