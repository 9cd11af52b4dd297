#pragma once

#include <array>
#include <cmath>

#include "geometry/pair_case.hpp"

namespace manifuzz::jbox2d {

/// A PolygonShape and its Transform, as the adapter fills them.
struct Polygon {
  const Body& body;

  int count() const { return body.polygon.count; }
  int next(int i) const { return i + 1 < count() ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : count() - 1; }
  const Vector2<float>& vertex(int i) const { return body.polygon.vertices[i]; }
  Vector2<float> turned(const Vector2<float>& v) const { return rotate(body.pose.rotation, v); }
  Vector2<float> turned_back(const Vector2<float>& v) const {
    return rotate_back(body.pose.rotation, v);
  }
  Vector2<float> placed(const Vector2<float>& v) const { return transform(body.pose, v); }
  /// Protocol.java, normal.
  Vector2<float> normal(int i) const {
    const Vector2<double> edge = vertex(next(i)).cast<double>() - vertex(i).cast<double>();
    const double length = std::sqrt(edge.x() * edge.x() + edge.y() * edge.y());
    return {static_cast<float>(edge.y() / length), static_cast<float>(-edge.x() / length)};
  }
  /// PolygonShape.computeCentroidToOut.
  Vector2<float> centroid() const {
    constexpr float kThird = 1.0F / 3.0F;
    Vector2<float> sum(0, 0);
    float area = 0;
    for (int i = 0; i < count(); ++i) {
      const Vector2<float>& p = vertex(i);
      const Vector2<float>& q = vertex(next(i));
      const float triangle = 0.5F * (p.x() * q.y() - p.y() * q.x());
      area += triangle;
      sum += (Vector2<float>(0, 0) + p + q) * (triangle * kThird);
    }
    return sum * (1.0F / area);
  }
};

using Ends = std::array<Vector2<float>, 2>;

/// clipSegmentToLine: whether both ends are left.
inline bool clip_to_line(Ends& ends, const Vector2<float>& normal, float offset) {
  const float first = normal.dot(ends[0]) - offset;
  const float second = normal.dot(ends[1]) - offset;
  if (first > 0 && second > 0) return false;
  if (first * second < 0) {
    const Vector2<float> crossing = (ends[1] - ends[0]) * (first / (first - second)) + ends[0];
    ends = first <= 0 ? Ends{ends[0], crossing} : Ends{ends[1], crossing};
    return true;
  }
  return first <= 0 && second <= 0;
}

}  // namespace manifuzz::jbox2d
