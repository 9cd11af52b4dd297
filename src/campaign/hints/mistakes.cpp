#include "campaign/hints/mistakes.hpp"

#include <array>
#include <numbers>

#include "campaign/hints/answer_mistakes.hpp"
#include "campaign/hints/declaration_mistakes.hpp"
#include "campaign/hints/place_mistakes.hpp"
#include "campaign/hints/reading_mistakes.hpp"

namespace manifuzz {
namespace {

using Asked = const AskedCase&;

constexpr double kDegreesOfRadian = 180 / std::numbers::pi;

constexpr std::string_view kWorldExpected =
    "give positions and normals in the world (\"local\" is a position in A's frame)";
constexpr std::string_view kClipExpected =
    "a clip's points lie on the incident edge; else declare \"clips\": false and \"points\"";
constexpr std::string_view kUnitAdvice =
    "(cos, sin) are floats and not quite of length 1: take them as they stand, or scale the "
    "vertices by sqrt(cos^2 + sin^2), and divide by its square where a rotation is undone";

constexpr std::array kMistakes{
    // Answers.
    Mistake{"reversed-normal", "the normal is turned about",
            "the normal points from B to A; it must point from A to B, or as \"normal\" declares",
            with_normal_turned_about},
    Mistake{"negative-depth", "the depth's sign is changed",
            "the depth is below 0 where the shapes overlap; it must be above 0 there",
            with_depths_negated},
    Mistake{"separation-as-depth", "the depth is taken for the separation of the cores",
            "the depth is the sum of both radii minus the separation", with_separations_as_depths},
    Mistake{"radius-left-out", "both radii are added to the depth",
            "the depth must have the sum of both radii in it", with_radii_added_to_depths},
    Mistake{"radius-left-out", "the shapes have no radius",
            "the radii are not handed to the collider; \"radius\" is around each shape",
            [](Asked asked) { return with_radii_times(0, asked); }},
    Mistake{"radius-twice", "both radii are taken from the depth once",
            "the depth has the sum of both radii in it twice", with_radii_taken_from_depths},
    Mistake{"radius-twice", "the shapes have twice their radius",
            "the radii are counted twice; \"radius\" is around each shape once",
            [](Asked asked) { return with_radii_times(2, asked); }},
    Mistake{"y-down", "y of positions and normals is negated",
            "y points down in the answers; it must point up", with_y_negated},
    Mistake{"y-down", "the vertices are flipped, each shape in its own frame",
            "the vertices' y is negated, or taken to point down; it points up",
            with_vertices_flipped},
    Mistake{"rotation-backwards", "both bodies are turned the other way",
            "rotations are taken to be clockwise; R = [[cos, -sin], [sin, cos]] is "
            "counter-clockwise",
            [](Asked asked) { return with_rotations_backwards(SeenFrom::world, asked); }},
    Mistake{"rotation-backwards", "both bodies are turned the other way",
            "rotations are taken to be clockwise; R = [[cos, -sin], [sin, cos]] is "
            "counter-clockwise",
            [](Asked asked) { return with_rotations_backwards(SeenFrom::frame_of_a, asked); }},
    Mistake{"degrees", "both bodies are turned by their angle in radians, taken for degrees",
            "an angle in radians is handed to what expects degrees",
            [](Asked asked) {
              return with_angles_times(1 / kDegreesOfRadian, SeenFrom::world, asked);
            }},
    Mistake{"degrees", "both bodies are turned by their angle in radians, taken for degrees",
            "an angle in radians is handed to what expects degrees",
            [](Asked asked) {
              return with_angles_times(1 / kDegreesOfRadian, SeenFrom::frame_of_a, asked);
            }},
    Mistake{
        "degrees", "both bodies are turned by their angle in degrees, taken for radians",
        "an angle in degrees is handed to what expects radians",
        [](Asked asked) { return with_angles_times(kDegreesOfRadian, SeenFrom::world, asked); }},
    Mistake{"degrees", "both bodies are turned by their angle in degrees, taken for radians",
            "an angle in degrees is handed to what expects radians",
            [](Asked asked) {
              return with_angles_times(kDegreesOfRadian, SeenFrom::frame_of_a, asked);
            }},
    // Frames.
    Mistake{"frame-of-a", "positions and normal are taken from A's frame", kWorldExpected,
            [](Asked asked) { return from_frame_of(Side::a, InFrame::all, asked); }},
    Mistake{"frame-of-a", "positions are taken from A's frame", kWorldExpected,
            [](Asked asked) { return from_frame_of(Side::a, InFrame::positions, asked); }},
    Mistake{"frame-of-a", "the normal is taken from A's frame", kWorldExpected,
            [](Asked asked) { return from_frame_of(Side::a, InFrame::normal, asked); }},
    Mistake{"frame-of-b", "positions and normal are taken from B's frame", kWorldExpected,
            [](Asked asked) { return from_frame_of(Side::b, InFrame::all, asked); }},
    Mistake{"frame-of-b", "positions are taken from B's frame", kWorldExpected,
            [](Asked asked) { return from_frame_of(Side::b, InFrame::positions, asked); }},
    Mistake{"frame-of-b", "the normal is taken from B's frame", kWorldExpected,
            [](Asked asked) { return from_frame_of(Side::b, InFrame::normal, asked); }},
    Mistake{"world-as-local", "positions are taken from the world",
            "positions that are given as in A's frame are in the world", from_world},
    // Places.
    Mistake{"midpoints", "points are taken for midpoints",
            "points lie halfway between both surfaces: declare \"points\": \"midpoint\"",
            from_midpoints},
    Mistake{"surface-of-a", "points are moved from A's surface to the incident edge", kClipExpected,
            [](Asked asked) { return from_surface_of(Side::a, asked); }},
    Mistake{"surface-of-b", "points are moved from B's surface to the incident edge", kClipExpected,
            [](Asked asked) { return from_surface_of(Side::b, asked); }},
    Mistake{"surface-of-reference",
            "points are moved from the reference's surface to the incident edge", kClipExpected,
            from_reference},
    // Figures and declarations, the stricter first.
    Mistake{"unit-rotation", "rotations are made unit", kUnitAdvice,
            [](Asked asked) { return with_unit_rotations(SeenFrom::world, asked); }},
    Mistake{"unit-rotation", "rotations are made unit", kUnitAdvice,
            [](Asked asked) { return with_unit_rotations(SeenFrom::frame_of_a, asked); }},
    Mistake{"decimals-as-doubles", "the case's numbers are read as doubles",
            "numbers are the shortest decimals of floats: round each to float when it is read",
            [](Asked asked) { return with_decimals_as_doubles(SeenFrom::world, asked); }},
    Mistake{"decimals-as-doubles", "the case's numbers are read as doubles",
            "numbers are the shortest decimals of floats: round each to float when it is read",
            [](Asked asked) { return with_decimals_as_doubles(SeenFrom::frame_of_a, asked); }},
    Mistake{"undeclared-angle", "rotations reach it as angles",
            "declare \"rotation\": \"angle\", or take (cos, sin) as they stand", with_angles, true},
    Mistake{
        "undeclared-world", "it rounds in world coordinates",
        "\"frame\": \"local\" is declared, but figures are as good as world coordinates: declare "
        "\"frame\": \"world\", or subtract the positions first",
        in_world, true},
    Mistake{"undeclared-world-vertices", "normals are taken from world vertices",
            "declare \"normals\": \"world_vertices\" and \"frame\": \"world\", or take each face's "
            "normal from its vertices "
            "in the body's own frame and turn it",
            with_world_vertices, true},
    Mistake{"float-normals", "normals are floats",
            "the normals that it is given are floats; in double take them from the vertices",
            with_float_normals, true},
    Mistake{
        "float-figures", "it computes in float",
        "figures are as good as floats: something is rounded to float, or a rotation's transpose "
        "taken for its inverse; declare \"scalar\": \"float32\", or compute in double throughout",
        in_float, true},
    Mistake{"float-figures", "it computes in float, in the world",
            "figures are as good as floats: something is rounded to float; declare \"scalar\": "
            "\"float32\" and "
            "\"frame\": \"world\", or compute in double throughout",
            in_float_in_world, true},
};

}  // namespace

std::span<const Mistake> mistakes() {
  return kMistakes;
}

}  // namespace manifuzz
