#include "oracle/godot3/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz::as_godot {
namespace {

/// _SEGMENT_IS_VALID_SUPPORT_THRESHOLD.
constexpr double kValidSupport = 0.99998;

/// relay.py: in double, of what is stored.
Vector2<double> placed_by_relay(const Body& body, int i) {
  return transform<double>({body.pose.position.cast<double>(), body.pose.rotation.cast<double>()},
                           body.polygon.vertices[i].cast<double>());
}

/// Geometry::is_polygon_clockwise; of a thin polygon roundings decide.
bool is_clockwise(const std::vector<Vector2<float>>& points) {
  float sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2<float>& from = points[i];
    const Vector2<float>& to = points[(i + 1) % points.size()];
    sum += (to.x() - from.x()) * (to.y() + from.y());
  }
  return sum > 0;
}

}  // namespace

Vector2<float> normalized(const Vector2<float>& v, const Mends& mends) {
  if (mends.has(FaultOfGodot::squared_length) && !v.isZero(0)) {
    return unit_direction(v.cast<double>()).cast<float>();
  }
  const float square = v.x() * v.x() + v.y() * v.y();
  if (square == 0) return v;
  const float length = std::sqrt(square);
  return {v.x() / length, v.y() / length};
}

Shape::Shape(const Body& body, const Mends& mends, int edge)
    : mends_(mends), edge_(edge), radius_(body.polygon.radius), origin_(body.pose.position) {
  x_axis_ = body.pose.rotation;
  const ConvexPolygon<float>& polygon = body.polygon;
  for (int i = 0; i < polygon.count; ++i) points_.push_back(polygon.vertices[i]);
  type_ = polygon.count > 2 ? Type::polygon : Type::segment;
  // ConvexPolygonShape2D::_update_shape.
  if (type_ == Type::polygon && is_clockwise(points_)) std::ranges::reverse(points_);
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

template <class Scalar>
Vector2<Scalar> Shape::placed(const Vector2<float>& v) const {
  const auto wide = [](const Vector2<float>& w) { return Vector2<Scalar>(w.cast<Scalar>()); };
  const Vector2<Scalar> x = wide(x_axis_), y = wide(y_axis_), o = wide(origin_), p = wide(v);
  return {x.x() * p.x() + y.x() * p.y() + o.x(), x.y() * p.x() + y.y() * p.y() + o.y()};
}

Vector2<float> Shape::turned_back(const Vector2<float>& v) const {
  return {x_axis_.dot(v), y_axis_.dot(v)};
}

Vector2<float> Shape::local_direction(const Vector2<float>& v) const {
  return normalized(turned_back(v), mends_);
}

std::vector<Vector2<float>> Shape::corners() const {
  std::vector<Vector2<float>> all;
  if (type_ == Type::circle) all.push_back(origin_);
  if (type_ == Type::capsule) {
    for (const float half : {0.5F, -0.5F}) all.push_back(origin_ + y_axis_ * height_ * half);
  }
  if (!all.empty()) return all;
  for (const Vector2<float>& point : points_) all.push_back(placed<float>(point));
  return all;
}

std::vector<Vector2<float>> Shape::normals() const {
  if (type_ == Type::circle) return {};
  if (type_ == Type::capsule) return {normalized(x_axis_, mends_)};
  const auto all = corners();
  std::vector<Vector2<float>> normals;
  for (std::size_t i = 0; i < (type_ == Type::segment ? 1 : all.size()); ++i) {
    const Vector2<float> along = all[(i + 1) % all.size()] - all[i];
    normals.push_back(clockwise_quarter(normalized(along, mends_)));
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
    Vector2<float> n = local_direction(axis);
    const float h = n.y() > 0 ? height_ : -height_;
    n *= radius_;
    n.y() += h * 0.5F;
    const float most = axis.dot(placed<float>(n));
    const float least = axis.dot(placed<float>(-n));
    return {std::min(least, most), std::max(least, most)};
  }
  std::array<float, 2> range{axis.dot(placed<float>(points_[0])),
                             axis.dot(placed<float>(points_[0]))};
  for (const Vector2<float>& point : points_) {
    const float d = axis.dot(placed<float>(point));
    range = {std::min(range[0], d), std::max(range[1], d)};
  }
  return range;
}

template <class Scalar>
Supports<Scalar> Shape::supports(const Vector2<float>& direction) const {
  const Supports<float> local = local_supports(local_direction(direction));
  return {{placed<Scalar>(local.points[0]), placed<Scalar>(local.points[1])}, local.count};
}

template Supports<float> Shape::supports(const Vector2<float>& direction) const;
template Supports<double> Shape::supports(const Vector2<float>& direction) const;

Supports<float> Shape::local_supports(const Vector2<float>& n) const {
  if (type_ == Type::circle) return {{n * radius_, {0, 0}}, 1};
  if (type_ == Type::capsule) return capsule_supports(n);
  if (type_ == Type::polygon) return polygon_supports(n);
  const Vector2<float> along = points_[1] - points_[0];
  Vector2<float> normal = clockwise_quarter(along);
  if (mends_.has(FaultOfGodot::segment_length)) normal = normalized(normal, mends_);
  if (static_cast<double>(std::abs(n.dot(normal))) > kValidSupport) {
    return {{points_[0], points_[1]}, 2};
  }
  return {{n.dot(along) > 0 ? points_[1] : points_[0], {0, 0}}, 1};
}

Supports<float> Shape::capsule_supports(Vector2<float> n) const {
  const float half = height_ * 0.5F;
  const bool is_upper = n.y() > 0;
  const bool is_side = static_cast<double>(std::abs(n.y())) < 1.0 - kValidSupport;
  if (is_side && !mends_.has(FaultOfGodot::flat_capsule)) {
    n.y() = 0;
    n = normalized(n, mends_);
  }
  n *= radius_;
  const Vector2<float> upper(n.x(), n.y() + half);
  const Vector2<float> lower(n.x(), n.y() - half);
  if (is_side) return {{upper, lower}, 2};
  return {{is_upper ? upper : lower, {0, 0}}, 1};
}

bool Shape::is_along(int i, const Vector2<float>& n) const {
  const Vector2<float> along = points_[(i + 1) % points_.size()] - points_[i];
  return static_cast<double>(normalized(clockwise_quarter(along), mends_).dot(n)) > kValidSupport;
}

std::vector<int> Shape::edges_met(const Vector2<float>& direction) const {
  if (type_ != Type::polygon) return {kItsOwnEdge};
  const Vector2<float> n = local_direction(direction);
  const auto count = static_cast<int>(points_.size());
  const auto farthest = static_cast<int>(
      std::ranges::max_element(points_, {}, [&](const auto& p) { return n.dot(p); }) -
      points_.begin());
  std::vector<int> edges;
  bool is_farthest_met = false;
  for (int i = 0; i < count; ++i) {
    if (!is_along(i, n)) continue;
    edges.push_back(i);
    is_farthest_met = is_farthest_met || i == farthest || (i + 1) % count == farthest;
  }
  if (!is_farthest_met) edges.push_back(kNoEdge);
  return edges;
}

Supports<float> Shape::polygon_supports(const Vector2<float>& n) const {
  const auto count = static_cast<int>(points_.size());
  int farthest = -1;
  int edge = std::max(edge_, kItsOwnEdge);
  float most =
      mends_.has(FaultOfGodot::start_values) ? -std::numeric_limits<float>::infinity() : -1e10F;
  for (int i = 0; i < count && edge < 0; ++i) {
    const float d = n.dot(points_[i]);
    if (d > most) {
      farthest = i;
      most = d;
    }
    if (edge_ != kNoEdge && is_along(i, n)) edge = i;
  }
  if (edge >= 0) return {{points_[edge], points_[(edge + 1) % count]}, 2};
  if (farthest < 0) return {};
  return {{points_[farthest], {0, 0}}, 1};
}

}  // namespace manifuzz::as_godot
