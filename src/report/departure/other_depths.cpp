#include "report/departure/other_depths.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace manifuzz {
namespace {

void try_shared_depths(const ClipChoices& right, const TryChoices& attempt) {
  using enum DepthRule::Share;
  constexpr std::array<std::pair<DepthRule::Share, std::string_view>, 4> kShares{
      {{swapped, "with the depths of the two points swapped"},
       {greatest, "with the greater depth given to both points"},
       {least, "with the lesser depth given to both points"},
       {mean, "with the mean depth given to both points"}}};
  for (const auto& [share, words] : kShares) {
    ClipChoices choices = right;
    choices.depth.share = share;
    attempt(std::string(words), choices);
  }
}

}  // namespace

/// Depths that are shared, of another radius, sign or length, or measured from another face.
void try_depths(const RightWay& way, const TryChoices& attempt) {
  const ClipChoices right = choices_of(way);
  try_shared_depths(right, attempt);
  const auto with = [&](std::string_view words, const auto& change) {
    ClipChoices choices = right;
    change(choices.depth);
    attempt(std::string(words), choices);
  };
  const PairCase& pair = way.truth.pair();
  with("with the radius left out of the depth", [](DepthRule& rule) { rule.radius = 0; });
  with("with A's radius alone in the depth",
       [&](DepthRule& rule) { rule.radius = static_cast<double>(pair.a.polygon.radius); });
  with("with B's radius alone in the depth",
       [&](DepthRule& rule) { rule.radius = static_cast<double>(pair.b.polygon.radius); });
  with("with the radius taken off the depth", [](DepthRule& rule) { rule.radius *= -1; });
  with("with the sign of the depth turned", [](DepthRule& rule) { rule.factor = -1; });
  with("with the distance from the bare reference edge for the depth", [](DepthRule& rule) {
    rule.radius = 0;
    rule.is_without_sign = true;
  });
  with("with half the depth", [](DepthRule& rule) { rule.factor = 0.5; });
  with("with twice the depth", [](DepthRule& rule) { rule.factor = 2; });
  const Side side = way.reference.side;
  const exact::RoughPolygon& polygon = way.polygons[side];
  const double face_length =
      (polygon.vertices[polygon.next(way.reference.index)] - polygon.vertices[way.reference.index])
          .norm();
  with("with a normal as long as the reference edge in the depth",
       [&](DepthRule& rule) { rule.factor = face_length; });
  for (int face = 0; face < polygon.count; ++face) {
    if (face == way.reference.index) continue;
    with(fmt::format("with the depth measured from {}", edge_in_words({side, face})),
         [&](DepthRule& rule) {
           rule.corner = polygon.vertices[face];
           rule.outward = polygon.normals[face];
         });
  }
}

}  // namespace manifuzz
