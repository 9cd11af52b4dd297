#pragma once

#include <array>
#include <optional>

#include "campaign/judged_case.hpp"
#include "report/picture/region.hpp"

namespace manifuzz {

/// A face of a polygon where it stands.
struct PlacedFace {
  Side side = Side::a;
  int index = 0;
  Segment segment;
};

/// A depth as a stretch along the normal: from the incident shape's skin to the reference face's.
struct DepthBar {
  Point from{0, 0};
  Point to{0, 0};
  double depth = 0;  ///< world length; negative: a gap
};

/// A contact point that a collider reported.
struct DrawnPoint {
  bool by_subject = true;
  Point position{0, 0};
  Point normal{0, 0};  ///< of its manifold, from A to B, as long as it was reported
  DepthBar bar;
};

/// What a picture of a case shows: world directions and lengths, seen from A's position.
struct Scene {
  std::array<exact::RoughPolygon, 2> polygons;  ///< A's and B's
  std::array<double, 2> radii{};
  /// Of the candidate to show; where the polygons are apart, the face of the greatest separation
  /// alone.
  PlacedFace reference;
  std::optional<PlacedFace> incident;
  std::array<Point, 2> slab;       ///< where the side planes cross the reference face's line
  Point outward{0, 0};             ///< the reference face's normal, unit
  Point normal{0, 0};              ///< the same from A to B
  DepthBar deepest;                ///< the truth at the deepest point
  double rounding = 0;             ///< how far the subject's figures may be off, by its bounds
  std::vector<DrawnPoint> points;  ///< finite ones, the subject's first

  const exact::RoughPolygon& polygon(Side side) const {
    return polygons[static_cast<std::size_t>(side)];
  }
  double radius(Side side) const { return radii[static_cast<std::size_t>(side)]; }
};

Scene make_scene(const JudgedCase& judged);

}  // namespace manifuzz
