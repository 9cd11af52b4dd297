#include "report/departure/other_clips.hpp"

#include <array>

#include <fmt/format.h>

namespace manifuzz {
namespace {

std::string vertex_in_words(Side side, int vertex) {
  return fmt::format("{}'s vertex {}", side == Side::a ? 'A' : 'B', vertex);
}

/// What may go wrong with a side plane, in words for the plane that is named.
struct PlaneChange {
  std::string_view words;
  void (*change)(SidePlane& plane) = nullptr;
};

constexpr std::array kPlaneChanges{
    PlaneChange{"with {} left out", [](SidePlane& plane) { plane.is_left_out = true; }},
    PlaneChange{"with {} facing the other way",
                [](SidePlane& plane) { plane.inward = -plane.inward; }},
    PlaneChange{"with {} not widened by the radius", [](SidePlane& plane) { plane.margin = 0; }},
    PlaneChange{"with {} moved inwards by the radius",
                [](SidePlane& plane) { plane.margin = -plane.margin; }},
    PlaneChange{"with the crossing at {} in place of the end that lies inside",
                [](SidePlane& plane) { plane.replaces_other_end = true; }},
    PlaneChange{"with no crossing added at {}",
                [](SidePlane& plane) { plane.loses_crossing = true; }},
};

std::string plane_in_words(const RightWay& way, int plane) {
  const Side side = way.reference.side;
  const int first = way.reference.index;
  return fmt::format("the side plane at {}",
                     vertex_in_words(side, plane == 0 ? first : way.polygons[side].next(first)));
}

/// One of the side planes changed, or at another corner.
void try_plane(const RightWay& way, int plane, const TryChoices& attempt) {
  const auto place = static_cast<std::size_t>(plane);
  const std::string named = plane_in_words(way, plane);
  for (const PlaneChange& change : kPlaneChanges) {
    ClipChoices choices = choices_of(way);
    change.change(choices.planes[place]);
    attempt(fmt::format(fmt::runtime(change.words), named), choices);
  }
  const Side side = way.reference.side;
  for (int vertex = 0; vertex < way.polygons[side].count; ++vertex) {
    ClipChoices choices = choices_of(way);
    choices.planes[place].corner = way.polygons[side].vertices[vertex];
    choices.planes[place].vertex = vertex;
    attempt(fmt::format("with {} moved to {}", named, vertex_in_words(side, vertex)), choices);
  }
}

/// Whether both choices clip the edge alike.
bool clip_alike(const ClipChoices& one, const ClipChoices& other) {
  const auto first = clipped_edge(one);
  const auto second = clipped_edge(other);
  if (!first || !second) return !first && !second;
  return first->at(0) == second->at(0) && first->at(1) == second->at(1);
}

}  // namespace

/// The first plane alone, and what goes wrong at both where one rule cuts at both.
void try_first_clips(const RightWay& way, const TryChoices& attempt) {
  try_plane(way, 0, attempt);
  const ClipChoices right = choices_of(way);
  for (const PlaneChange& change : kPlaneChanges) {
    ClipChoices first = right;
    change.change(first.planes[0]);
    ClipChoices second = right;
    change.change(second.planes[1]);
    ClipChoices both = first;
    change.change(both.planes[1]);
    if (clip_alike(both, first) || clip_alike(both, second)) continue;
    attempt(fmt::format(fmt::runtime(change.words), "each side plane"), both);
  }
}

void try_second_clips(const RightWay& way, const TryChoices& attempt) {
  try_plane(way, 1, attempt);
}

namespace {

/// Which ends are kept, in words; `right` are those behind the face.
std::string kept_in_words(const std::array<bool, 2>& kept, const std::array<bool, 2>& right) {
  const bool keeps_one_before = (kept[0] && !right[0]) || (kept[1] && !right[1]);
  const bool drops_one_behind = (right[0] && !kept[0]) || (right[1] && !kept[1]);
  if (!kept[0] && !kept[1]) return "with every end removed";
  if (keeps_one_before && drops_one_behind) {
    return "with the end removed that lies behind the reference edge, and the other one kept";
  }
  return keeps_one_before ? "with this clip left out"
                          : "with an end removed that lies behind the reference edge";
}

}  // namespace

void try_third_clips(const RightWay& way, const TryChoices& attempt) {
  ClipChoices choices = choices_of(way);
  const auto edge = clipped_edge(choices);
  if (!edge) return;
  if (choices.radius > 0) {
    choices.kept = behind_face(choices, *edge, 0);
    attempt("with the radius left out of this clip", choices);
  }
  const auto right = behind_face(choices, *edge, choices.radius);
  for (const std::array<bool, 2>& kept :
       {std::array{true, true}, {true, false}, {false, true}, {false, false}}) {
    if (kept == right) continue;
    choices.kept = kept;
    attempt(kept_in_words(kept, right), choices);
  }
}

}  // namespace manifuzz
