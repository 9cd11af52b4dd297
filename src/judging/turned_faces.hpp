#pragma once

#include <vector>

#include "exact/truth.hpp"
#include "judging/admissible.hpp"

namespace manifuzz {

/// How far a face's normal may be turned by the rounding of the vertices that it is taken from, a
/// length of the difference of unit vectors: their bounds over the face's length, 2 at most.
double face_turn(const Bounds& bounds, const exact::StoredPair& pair, exact::FaceOf face);

/// What is right for a collider that takes faces' normals from rounded world vertices: each face's
/// separation is off by its turn times the extent, besides what rounds any. As near as doubles say
/// it, which is far nearer than these bounds.
class TurnedFaces {
 public:
  /// The truth must outlive it.
  TurnedFaces(const exact::Truth& truth, const Bounds& bounds);

  /// The greatest separation of a side that the collider may see at most, and at least.
  double highest(Side side) const { return highest_[static_cast<std::size_t>(side)]; }
  double lowest(Side side) const { return lowest_[static_cast<std::size_t>(side)]; }
  double highest() const { return std::max(highest(Side::a), highest(Side::b)); }
  double lowest() const { return std::max(lowest(Side::a), lowest(Side::b)); }

  /// By how much the face's separation may be off because of its turn, a world length.
  double off(exact::FaceOf face) const;
  /// The faces that may be taken for their side's best.
  std::vector<exact::FaceOf> best_of(Side side) const;
  /// The edges that may be taken for the incident one of a face.
  std::vector<int> incident_edges(exact::FaceOf face) const;

 private:
  double turn(exact::FaceOf face) const { return face_turn(bounds_, truth_.stored(), face); }

  const exact::Truth& truth_;
  const Bounds& bounds_;
  double reach_;  ///< the extent and the total radius
  std::array<double, 2> highest_;
  std::array<double, 2> lowest_;
};

/// What is right where faces' normals are taken from rounded world vertices; `given` has the bounds
/// and the tie bias.
Admissible admissible_by_turned_faces(std::shared_ptr<const exact::Truth> truth, Admissible given);

}  // namespace manifuzz
