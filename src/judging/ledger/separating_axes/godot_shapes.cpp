#include "judging/ledger/separating_axes/godot_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz::as_godot {
namespace {

/// _SEGMENT_IS_VALID_SUPPORT_THRESHOLD.
constexpr double kValidSupport = 0.99998;

/// relay.py: in double, of what is stored.
Vector2<double> placed_by_relay(const Body& body, int i) {
  const Vector2<double> r = body.pose.rotation.cast<double>();
  const Vector2<double> v = body.polygon.vertices[i].cast<double>();
  const Vector2<double> p = body.pose.position.cast<double>();
  return {r.x() * v.x() - r.y() * v.y() + p.x(), r.y() * v.x() + r.x() * v.y() + p.y()};
}

}  // namespace

Vector2<float> normalized(Vector2<float> v) {
  const float square = v.x() * v.x() + v.y() * v.y();
  if (square == 0) return v;
  const float length = std::sqrt(square);
  return {v.x() / length, v.y() / length};
}

Vector2<float> tangent_of(const Vector2<float>& v) {
  return {v.y(), -v.x()};
}

Shape::Shape(const Body& body) : radius_(body.polygon.radius), origin_(body.pose.position) {
  x_axis_ = body.pose.rotation;
  const ConvexPolygon<float>& polygon = body.polygon;
  for (int i = 0; i < polygon.count; ++i) points_.push_back(polygon.vertices[i]);
  type_ = polygon.count > 2 ? Type::polygon : Type::segment;
  if (polygon.count == 1) {
    type_ = Type::circle;
    origin_ = placed_by_relay(body, 0).cast<float>();
  } else if (polygon.count == 2 && polygon.radius > 0) {
    type_ = Type::capsule;
    const Vector2<double> from = placed_by_relay(body, 0);
    const Vector2<double> to = placed_by_relay(body, 1);
    const Vector2<double> up = to - from;
    const double height = std::hypot(up.x(), up.y());
    origin_ = Vector2<double>((from + to) / 2).cast<float>();
    x_axis_ = Vector2<double>(up.y() / height, -up.x() / height).cast<float>();
    height_ = static_cast<float>(height);
  }
  y_axis_ = {-x_axis_.y(), x_axis_.x()};
}

Vector2<float> Shape::placed(const Vector2<float>& v) const {
  return {x_axis_.x() * v.x() + y_axis_.x() * v.y() + origin_.x(),
          x_axis_.y() * v.x() + y_axis_.y() * v.y() + origin_.y()};
}

Vector2<float> Shape::turned_back(const Vector2<float>& v) const {
  return {x_axis_.dot(v), y_axis_.dot(v)};
}

std::vector<Vector2<float>> Shape::corners() const {
  std::vector<Vector2<float>> all;
  if (type_ == Type::circle) all.push_back(origin_);
  if (type_ == Type::capsule) {
    for (const float half : {0.5F, -0.5F}) all.push_back(origin_ + y_axis_ * height_ * half);
  }
  if (!all.empty()) return all;
  for (const Vector2<float>& point : points_) all.push_back(placed(point));
  return all;
}

std::vector<Vector2<float>> Shape::normals() const {
  if (type_ == Type::circle) return {};
  if (type_ == Type::capsule) return {normalized(x_axis_)};
  const auto all = corners();
  std::vector<Vector2<float>> normals;
  for (std::size_t i = 0; i < (type_ == Type::segment ? 1 : all.size()); ++i) {
    normals.push_back(tangent_of(normalized(all[(i + 1) % all.size()] - all[i])));
  }
  return normals;
}

std::array<float, 2> Shape::range(const Vector2<float>& axis) const {
  if (type_ == Type::circle) {
    const float d = axis.dot(origin_);
    const Vector2<float> local = turned_back(axis);
    const float scale = std::sqrt(local.x() * local.x() + local.y() * local.y());
    return {d - radius_ * scale, d + radius_ * scale};
  }
  if (type_ == Type::capsule) {
    Vector2<float> n = normalized(turned_back(axis));
    const float h = n.y() > 0 ? height_ : -height_;
    n *= radius_;
    n.y() += h * 0.5F;
    const float most = axis.dot(placed(n));
    const float least = axis.dot(placed(-n));
    return {std::min(least, most), std::max(least, most)};
  }
  std::array<float, 2> range{axis.dot(placed(points_[0])), axis.dot(placed(points_[0]))};
  for (const Vector2<float>& point : points_) {
    const float d = axis.dot(placed(point));
    range = {std::min(range[0], d), std::max(range[1], d)};
  }
  return range;
}

Supports Shape::supports(const Vector2<float>& direction, const Mends& mends) const {
  Supports found = local_supports(normalized(turned_back(direction)), mends);
  for (Vector2<float>& point : found.points) point = placed(point);
  return found;
}

Supports Shape::local_supports(const Vector2<float>& n, const Mends& mends) const {
  if (type_ == Type::circle) return {{n * radius_, {0, 0}}, 1};
  if (type_ == Type::capsule) return capsule_supports(n);
  if (type_ == Type::polygon) return polygon_supports(n, mends);
  const Vector2<float> along = points_[1] - points_[0];
  Vector2<float> normal = tangent_of(along);
  if (mends.is_segment_unit) normal = normalized(normal);
  if (static_cast<double>(std::abs(n.dot(normal))) > kValidSupport) {
    return {{points_[0], points_[1]}, 2};
  }
  return {{n.dot(along) > 0 ? points_[1] : points_[0], {0, 0}}, 1};
}

Supports Shape::capsule_supports(Vector2<float> n) const {
  const float d = n.y();
  if (static_cast<double>(std::abs(d)) < 1.0 - kValidSupport) {
    n.y() = 0;
    n = normalized(n) * radius_;
    return {{Vector2<float>(n.x(), n.y() + height_ * 0.5F),
             Vector2<float>(n.x(), n.y() - height_ * 0.5F)},
            2};
  }
  const float h = d > 0 ? height_ : -height_;
  n *= radius_;
  return {{Vector2<float>(n.x(), n.y() + h * 0.5F), {0, 0}}, 1};
}

Supports Shape::polygon_supports(const Vector2<float>& n, const Mends& mends) const {
  const auto count = static_cast<int>(points_.size());
  const auto product = [&](int i) {
    const Vector2<float> along = points_[(i + 1) % count] - points_[i];
    return static_cast<double>(normalized(tangent_of(along)).dot(n));
  };
  int farthest = -1;
  int edge = -1;
  float most = -1e10F;
  for (int i = 0; i < count && edge < 0; ++i) {
    const float d = n.dot(points_[i]);
    if (d > most) {
      farthest = i;
      most = d;
    }
    if (!mends.is_edge_farthest && product(i) > kValidSupport) edge = i;
  }
  if (farthest < 0) return {};
  if (mends.is_edge_farthest) {
    const int before = (farthest + count - 1) % count;
    edge = product(before) > product(farthest) ? before : farthest;
    if (!(product(edge) > kValidSupport)) edge = -1;
  }
  if (edge >= 0) return {{points_[edge], points_[(edge + 1) % count]}, 2};
  return {{points_[farthest], {0, 0}}, 1};
}

}  // namespace manifuzz::as_godot
