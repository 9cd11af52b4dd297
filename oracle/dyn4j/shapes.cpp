#include "oracle/dyn4j/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz::as_dyn4j {
namespace {

using replayed::has;

constexpr double kEdgeFeatureSelection = 0.98;  // Capsule.EDGE_FEATURE_SELECTION_CRITERIA
constexpr double kEdgeFeatureExpansion = 0.1;   // Capsule.EDGE_FEATURE_EXPANSION_FACTOR

Vector2<double> unit_of(Vector2<double> v) {
  normalize(v);
  return v;
}

}  // namespace

double normalize(Vector2<double>& v) {
  const double magnitude = v.norm();
  if (magnitude <= kEpsilon) return 0;
  const double inverse = 1.0 / magnitude;
  v.x() *= inverse;
  v.y() *= inverse;
  return magnitude;
}

Placed::Placed(const Body& body) {
  const Vector2<double> turn = body.pose.rotation.cast<double>();
  const double unit = turn.norm();
  placing_ = {body.pose.position.cast<double>(), turn / unit};
  const ConvexPolygon<float>& polygon = body.polygon;
  radius_ = static_cast<double>(polygon.radius);
  for (int i = 0; i < polygon.count; ++i) {
    vertices_.emplace_back(unit * polygon.vertices[i].cast<double>());
  }
  if (polygon.count > 2) {
    kind_ = Kind::polygon;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Vector2<double>& next = vertices_[(i + 1) % vertices_.size()];
      normals_.push_back(unit_of(clockwise_quarter<double>(next - vertices_[i])));
    }
  } else if (polygon.count == 2 && radius_ == 0) {
    kind_ = Kind::segment;
    const Vector2<double> along = vertices_[1] - vertices_[0];
    normals_ = {unit_of(counter_clockwise_quarter(along)), unit_of(along)};
  } else if (polygon.count == 2) {
    kind_ = Kind::capsule;
    make_capsule(Vector2<double>(vertices_[0]), Vector2<double>(vertices_[1]));
  } else {
    kind_ = Kind::circle;
  }
  if (kind_ != Kind::capsule) find_centre();
}

void Placed::make_capsule(const Vector2<double>& start, const Vector2<double>& end) {
  length_ = (start - end).norm() + 2 * radius_;
  const double half = (length_ - 2 * radius_) * 0.5;
  const Vector2<double> along = end - start;
  const double magnitude = along.norm();
  if (magnitude > kEpsilon) axis_ = {along.x() / magnitude, along.y() / magnitude};
  centre_ = {(start.x() + end.x()) * 0.5, (start.y() + end.y()) * 0.5};
  const auto focus = [&](double x) {
    return Vector2<double>(x * axis_.x() + centre_.x(), x * axis_.y() + centre_.y());
  };
  vertices_ = {focus(-half), focus(half)};
}

void Placed::find_centre() {
  const auto count = static_cast<double>(vertices_.size());
  Vector2<double> average(0, 0);
  for (const Vector2<double>& vertex : vertices_) average += vertex;
  average /= count;
  centre_ = average;
  if (kind_ != Kind::polygon) return;
  // Geometry.getAreaWeightedCenter.
  Vector2<double> sum(0, 0);
  double area = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vector2<double> first = vertices_[i] - average;
    const Vector2<double> second = vertices_[(i + 1) % vertices_.size()] - average;
    const double triangle = 0.5 * (first.x() * second.y() - first.y() * second.x());
    area += triangle;
    const double third = 1.0 / 3.0;
    sum.x() += (first.x() + second.x()) * third * triangle;
    sum.y() += (first.y() + second.y()) * third * triangle;
  }
  centre_ = vertices_[0];
  if (std::abs(area) > kEpsilon) {
    centre_ = {sum.x() / area + average.x(), sum.y() / area + average.y()};
  }
}

std::vector<Vector2<double>> Placed::foci() const {
  if (kind_ == Kind::circle) return {centre()};
  if (kind_ == Kind::capsule)
    return {transform(placing_, vertices_[0]), transform(placing_, vertices_[1])};
  return {};
}

std::vector<Vector2<double>> Placed::axes(const std::vector<Vector2<double>>& foci) const {
  std::vector<Vector2<double>> all;
  if (kind_ == Kind::circle) return all;
  if (kind_ == Kind::capsule) {
    all = {rotate(placing_.rotation, axis_),
           rotate(placing_.rotation, counter_clockwise_quarter(axis_))};
  }
  for (const Vector2<double>& normal : normals_) all.push_back(rotate(placing_.rotation, normal));
  for (const Vector2<double>& focus : foci) {
    Vector2<double> nearest = transform(placing_, vertices_[0]);
    for (std::size_t i = 1; i < vertices_.size(); ++i) {
      const Vector2<double> vertex = transform(placing_, vertices_[i]);
      const double distance = (vertex - focus).squaredNorm();
      const bool is_nearer = kind_ == Kind::polygon ? distance < (nearest - focus).squaredNorm()
                                                    : !((nearest - focus).squaredNorm() < distance);
      if (is_nearer) nearest = vertex;
    }
    all.push_back(unit_of(kind_ == Kind::polygon ? nearest - focus : focus - nearest));
  }
  return all;
}

Range Placed::project(Vector2<double>& axis) const {
  if (kind_ == Kind::circle) {
    const double c = centre().dot(axis);
    return {c - radius_, c + radius_};
  }
  if (kind_ == Kind::capsule) {
    const Vector2<double> farthest = farthest_point(axis);
    const double most = farthest.dot(axis);
    return {2 * centre().dot(axis) - most, most};
  }
  Range range{axis.dot(transform(placing_, vertices_[0])), 0};
  range.max = range.min;
  for (const Vector2<double>& vertex : vertices_) {
    const double along = axis.dot(transform(placing_, vertex));
    range.min = std::min(range.min, along);
    range.max = std::max(range.max, along);
  }
  return range;
}

/// Polygon.getFarthestVertexIndex: it climbs.
std::size_t Placed::farthest_vertex(const Vector2<double>& along) const {
  const std::size_t count = vertices_.size();
  const auto height = [&](std::size_t i) { return along.dot(vertices_[i]); };
  std::size_t at = 0;
  double most = height(0);
  if (most < height(1)) {
    do {
      most = height(++at);
    } while (at + 1 < count && most < height(at + 1));
  } else if (most < height(count - 1)) {
    at = count;
    do {
      most = height(--at);
    } while (at > 0 && most <= height(at - 1));
  }
  return at;
}

/// Segment.getFarthestPoint.
Vector2<double> Placed::farthest_of_ends(const Vector2<double>& along) const {
  const Vector2<double> first = transform(placing_, vertices_[0]);
  const Vector2<double> second = transform(placing_, vertices_[1]);
  return along.dot(first) >= along.dot(second) ? first : second;
}

Vector2<double> Placed::farthest_point(Vector2<double>& along) const {
  switch (kind_) {
    case Kind::circle: {
      const double magnitude = along.norm();
      const double inverse = magnitude <= kEpsilon ? 0 : 1.0 / magnitude;
      const Vector2<double> at = centre();
      return {at.x() + radius_ * (along.x() * inverse), at.y() + radius_ * (along.y() * inverse)};
    }
    case Kind::capsule: {
      normalize(along);
      const Vector2<double> end = farthest_of_ends(along);
      return {end.x() + along.x() * radius_, end.y() + along.y() * radius_};
    }
    case Kind::segment:
      return farthest_of_ends(along);
    default:
      return transform(placing_, vertices_[farthest_vertex(rotate_back(placing_.rotation, along))]);
  }
}

/// Segment.getFarthestFeature.
FarthestFeature Placed::edge_of(const Vector2<double>& first, const Vector2<double>& second,
                                const Vector2<double>& along) const {
  const Vector2<double> p = transform(placing_, first);
  const Vector2<double> q = transform(placing_, second);
  FarthestFeature edge{true,
                       p,
                       q,
                       along.dot(p) >= along.dot(q) ? p : q,
                       rotate<double>(placing_.rotation, second - first),
                       q - p};
  if (counter_clockwise_quarter<double>(q - p).dot(along) > 0) {
    std::swap(edge.from, edge.to);
    edge.along = -edge.along;
    edge.edge = p - q;
  }
  return edge;
}

FarthestFeature Placed::capsule_feature(Vector2<double>& along, unsigned mended) const {
  const Vector2<double> local = rotate_back(placing_.rotation, along);
  const Vector2<double> side = clockwise_quarter(axis_);
  const double across = local.dot(side);
  if (std::abs(across) < local.dot(local) * kEdgeFeatureSelection) {
    FarthestFeature point;
    point.from = farthest_point(along);
    return point;
  }
  const double sign = across > 0 ? 1 : -1;
  const Vector2<double> out = has(mended, FaultOfDyn4j::normal_of_edge)
                                  ? Vector2<double>(radius_ * local)
                                  : Vector2<double>(sign * (side * radius_));
  const double longer =
      has(mended, FaultOfDyn4j::longer_capsule) ? 0 : length_ * 0.5 * kEdgeFeatureExpansion;
  const Vector2<double> more = axis_ * longer;
  return edge_of(vertices_[0] + out - more, vertices_[1] + out + more, along);
}

/// Whether of both edges at a polygon's vertex the next one faces along a direction.
bool Placed::is_next_edge(std::size_t at, const Vector2<double>& along, bool by_sine) const {
  const std::size_t count = vertices_.size();
  const std::size_t before = (at + count - 1) % count;
  if (!by_sine) return normals_[before].dot(along) < normals_[at].dot(along);
  const auto sine = [&](std::size_t i) {
    const Vector2<double> edge = vertices_[(i + 1) % count] - vertices_[i];
    return std::abs(edge.dot(along)) / edge.norm();
  };
  return sine(at) < sine(before);
}

FarthestFeature Placed::farthest_feature(Vector2<double>& along, unsigned mended) const {
  if (kind_ == Kind::circle) {
    FarthestFeature point;
    point.from = farthest_point(along);
    return point;
  }
  if (kind_ == Kind::capsule) return capsule_feature(along, mended);
  if (kind_ == Kind::segment) return edge_of(vertices_[0], vertices_[1], along);
  const Vector2<double> local = rotate_back(placing_.rotation, along);
  const std::size_t count = vertices_.size();
  const std::size_t at = farthest_vertex(local);
  const std::size_t before = (at + count - 1) % count;
  const Vector2<double> max = transform(placing_, vertices_[at]);
  const bool is_next = is_next_edge(at, local, has(mended, FaultOfDyn4j::neighbour_by_dot));
  const std::size_t first = is_next ? at : before;
  const std::size_t second = is_next ? (at + 1) % count : at;
  const Vector2<double> p = transform(placing_, vertices_[first]);
  const Vector2<double> q = transform(placing_, vertices_[second]);
  return {true, p, q, max, rotate<double>(placing_.rotation, vertices_[second] - vertices_[first]),
          q - p};
}

}  // namespace manifuzz::as_dyn4j
