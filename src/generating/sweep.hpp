#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A family of cases with one knob, turned from benign to absurd while all else stays benign.
struct Sweep {
  std::string_view name;
  std::string_view description;  ///< one line for `list sweeps`
  std::string_view knob;         ///< what is turned, in words
  std::string_view unit;
  std::vector<double> values;  ///< 20 or more, from benign to absurd
  /// One attempt at a touching or nearly touching pair: false where floats leave no such pair.
  bool (*attempt)(Random& random, double knob, PairCase& pair);
  bool is_round = false;  ///< of round shapes
};

/// Every sweep, in the order of `list sweeps`.
std::span<const Sweep> sweeps();

/// Case `index` of a sweep with its knob at `value`: a function of (seed, the sweep's name, value,
/// index) alone.
PairCase draw_case(std::uint64_t seed, const Sweep& sweep, double value, std::uint64_t index);

/// From 10^from to 10^to, a power of ten after the other: the mantissas times the power where the
/// powers rise, so many tenths of it where they fall. Each is the double nearest to the decimal.
std::vector<double> decades(std::initializer_list<int> mantissas, int from, int to);

/// 2^from, ..., 2, 1, 0.
std::vector<double> powers_of_two_to_zero(int from);

// What sweeps draw from: everything that no knob turns is benign.

/// A regular polygon, stretched a little and turned, between 0.5 and 3 across.
Outline benign_outline(Random& random, int most = kMaxVertices);

/// Gives the outline axes of its own; nothing moves.
void give_own_axes(Random& random, Sketch& sketch);

/// Touching or nearly so, as deep as a quarter of `unit`; one in four rounded.
void meet(Random& random, Draft& draft, double unit);

/// Turns the drawing in the world and stands it up to two of its sizes from the origin. B's
/// vertices take up what rounding its position leaves.
void stand_near(Random& random, Draft& draft);

}  // namespace manifuzz

namespace manifuzz::turn {

/// The one list of sweeps: a name, what its knob is and its unit, the knob's values, and a line for
/// `list sweeps`. Each is a function of that name below, defined in a file of its theme
/// (sweeps.cpp). A case depends on the name, not on the place.
#define MANIFUZZ_SWEEPS(SWEEP)                                                                     \
  SWEEP(distance, "distance from the origin", "world lengths, of polygons 0.5 to 3 across",        \
        decades({1, 2, 5}, 0, 8), "both bodies far from the world's origin")                       \
  SWEEP(angle, "angle between facing faces", "its tangent", decades({10, 5, 2}, 0, -9),            \
        "two facing faces, ever nearer to parallel")                                               \
  SWEEP(aspect, "aspect ratio", "length over thickness", decades({1, 2, 5}, 0, 8),                 \
        "one polygon or both ever thinner")                                                        \
  SWEEP(small, "size, downwards", "world lengths", decades({10, 3}, 0, -18),                       \
        "everything ever smaller")                                                                 \
  SWEEP(large, "size, upwards", "world lengths", decades({1, 3}, 0, 18), "everything ever larger") \
  SWEEP(ratio, "size ratio", "larger over smaller", decades({1, 2, 3, 5}, 0, 6),                   \
        "one polygon ever smaller than the other")                                                 \
  SWEEP(depth, "depth", "share of the size", decades({10, 5, 2}, 0, -9),                           \
        "an overlap from the whole size to almost none")                                           \
  SWEEP(collinear, "turn at a vertex", "its tangent", decades({10, 5, 2}, -1, -9),                 \
        "a vertex on a face at the contact, ever less out of line")                                \
  SWEEP(chamfer, "chamfer", "share of its polygon's size", decades({10, 5, 3, 2}, -1, -7),         \
        "a corner at the contact cut ever smaller")                                                \
  SWEEP(off_unit, "rotation off unit", "|cos^2 + sin^2 - 1|", kOffUnitValues,                      \
        "rotations that are ever less unit")                                                       \
  SWEEP(tie, "lead of a face", "ulps from a tie", powers_of_two_to_zero(20),                       \
        "two faces, or two incident edges, ever nearer to a tie")                                  \
  SWEEP(touch, "gap", "ulps from touching", powers_of_two_to_zero(20),                             \
        "a gap, or an overlap, ever nearer to none")                                               \
  SWEEP(corner, "end of an edge", "ulps from the side plane", powers_of_two_to_zero(20),           \
        "an end of the incident edge ever nearer to where it is clipped")

/// The sweeps of round shapes (sweeps_curved.cpp).
#define MANIFUZZ_ROUND_SWEEPS(SWEEP)                                                              \
  SWEEP(capsule_angle, "angle between capsules", "its tangent", decades({10, 5, 2}, 0, -9),       \
        "two capsules side by side, ever nearer to parallel")                                     \
  SWEEP(roundness, "radius", "radius over the core's length", decades({1, 2, 5}, 0, 8),           \
        "capsules whose cores are ever smaller than their radii")                                 \
  SWEEP(core_distance, "distance of the cores", "share of the size", decades({10, 5, 2}, -1, -9), \
        "the cores of circles and capsules ever nearer to each other")                            \
  SWEEP(round_distance, "distance from the origin", "world lengths, of shapes 0.5 to 3 across",   \
        decades({1, 2, 5}, 0, 8), "circles and capsules far from the world's origin")

#define MANIFUZZ_DECLARE(name, knob, unit, values, description) \
  bool name(Random& random, double value, PairCase& pair);
MANIFUZZ_SWEEPS(MANIFUZZ_DECLARE)
MANIFUZZ_ROUND_SWEEPS(MANIFUZZ_DECLARE)
#undef MANIFUZZ_DECLARE

}  // namespace manifuzz::turn

namespace manifuzz {

/// How one pair moves through a random walk: B over a face of A, or all round A. Every quantity
/// goes up or down by up to its step each frame, and turns back at its ends. Lengths are world
/// lengths, the polygons being 1 to 3 across.
struct Walk {
  std::string_view name;
  std::string_view description;  ///< one line for `list sweeps`
  int count_a = 4;
  int count_b = 4;
  double gap_low = 0;
  double gap_high = 0;
  double gap_step = 0;
  double aside_max = 0;  ///< along A's face
  double aside_step = 0;
  double tilt_max = 0;  ///< the tangent of the angle between both faces
  double tilt_step = 0;
  double turn_step = 0;  ///< the tangent of B's turn, and of its way round A, without an end
};

std::span<const Walk> walks();

/// The frames of a walk, which depend on (seed, the walk's name) alone.
class Walker {
 public:
  Walker(std::uint64_t seed, const Walk& walk);
  PairCase next();

 private:
  double moved(double at, double step, double low, double high);

  const Walk& walk_;
  Random random_;
  PairCase pair_;  ///< B at its last place
  Vector2<double> rotation_a_;
  Vector2<double> turn_{1, 0};     ///< of B, against A
  Vector2<double> heading_{0, 1};  ///< from A to B, in A's frame
  double gap_ = 0;
  double aside_ = 0;
  double tilt_ = 0;
};

/// Frame `index` of a walk.
PairCase frame_of(std::uint64_t seed, const Walk& walk, std::uint64_t index);

}  // namespace manifuzz
