#pragma once

#include "oracle/parry/ledger/replay.hpp"

// clip_segment_segment.rs, and what a manifold makes of its points.

namespace manifuzz::parry {

template <class Real>
using Ends = std::array<Vector2<Real>, 2>;

template <class Real>
struct ClippedPoint {
  Vector2<Real> on_a;
  Vector2<Real> on_b;
};

template <class Real>
TrackedPoint<Real> tracked(const Replay<Real>& replay, const ClippedPoint<Real>& point) {
  const Vector2<Real> apart = point.on_b - point.on_a;
  return {point.on_a, inverse_transform(replay.between, point.on_b), apart.dot(replay.normal)};
}

/// The point at a place along a tangent, on a segment from one such place to another.
template <class Real>
Vector2<Real> point_at(const Ends<Real>& ends, const std::array<Real, 2>& range, Real place) {
  const Real run = range[1] - range[0];
  const Real share = (place - range[0]) * (run == 0 ? Real(0) : Real(1) / run);
  return ends[0] + (ends[1] - ends[0]) * share;
}

/// clip_segment_segment_with_normal: none, or two.
template <class Real>
std::vector<ClippedPoint<Real>> clipped(Ends<Real> a, Ends<Real> b, const Vector2<Real>& normal) {
  const Vector2<Real> tangent(-normal.y(), normal.x());
  std::array<Real, 2> along_a{a[0].dot(tangent), a[1].dot(tangent)};
  std::array<Real, 2> along_b{b[0].dot(tangent), b[1].dot(tangent)};
  if (along_a[1] < along_a[0]) {
    std::swap(along_a[0], along_a[1]);
    std::swap(a[0], a[1]);
  }
  if (along_b[1] < along_b[0]) {
    std::swap(along_b[0], along_b[1]);
    std::swap(b[0], b[1]);
  }
  if (along_b[0] > along_a[1] || along_a[0] > along_b[1]) return {};
  std::vector<ClippedPoint<Real>> found;
  found.push_back(along_b[0] > along_a[0]
                      ? ClippedPoint<Real>{point_at(a, along_a, along_b[0]), b[0]}
                      : ClippedPoint<Real>{a[0], point_at(b, along_b, along_a[0])});
  found.push_back(along_b[1] < along_a[1]
                      ? ClippedPoint<Real>{point_at(a, along_a, along_b[1]), b[1]}
                      : ClippedPoint<Real>{a[1], point_at(b, along_b, along_a[1])});
  return found;
}

template <class Real>
void add_radii(const Replay<Real>& replay, std::vector<TrackedPoint<Real>>& points) {
  const Real of_a = replay.a.shape.radius;
  const Real of_b = replay.b.shape.radius;
  if (of_a == 0 && of_b == 0) return;
  const Vector2<Real> out_of_b = normal_of_b(replay);
  for (TrackedPoint<Real>& point : points) {
    point.on_a += replay.normal * of_a;
    point.on_b += out_of_b * of_b;
    point.distance -= of_a + of_b;
  }
}

template <class Real>
Ends<Real> face_of(const Shape<Real>& shape, std::size_t face) {
  if (!shape.is_polygon()) return {shape.corners[0], shape.corners[1]};
  return {shape.corners[face], shape.corners[(face + 1) % shape.corners.size()]};
}

template <class Real>
Ends<Real> face_of_b(const Replay<Real>& replay, std::size_t face) {
  Ends<Real> ends = face_of(replay.b.shape, face);
  for (Vector2<Real>& end : ends) end = transform(replay.between, end);
  return ends;
}

}  // namespace manifuzz::parry
