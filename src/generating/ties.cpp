#include "generating/ties.hpp"

#include <algorithm>

namespace manifuzz {

std::optional<Tie> find_tie(const PairCase& pair, double sense) {
  const Faces faces = faces_of(pair);
  Vector2<double> place = apart(pair);
  const double level = separation(faces, place);
  int face = 0;
  while (faces.separation(face, place) < level) ++face;
  for (int step = 0; step < faces.count; ++step) {
    const Vector2<double> along = sense * clockwise_quarter(faces.normals[face]);
    int next = face;
    double shortest = 1e9;
    for (int k = 0; k < faces.count; ++k) {
      const double speed = faces.normals[k].dot(along);
      if (k == face || speed < 1e-6) continue;
      const double length = (level - faces.separation(k, place)) / speed;
      if (length < shortest) {
        shortest = length;
        next = k;
      }
    }
    if (next == face) return std::nullopt;
    place += shortest * along;
    if (faces.side(next) != faces.side(face)) {
      return Tie{std::min(face, next), std::max(face, next), level};
    }
    face = next;
  }
  return std::nullopt;
}

Vector2<double> place_at(const Faces& faces, const Tie& tie, double lead) {
  const Vector2<double>& m = faces.normals[tie.face_a];
  const Vector2<double>& n = faces.normals[tie.face_b];
  const double x = faces.offsets[tie.face_a] + (tie.separation - lead);
  const double y = faces.offsets[tie.face_b] + tie.separation;
  return Vector2<double>(x * n.y() - y * m.y(), y * m.x() - x * n.x()) / cross(m, n);
}

}  // namespace manifuzz
