#include "report/departure/steps.hpp"

#include <array>

#include <fmt/format.h>

#include "geometry/pose.hpp"
#include "report/departure/other_clips.hpp"
#include "report/departure/other_depths.hpp"

namespace manifuzz {
namespace {

using exact::FaceOf;

FaceOf incident_of(const RightWay& way) {
  return {other(way.reference.side), way.incident};
}

char letter(Side side) {
  return side == Side::a ? 'A' : 'B';
}

/// Tries a face as the reference, with each edge that is right for it as the incident one.
void try_reference(const RightWay& way, FaceOf face, const TryChoices& attempt) {
  const auto with_separation = [&](FaceOf of) {
    return fmt::format("{}'s face {} (separation {:.4g})", letter(of.side), of.index,
                       way.truth.separation(of));
  };
  for (const int edge : way.truth.incident_edges(face, way.bounds.incident_dot)) {
    attempt(fmt::format("with {} in place of {}", with_separation(face),
                        with_separation(way.reference)),
            choices_of(way, face, {other(face.side), edge}));
  }
}

/// Takes another face than the one of the greatest separation; or no contact, where only
/// the radius makes one.
void try_separations(const RightWay& way, const TryChoices& attempt) {
  if (!way.is_apart && way.truth.separation() > 0) {
    ClipChoices nothing = choices_of(way);
    nothing.kept = {false, false};
    attempt("with the radius left out of the test whether they touch", nothing);
  }
  for (const FaceOf face : exact::all_faces(way.truth.stored())) {
    const bool is_best_of_other =
        face.side != way.reference.side && face == way.truth.greatest(face.side);
    if (face == way.reference || (is_best_of_other && !way.is_apart)) continue;
    try_reference(way, face, attempt);
  }
}

/// The other polygon's face, the two edges with their parts exchanged, or another normal.
void try_reference_edges(const RightWay& way, const TryChoices& attempt) {
  const ClipChoices right = choices_of(way);
  if (!way.is_apart) {
    try_reference(way, way.truth.greatest(other(way.reference.side)), attempt);
  }
  const FaceOf incident = incident_of(way);
  const ClipChoices exchanged = choices_of(way, incident, way.reference);
  attempt("with reference and incident edge exchanged", exchanged);
  ClipChoices turned = right;
  turned.normal = -right.normal;
  attempt("with the normal not turned to point from A to B", turned);
  ClipChoices of_incident = right;
  of_incident.normal = exchanged.normal;
  attempt("with the normal of the incident edge in place of the reference edge's", of_incident);
}

void try_incident_edges(const RightWay& way, const TryChoices& attempt) {
  const FaceOf incident = incident_of(way);
  for (const Side side : {incident.side, way.reference.side}) {
    for (int i = 0; i < way.polygons[side].face_count(); ++i) {
      const FaceOf edge{side, i};
      if (edge == incident || edge == way.reference) continue;
      const std::string instead =
          side == incident.side ? fmt::format("edge {}", incident.index) : edge_in_words(incident);
      attempt(fmt::format("with {} in place of {}", edge_in_words(edge), instead),
              choices_of(way, way.reference, edge));
    }
  }
}

/// Points that are not on the incident edge, or in another frame than A's.
void try_places(const RightWay& way, const TryChoices& attempt) {
  const auto with = [&](std::string_view words, const PlaceRule& place) {
    ClipChoices choices = choices_of(way);
    choices.place = place;
    attempt(std::string(words), choices);
  };
  with("with each point halfway between incident and reference edge", {.towards_face = 0.5});
  with("with each point on the reference edge", {.towards_face = 1});
  const PairCase& pair = way.truth.pair();
  const Vector2<double> turn_a = pair.a.pose.rotation.cast<double>();
  const Vector2<double> turn_b = pair.b.pose.rotation.cast<double>();
  const Vector2<double> position_a = pair.a.pose.position.cast<double>();
  const Vector2<double> position_b = pair.b.pose.position.cast<double>();
  with("with world coordinates taken for those of A's frame",
       {.origin = -position_a, .turn = turn_a});
  with("with coordinates of B's frame taken for those of A's",
       {.origin = position_b - position_a, .turn = rotate_inverse<double>(turn_b, turn_a)});
}

constexpr std::array kClipSteps{
    ClipStep{"the separation", try_separations},
    ClipStep{"the reference edge", try_reference_edges},
    ClipStep{"the incident edge", try_incident_edges},
    ClipStep{"clip 1", try_first_clips},
    ClipStep{"clip 2", try_second_clips},
    ClipStep{"clip 3 (behind the reference edge)", try_third_clips},
    ClipStep{"the depth", try_depths},
    ClipStep{"the points' places", try_places},
};

}  // namespace

ClipChoices choices_of(const RightWay& way, FaceOf reference, FaceOf edge) {
  const exact::RoughPolygon& polygon = way.polygons[reference.side];
  const exact::RoughPolygon& clipped = way.polygons[edge.side];
  ClipChoices choices;
  choices.side = reference.side;
  choices.reference = reference.index;
  choices.incident = edge.index;
  choices.radius = total_radius(way.truth.pair());
  choices.corner = polygon.vertices[reference.index];
  choices.outward = polygon.normals[reference.index];
  choices.normal = reference.side == Side::a ? choices.outward : Vector2<double>(-choices.outward);
  const std::array ends{clipped.next(edge.index), edge.index};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    choices.edge[i] = clipped.vertices[ends[i]];
    choices.ends[i] = {Feature::Kind::vertex, static_cast<unsigned char>(ends[i])};
  }
  const Vector2<double> along = counter_clockwise_quarter(choices.outward);
  const int first = reference.index;
  const int second = polygon.next(first);
  choices.planes[0] = {polygon.vertices[first], along, choices.radius, first};
  choices.planes[1] = {polygon.vertices[second], -along, choices.radius, second};
  choices.depth = {choices.corner, choices.outward, choices.radius};
  return choices;
}

ClipChoices choices_of(const RightWay& way) {
  return choices_of(way, way.reference, incident_of(way));
}

std::string edge_in_words(FaceOf edge) {
  return fmt::format("{}'s edge {}", letter(edge.side), edge.index);
}

std::span<const ClipStep> clip_steps() {
  return kClipSteps;
}

}  // namespace manifuzz
