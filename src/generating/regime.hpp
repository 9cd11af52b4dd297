#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "base/random.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// What a regime may draw from besides its random numbers.
struct GenerationContext {
  std::span<const PairCase> corpus;  ///< sorted, read once at start; empty is allowed
  std::optional<float> radius;       ///< of each polygon, in place of the regime's own
  /// The radius of each polygon where both have sharp corners; `radius` comes before it.
  std::optional<float> mitred_radius{};
  /// Which cases of round shapes are asked for; all where it is empty, or where none is drawn.
  std::function<bool(const PairCase&)> takes{};
  /// Which cases with sharp corners are asked for; all where it is empty.
  std::function<bool(const PairCase&)> takes_mitred{};
};

/// A named family of cases. Adding one changes no case of another.
struct Regime {
  std::string_view name;
  std::string_view description;  ///< one line for `list regimes`
  /// One attempt: false where rounding to floats spoilt a polygon, and then the pair is anything.
  /// `generate` below makes cases of it.
  bool (*attempt)(Random& random, const GenerationContext& context, PairCase& pair);
  bool is_round = false;                 ///< of round shapes
  std::uint64_t stream = hash_of(name);  ///< of its random numbers
};

/// Every regime, in the order of `list regimes`.
std::span<const Regime> regimes();

/// The regimes of polygons with sharp corners, the first of all.
std::span<const Regime> polygon_regimes();
/// The regimes of round shapes, all the others.
std::span<const Regime> round_regimes();

/// The regime of that name, or nullptr.
const Regime* find_regime(std::string_view name);

/// Case `index` of a regime: a function of (seed, the regime's name, index) and, for the regimes
/// that say so, of the corpus.
PairCase generate(std::uint64_t seed, const Regime& regime, std::uint64_t index,
                  const GenerationContext& context = {});

/// Whether the case is one that is asked for.
bool is_taken(const GenerationContext& context, const PairCase& pair);

/// Gives polygons the radius that is asked for; circles and capsules keep their own.
void put_radius(const GenerationContext& context, PairCase& pair);

}  // namespace manifuzz

namespace manifuzz::draw {

/// The one list of regimes: a name, and a line for `list regimes`. Each is a function of that name
/// below, defined in a file of its theme (regimes_*.cpp). A case depends on the name, not on the
/// place.
#define MANIFUZZ_REGIMES(REGIME)                                                                 \
  REGIME(generic, "random polygons of any count, as a broad phase would pass them on")           \
  REGIME(boxes, "rectangles, often with parallel sides")                                         \
  REGIME(regular, "regular polygons, often aligned")                                             \
  REGIME(grid, "small integers, half-integer places, right angles: exact ties")                  \
  REGIME(sliver, "ten to a hundred thousand times as long as thick, plunging and lying flat")    \
  REGIME(near_parallel, "facing faces at 1e-1 to 1e-9 from parallel, or exactly parallel")       \
  REGIME(tied_faces, "two faces, or two incident edges, that float can hardly tell apart")       \
  REGIME(micro_edge, "corners chamfered by 1e-7 to 1e-2 of the size, at the contact")            \
  REGIME(near_collinear, "a vertex on a face, out by as little as floats allow, at the contact") \
  REGIME(corner_corner, "a corner just off, or barely in, a corner")                             \
  REGIME(corner_face, "a corner in, or just off, the inside of a face")                          \
  REGIME(touching, "separation within a few ulps of the total radius")                           \
  REGIME(deep, "one inside the other, often concentric, of like or very different sizes")        \
  REGIME(tie_bias, "the best faces of A and B lead by about 0 or by about 0.0005, Box2D's bias") \
  REGIME(separated, "apart: mostly well, some just beyond near")                                 \
  REGIME(far_from_origin, "both bodies 1e0 to 1e7 from the origin")                              \
  REGIME(scaled, "sizes of 1e-6 to 1e6")                                                         \
  REGIME(off_unit, "rotations with |c^2 + s^2 - 1| up to just below 1e-5")                       \
  REGIME(ulp, "a case of another regime, a few of its numbers moved by a few ulps")              \
  REGIME(corpus, "a case of the corpus, mutated; generic while the corpus is empty")

/// The regimes of round shapes, with their descriptions.
#define MANIFUZZ_ROUND_REGIMES(REGIME)                                                            \
  REGIME(circles, "circles with circles, and with polygons of sharp or round corners")            \
  REGIME(capsules, "capsules and segments with each other, with circles and polygons")            \
  REGIME(round_corners, "polygons with round corners, with each other and with sharp ones")       \
  REGIME(mixed_shapes, "circles, segments, capsules, rounded polygons and polygons, any two")     \
  REGIME(in_line, "capsules end to end on one line, or nearly, on each other, or across")         \
  REGIME(tilted_edges, "edges at 1e-1 to 1e-9 from parallel, or from engines' own angle")         \
  REGIME(voronoi_lines, "a circle or an end in front of a corner, on the line where a face ends") \
  REGIME(cores_touch,                                                                             \
         "cores that touch or nearly, a centre on an edge or a corner, one shape twice")          \
  REGIME(large_radii, "radii of 4 to 10,000 times the cores")                                     \
  REGIME(side_planes, "the end of one edge in front of the end of another")

#define MANIFUZZ_DECLARE(name, description) \
  bool name(Random& random, const GenerationContext& context, PairCase& pair);
MANIFUZZ_REGIMES(MANIFUZZ_DECLARE)
MANIFUZZ_ROUND_REGIMES(MANIFUZZ_DECLARE)
#undef MANIFUZZ_DECLARE

}  // namespace manifuzz::draw
