#include "report/departure/replay.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/pose.hpp"

namespace manifuzz {
namespace {

Feature feature_of(Feature::Kind kind, int index) {
  return {kind, static_cast<unsigned char>(index)};
}

/// One clip of the incident edge by a side plane, into `ends`; false where all of it lies outside.
bool clip_by(const SidePlane& plane, const ClipChoices& choices, std::array<ClippedEnd, 2>& ends) {
  if (plane.is_left_out) return true;
  const auto& whole = choices.edge;
  const double first = plane.inward.dot(whole[0] - plane.corner) + plane.margin;
  const double second = plane.inward.dot(whole[1] - plane.corner) + plane.margin;
  if (first >= 0 && second >= 0) return true;
  if (first <= 0 && second <= 0) return false;
  const Vector2<double> crossing = whole[0] + first / (first - second) * (whole[1] - whole[0]);
  const bool is_second_cut = first >= 0;
  ClippedEnd& replaced = ends[is_second_cut != plane.replaces_other_end ? 1 : 0];
  replaced = {crossing, feature_of(Feature::Kind::vertex, plane.vertex),
              feature_of(Feature::Kind::face, choices.incident),
              replaced.is_there && !plane.loses_crossing};
  return true;
}

double depth_at(const DepthRule& rule, const Vector2<double>& place) {
  const double depth = rule.factor * (rule.radius - rule.outward.dot(place - rule.corner));
  return rule.is_without_sign ? std::abs(depth) : depth;
}

void share_depths(DepthRule::Share share, std::vector<ReplayedPoint>& points) {
  if (points.size() < 2) return;
  double& first = points[0].depth;
  double& second = points[1].depth;
  using enum DepthRule::Share;
  if (share == swapped) std::swap(first, second);
  if (share == greatest) first = second = std::max(first, second);
  if (share == least) first = second = std::min(first, second);
  if (share == mean) first = second = (first + second) / 2;
}

}  // namespace

std::optional<std::array<ClippedEnd, 2>> clipped_edge(const ClipChoices& choices) {
  const Feature face = feature_of(Feature::Kind::face, choices.reference);
  std::array<ClippedEnd, 2> ends{
      {{choices.edge[0], face, choices.ends[0]}, {choices.edge[1], face, choices.ends[1]}}};
  for (const SidePlane& plane : choices.planes) {
    if (!clip_by(plane, choices, ends)) return std::nullopt;
  }
  return ends;
}

std::array<bool, 2> behind_face(const ClipChoices& choices, const std::array<ClippedEnd, 2>& edge,
                                double radius) {
  const auto is_behind = [&](const ClippedEnd& end) {
    return end.is_there && choices.outward.dot(end.place - choices.corner) <= radius;
  };
  return {is_behind(edge[0]), is_behind(edge[1])};
}

std::vector<ReplayedPoint> replay_clip(const ClipChoices& choices) {
  std::vector<ReplayedPoint> points;
  const auto edge = clipped_edge(choices);
  if (!edge) return points;
  const auto kept = choices.kept.value_or(behind_face(choices, *edge, choices.radius));
  for (std::size_t i = 0; i < edge->size(); ++i) {
    if (!kept[i]) continue;
    const auto& [place, of_reference, of_incident, is_there] = (*edge)[i];
    const FeaturePair features = choices.side == Side::a ? FeaturePair{of_reference, of_incident}
                                                         : FeaturePair{of_incident, of_reference};
    const bool is_crossing = of_incident.kind == Feature::Kind::face;
    points.push_back({place, depth_at(choices.depth, place), features, is_crossing});
  }
  share_depths(choices.depth.share, points);
  for (ReplayedPoint& point : points) {
    const PlaceRule& rule = choices.place;
    point.place += rule.towards_face * point.depth * choices.outward;
    point.place = rotate<double>(rule.turn, point.place - rule.origin);
  }
  return points;
}

}  // namespace manifuzz
