#pragma once

#include <array>
#include <optional>
#include <vector>

#include "clipping/collide.hpp"

// The article's steps of one pair, one by one, by the functions of src/clipping that `clip64` is
// made of.

namespace manifuzz::playground {

/// How two shapes lie, which decides which of the article's steps they take.
enum class Way : unsigned char {
  apart,   ///< a face separates them: nothing follows
  faces,   ///< polygons, or round cores that overlap: the faces of greatest separation
  cores,   ///< round shapes whose cores are apart: where these are nearest
  circle,  ///< one of them is a circle, which has nothing to clip
};

/// One of the first two clips: at the side plane through an end of the reference face.
struct SideClip {
  Vector2<double> corner{0, 0};  ///< where the plane stands, before it is widened
  Vector2<double> inward{0, 0};  ///< unit; what lies against it is cut off
  bool leaves = false;           ///< whether anything is left
  clipping::ClipEdge<double> edge;
};

/// What each step gives. Places, directions and the manifold are in A's frame; lengths are A's own.
struct Steps {
  Way way = Way::apart;
  /// For each of A's faces, and each of B's; for a circle none.
  std::array<std::vector<clipping::FaceSeparation<double>>, 2> separations;
  /// The face of each side's greatest; of a circle none.
  std::array<std::optional<int>, 2> greatest;
  std::optional<clipping::NearestPlaces<double>> nearest;  ///< of cores that are apart
  /// None where nothing is clipped.
  std::optional<clipping::ContactFeatures> features;
  Vector2<double> outward{0, 0};     ///< the direction that depths are measured along, unit
  double margin = 0;                 ///< by how much side planes are widened, a length
  clipping::ClipEdge<double> whole;  ///< the incident edge before it is clipped
  std::array<SideClip, 2> side_clips;
  std::array<double, 2> in_front{0, 0};  ///< how far each end lies in front of the reference face
  /// The clip of these features is not the answer: it misses the deepest vertex, or what round
  /// shapes keep of it is less.
  bool is_replaced = false;
  Manifold<double> manifold;
};

/// The steps of two shapes that stand in one frame, as `clipping::collide_in_frame` takes them.
Steps steps_of(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b);

}  // namespace manifuzz::playground
