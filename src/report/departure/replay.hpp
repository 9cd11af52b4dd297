#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/manifold.hpp"

namespace manifuzz {

// Clipping as the article describes it, in double, with every choice of its steps given from
// outside. All places are world directions and lengths, seen from A's position.

/// The line that one of the first two clips cuts at.
struct SidePlane {
  Vector2<double> corner{0, 0};
  Vector2<double> inward{0, 0};  ///< unit; what lies against it is cut off
  double margin = 0;             ///< how far the plane is moved outwards, a length
  int vertex = 0;                ///< of the reference polygon, at the corner
  bool is_left_out = false;
  bool replaces_other_end = false;  ///< the crossing takes the place of the end inside
  bool loses_crossing = false;      ///< an end that is cut off leaves no crossing
};

/// How the depths of the points that are kept are told.
struct DepthRule {
  /// Which depths the points get, of those that the points have by the rule.
  enum class Share : unsigned char { own, swapped, greatest, least, mean };
  Vector2<double> corner{0, 0};   ///< of the face that depths are measured from
  Vector2<double> outward{0, 0};  ///< of that face, unit
  double radius = 0;              ///< how far the face is moved outwards, a length
  double factor = 1;              ///< of each depth
  bool is_without_sign = false;
  Share share = Share::own;
};

/// Where a contact point is put, beginning from its end of the clipped incident edge.
struct PlaceRule {
  double towards_face = 0;  ///< moved along the face's outward normal by this share of the depth
  Vector2<double> origin{0, 0};  ///< of the frame whose coordinates are taken for A's
  Vector2<double> turn{1, 0};    ///< from that frame's directions to A's, (cos, sin)
};

/// Every choice that the steps make.
struct ClipChoices {
  Side side = Side::a;            ///< whose face clips
  int reference = 0;              ///< the reference face
  Vector2<double> corner{0, 0};   ///< of the reference face
  Vector2<double> outward{0, 0};  ///< the reference face's normal, unit
  Vector2<double> normal{0, 0};   ///< as it is reported, from A to B
  std::array<Vector2<double>, 2> edge{Vector2<double>(0, 0),
                                      Vector2<double>(0, 0)};  ///< along the reference face
  std::array<Feature, 2> ends;                                 ///< the edge's vertices, as features
  int incident = 0;                                            ///< the edge that is clipped
  std::array<SidePlane, 2> planes;
  double radius = 0;  ///< the total radius, a length
  /// Which ends the third clip keeps, in place of those behind the reference face.
  std::optional<std::array<bool, 2>> kept;
  DepthRule depth;
  PlaceRule place;
};

struct ReplayedPoint {
  Vector2<double> place{0, 0};
  double depth = 0;
  FeaturePair features;
  bool is_crossing = false;  ///< of the incident edge and a side plane
};

/// An end of the incident edge between the side planes.
struct ClippedEnd {
  Vector2<double> place{0, 0};
  Feature of_reference;
  Feature of_incident;
  bool is_there = true;

  friend bool operator==(const ClippedEnd&, const ClippedEnd&) = default;
};

/// The first two clips; nothing where the edge lies outside one of the planes.
std::optional<std::array<ClippedEnd, 2>> clipped_edge(const ClipChoices& choices);

/// Which of these ends lie behind the reference face.
std::array<bool, 2> behind_face(const ClipChoices& choices, const std::array<ClippedEnd, 2>& edge,
                                double radius);

/// All three clips, the depths and the places: 0, 1 or 2 points.
std::vector<ReplayedPoint> replay_clip(const ClipChoices& choices);

}  // namespace manifuzz
