#include "oracle/bullet/ledger/perturbed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// btConvexConvexAlgorithm.cpp.

namespace manifuzz::ledger_of {
namespace {

constexpr int kTurns = 3;

/// btQuaternion.
struct Quaternion {
  Space v{0, 0, 0};
  float w = 1;

  static Quaternion about(const Space& axis, float angle) {
    const float s = std::sin(angle * 0.5F) / std::sqrt(squared(axis));
    return {axis * s, std::cos(angle * 0.5F)};
  }
  Quaternion inverse() const { return {-v, w}; }
  Basis basis() const;
};

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  const auto along = [&](int i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    return a.w * b.v[i] + a.v[i] * b.w + a.v[j] * b.v[k] - a.v[k] * b.v[j];
  };
  return {Space(along(0), along(1), along(2)),
          a.w * b.w - a.v.x() * b.v.x() - a.v.y() * b.v.y() - a.v.z() * b.v.z()};
}

Basis Quaternion::basis() const {
  const float s = 2.0F / (v.x() * v.x() + v.y() * v.y() + v.z() * v.z() + w * w);
  const Space by = v * s;
  const Space of_w = w * by;
  const float xx = v.x() * by.x();
  const float xy = v.x() * by.y();
  const float xz = v.x() * by.z();
  const float yy = v.y() * by.y();
  const float yz = v.y() * by.z();
  const float zz = v.z() * by.z();
  return {Space(1 - (yy + zz), xy - of_w.z(), xz + of_w.y()),
          Space(xy + of_w.z(), 1 - (xx + zz), yz - of_w.x()),
          Space(xz - of_w.y(), yz + of_w.x(), 1 - (xx + yy))};
}

/// The first direction of btPlaneSpace1.
Space across(const Space& n) {
  constexpr float sqrt12 = 0.7071067811865475244008443621048490F;
  if (std::abs(n.z()) > sqrt12) {
    const float k = 1.0F / std::sqrt(n.y() * n.y() + n.z() * n.z());
    return {0, -n.z() * k, n.y() * k};
  }
  const float k = 1.0F / std::sqrt(n.x() * n.x() + n.y() * n.y());
  return {-n.y() * k, n.x() * k, 0};
}

BulletPlace inverse_of(const BulletPlace& place) {
  BulletPlace inverse{transposed(place.basis)};
  inverse.origin = inverse.to_world(Space(-place.origin));
  return inverse;
}

BulletPlace operator*(const BulletPlace& a, const BulletPlace& b) {
  return {times(a.basis, b.basis), a.to_world(b.origin)};
}

/// Which shape is turned, by how much, and about what.
struct Turning {
  bool is_of_a = false;
  float angle = 0;
  Space along{0, 0, 0};  ///< the separating axis over its square
  Space across{0, 0, 0};
};

Turning turning_of(const Space& axis, float disc_a, float disc_b) {
  constexpr float angle_max = 0.125F * 3.1415926535897932384626433832795029F;
  Turning turning;
  turning.is_of_a = disc_a < disc_b;
  turning.angle = std::min(kRelativeBreaking / (turning.is_of_a ? disc_a : disc_b), angle_max);
  turning.along = axis * (1.0F / squared(axis));
  turning.across = across(turning.along);
  return turning;
}

/// One query of the turned shapes, its point taken back: btPerturbedContactResult.
void add_turned(const BulletPair& pair, const Turning& turning, int turn, float square_max,
                BulletManifold& manifold) {
  constexpr float round = 2.0F * 3.1415926535897932384626433832795029F;
  const float angle = static_cast<float>(turn) * (round / static_cast<float>(kTurns));
  const Quaternion about = Quaternion::about(turning.along, angle);
  const Quaternion by = Quaternion::about(turning.across, turning.angle);
  BulletPair turned = pair;
  BulletPlace& moved = turning.is_of_a ? turned.place_a : turned.place_b;
  const BulletPlace& unmoved = turning.is_of_a ? pair.place_a : pair.place_b;
  moved.basis = times((about.inverse() * by * about).basis(), unmoved.basis);
  EpaTrace unused;
  const BulletAnswer answer = ask_detector(turned, solve_by_epa, &unused, square_max);
  if (answer.normal_of == NormalOf::nobody) return;
  const BulletPlace back = unmoved * inverse_of(moved);
  Space on_a = answer.on_b + answer.normal * answer.distance;
  Space on_b = answer.on_b;
  float distance = 0;
  if (turning.is_of_a) {
    on_a = back.to_world(on_a);
    distance = dot(Space(on_a - on_b), answer.normal);
    on_b = on_a - answer.normal * distance;
  } else {
    on_b = back.to_world(on_b);
    distance = dot(Space(on_a - on_b), answer.normal);
  }
  manifold.add(answer.normal, on_b, distance, turn + 1);
}

}  // namespace

PerturbedAnswer ask_perturbed(const BulletPair& pair, const PerturbedParts& parts) {
  constexpr float epsilon = std::numeric_limits<float>::epsilon();
  const float disc_a = disc_of(pair.a);
  const float disc_b = disc_of(pair.b);
  const float breaking = breaking_threshold(pair);
  const float farthest = pair.a.margin + pair.b.margin + breaking;
  PerturbedAnswer answer;
  answer.first = ask_detector(pair, solve_by_epa, &answer.epa, farthest * farthest);
  BulletManifold manifold(pair, breaking, parts.does_replace);
  const BulletAnswer& first = answer.first;
  if (first.normal_of != NormalOf::nobody) {
    manifold.add(first.normal, first.on_b, first.distance, 0);
  }
  if (parts.has_turned && squared(first.cached_axis) > epsilon) {
    const Turning turning = turning_of(first.cached_axis, disc_a, disc_b);
    for (int i = 0; i < kTurns && squared(turning.across) > epsilon; ++i) {
      add_turned(pair, turning, i, farthest * farthest, manifold);
    }
  }
  if (parts.is_refreshed) manifold.refresh();
  answer.points = manifold.points;
  return answer;
}

replayed::Contact seen_in_plane(const std::vector<BulletPoint>& points) {
  replayed::Contact contact;
  const BulletPoint* const deepest = deepest_of(points);
  if (deepest == nullptr) return contact;
  const auto apart = [&](const BulletPoint& point) {
    return std::hypot(point.on_b.x() - deepest->on_b.x(), point.on_b.y() - deepest->on_b.y());
  };
  const BulletPoint* farthest = deepest;
  for (const BulletPoint& point : points) {
    if (point.distance <= 0 && apart(point) > apart(*farthest)) farthest = &point;
  }
  const float length = std::hypot(deepest->normal.x(), deepest->normal.y());
  contact.normal =
      -Vector2<float>(deepest->normal.x() / length, deepest->normal.y() / length).cast<double>();
  for (const BulletPoint* const point : {deepest, farthest}) {
    if (!contact.points.empty() && farthest == deepest) break;
    contact.points.push_back({Vector2<float>(point->on_b.x(), point->on_b.y()).cast<double>(),
                              static_cast<double>(std::max(-point->distance * length, 0.0F))});
  }
  return contact;
}

}  // namespace manifuzz::ledger_of
