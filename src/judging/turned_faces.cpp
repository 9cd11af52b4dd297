#include "judging/turned_faces.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {

using exact::FaceOf;

double face_turn(const Bounds& bounds, const exact::StoredPair& pair, FaceOf face) {
  if (bounds.vertex == 0 && bounds.world_vertex == 0) return 0;
  const exact::StoredPolygon& polygon = pair[face.side].polygon;
  const Vector2<double>& from = polygon.vertices[face.index];
  const Vector2<double>& to = polygon.vertices[polygon.next(face.index)];
  const double moved = bounds.vertex * (from.norm() + to.norm()) + 2 * bounds.world_vertex;
  return std::min(moved / (to - from).norm(), 2.0);
}

TurnedFaces::TurnedFaces(const exact::Truth& truth, const Bounds& bounds)
    : truth_(truth), bounds_(bounds), reach_(truth.extent() + total_radius(truth.pair())) {
  highest_.fill(-INFINITY);
  lowest_.fill(-INFINITY);
  for (const FaceOf face : exact::all_faces(truth.stored())) {
    const auto side = static_cast<std::size_t>(face.side);
    const double separation = leading(truth.fine_separation(face));
    highest_[side] = std::max(highest_[side], separation + off(face));
    lowest_[side] = std::max(lowest_[side], separation - off(face));
  }
}

double TurnedFaces::off(FaceOf face) const {
  return turn(face) * reach_;
}

std::vector<FaceOf> TurnedFaces::best_of(Side side) const {
  std::vector<FaceOf> best;
  for (int i = 0; i < truth_.pair()[side].polygon.face_count(); ++i) {
    const FaceOf face{side, i};
    const double most = leading(truth_.fine_separation(face)) + off(face);
    if (most >= lowest(side) - bounds_.separation) best.push_back(face);
  }
  return best;
}

std::vector<int> TurnedFaces::incident_edges(FaceOf face) const {
  const exact::RoughPair placed = exact::place_roughly(truth_.stored());
  const Side opposing = other(face.side);
  const auto dot_of = [&](int edge) {
    return placed[face.side].normals[face.index].dot(placed[opposing].normals[edge]);
  };
  double least = INFINITY;
  for (int i = 0; i < placed[opposing].face_count(); ++i) {
    least = std::min(least, dot_of(i) + turn({opposing, i}));
  }
  std::vector<int> edges;
  for (int i = 0; i < placed[opposing].face_count(); ++i) {
    // The reference face's own turn moves two dots apart by at most twice as much.
    const double within = bounds_.incident_dot + turn({opposing, i}) + 2 * turn(face);
    if (dot_of(i) <= least + within) edges.push_back(i);
  }
  return edges;
}

namespace {

void add_clips_of_turned_faces(const TurnedFaces& faces, const TieBias& bias, Side side,
                               Admissible& result) {
  const Side favoured = bias.towards;
  const auto lead = [&](double of_other, double of_favoured) {
    return of_other - (1 - bias.relative) * of_favoured - bias.absolute;
  };
  const double bound = result.bounds.separation;
  const bool may_be = side == favoured
                          ? lead(faces.lowest(other(favoured)), faces.highest(favoured)) <= bound
                          : lead(faces.highest(other(favoured)), faces.lowest(favoured)) > -bound;
  const bool is_there = std::ranges::any_of(
      result.candidates, [&](const exact::Clip* clip) { return clip->reference.side == side; });
  if (!may_be || is_there) return;
  for (const FaceOf face : faces.best_of(side)) {
    for (const int edge : faces.incident_edges(face)) {
      result.candidates.push_back(&result.truth->clip(face, edge));
    }
  }
}

}  // namespace

Admissible admissible_by_turned_faces(std::shared_ptr<const exact::Truth> truth, Admissible given) {
  const TurnedFaces faces(*truth, given.bounds);
  const double bound = given.bounds.separation;
  const double radius = total_radius(truth->pair());
  given.must_touch = faces.highest() < -bound;
  given.may_touch = faces.lowest() <= radius + bound;
  given.may_be_apart = faces.highest() >= radius - bound;
  given.truth = std::move(truth);
  if (!given.may_touch) return given;
  for (const Side side : {Side::a, Side::b}) {
    add_clips_of_turned_faces(faces, given.tie_bias, side, given);
  }
  const bool may_be_empty_at_all = std::ranges::any_of(
      given.candidates,
      [&](const exact::Clip* clip) { return may_be_empty(with_face_of(given, *clip), *clip); });
  if (faces.lowest() >= bound || !may_be_empty_at_all) return given;
  for (const Side side : {Side::a, Side::b}) add_clips_of_turned_faces(faces, {}, side, given);
  return given;
}

}  // namespace manifuzz
