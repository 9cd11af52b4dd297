#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "exact/truth.hpp"

namespace manifuzz {

/// What the exact truth says of a case, each as one of kBins bins. The first are labels, which name
/// a thing; the others are figures, a bin for each power of ten. Faces, edges and ends are those of
/// the pair's own clip: of its greatest separation's face and the first best incident edge.
enum class Condition : unsigned char {
  // labels
  count_a,         ///< vertices of A's core
  count_b,         ///< vertices of B's core
  corners,         ///< which of both shapes are round
  reference_side,  ///< A, B, or no face at all
  reference_face,
  incident_edge,
  points,  ///< how many the clip keeps; none where they are apart
  cuts,    ///< how either end of the incident edge lies to the side planes
  // figures
  tilt,              ///< tangent of the angle between reference face and incident edge
  lead_in_side,      ///< of the reference face over its side's second, a share of the size
  lead_of_side,      ///< of the reference's side over the other's, a share of the size
  slab_margin,       ///< from an end of the edge to the nearest side plane, a share of the face
  crossing_share,    ///< of the incident edge, from its nearer end, at which it is cut
  gap,               ///< |separation - total radius|, a share of the size
  depth,             ///< total radius - separation, a share of the size; none where they are apart
  size_ratio,        ///< A's size over B's
  radius_ratio,      ///< A's radius over B's
  radius_of_a,       ///< over its core's size
  radius_of_b,       ///< over its core's size
  reference_length,  ///< a share of the size
  incident_length,   ///< a share of the size
  length_ratio,      ///< |1 - incident / reference length|
  aspect_of_a,       ///< least width over greatest
  aspect_of_b,       ///< least width over greatest
  distance,          ///< of the origin from both, over the size
  scale,             ///< the size, in the world's unit
  turn_of_a,         ///< how far its rotation is from a multiple of 45 degrees
  turn_of_b,         ///< how far its rotation is from a multiple of 45 degrees
};
inline constexpr std::array<std::string_view, 28> kConditionNames{"count_a",
                                                                  "count_b",
                                                                  "corners",
                                                                  "reference_side",
                                                                  "reference_face",
                                                                  "incident_edge",
                                                                  "points",
                                                                  "cuts",
                                                                  "tilt",
                                                                  "lead_in_side",
                                                                  "lead_of_side",
                                                                  "slab_margin",
                                                                  "crossing",
                                                                  "gap",
                                                                  "depth",
                                                                  "size_ratio",
                                                                  "radius_ratio",
                                                                  "radius_of_a",
                                                                  "radius_of_b",
                                                                  "reference_length",
                                                                  "incident_length",
                                                                  "length_ratio",
                                                                  "aspect_of_a",
                                                                  "aspect_of_b",
                                                                  "distance",
                                                                  "scale",
                                                                  "turn_of_a",
                                                                  "turn_of_b"};
inline constexpr std::size_t kConditions = kConditionNames.size();

inline constexpr int kBins = 16;

/// The bin of each condition, in their order.
class Conditions {
 public:
  std::uint8_t operator[](Condition condition) const {
    return bins_[static_cast<std::size_t>(condition)];
  }
  std::uint8_t& operator[](Condition condition) {
    return bins_[static_cast<std::size_t>(condition)];
  }
  const std::array<std::uint8_t, kConditions>& all() const { return bins_; }

  friend bool operator==(const Conditions&, const Conditions&) = default;

 private:
  std::array<std::uint8_t, kConditions> bins_{};
};

/// The bin of a figure that is at least 0: 0 of nothing, 1 of what is below 10^least, and one more
/// for each power of ten from there on, up to the last bin.
std::uint8_t decade(double figure, int least);

/// The least extent across any face over the greatest, by doubles; of a polygon.
double aspect_of(const ConvexPolygon<float>& shape);
/// The diameter of the core: the shape's size without its radius.
double core_size(const ConvexPolygon<float>& shape);

Conditions conditions_of(const exact::Truth& truth);

}  // namespace manifuzz
