#include "oracle/truth/truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz::truth {
namespace {

template <class Number>
Vector2<Number> widen(const Vector2<float>& v) {
  return v.cast<Number>();
}

template <class Number>
WorldPolygon<Number> place(const Body& body, const Vector2<float>& origin) {
  const Vector2<Number> rotation = widen<Number>(body.pose.rotation);
  const Vector2<Number> position = widen<Number>(body.pose.position) - widen<Number>(origin);
  WorldPolygon<Number> placed;
  placed.count = body.polygon.count;
  for (int i = 0; i < placed.count; ++i) {
    placed.vertices[i] = rotate(rotation, widen<Number>(body.polygon.vertices[i])) + position;
  }
  for (int i = 0; i < placed.count; ++i) {
    const Vector2<Number> edge = widen<Number>(body.polygon.vertices[placed.next(i)]) -
                                 widen<Number>(body.polygon.vertices[i]);
    const Vector2<Number> outward = rotate(rotation, clockwise_quarter(edge));
    placed.normals[i] = outward / std::sqrt(outward.dot(outward));
  }
  return placed;
}

Vector into_frame_of_a(const PairCase& pair, const Vector& v) {
  const Vector rotation = widen<Real>(pair.a.pose.rotation);
  return rotate_back(rotation, v) / rotation.dot(rotation);
}

/// The incident edge along the reference face: where its ends lie between the side planes.
struct Span {
  std::array<Real, 2> along;  ///< distance of each end from the first side plane, inwards
  Real width = 0;             ///< distance between the planes

  Real margin(int end) const {
    return std::min(std::abs(along[end]), std::abs(along[end] - width));
  }
  bool misses() const {
    return std::max(along[0], along[1]) < 0 || std::min(along[0], along[1]) > width;
  }
  Real gap() const {
    return std::max(-std::max(along[0], along[1]), std::min(along[0], along[1]) - width);
  }
  /// Where along the edge, as a share, an end comes to lie after clipping; 0 or 1 when unclipped.
  Real clipped_share(int end) const {
    const Real offset = std::clamp(along[end], Real(0), width);
    if (offset == along[end]) return end;
    return (offset - along[0]) / (along[1] - along[0]);
  }
};

struct Reference {
  Vector corner;
  Vector normal;
  Vector direction;
  int first = 0;
  int second = 0;
  Side side = Side::a;
};

Feature vertex(int index) {
  return {Feature::Kind::vertex, static_cast<unsigned char>(index)};
}
Feature face(int index) {
  return {Feature::Kind::face, static_cast<unsigned char>(index)};
}

FeaturePair features_of(const Reference& reference, const Span& span, int end, bool crossing,
                        int incident, int incident_vertex) {
  FeaturePair pair;
  if (crossing) {
    const int corner = span.along[end] < 0 ? reference.first : reference.second;
    pair = {vertex(corner), face(incident)};
  } else {
    pair = {face(reference.first), vertex(incident_vertex)};
  }
  if (reference.side == Side::b) std::swap(pair.a, pair.b);
  return pair;
}

}  // namespace

template <class Number>
World<Number> place(const PairCase& pair) {
  const Vector2<float>& origin = pair.a.pose.position;
  return {place<Number>(pair.a, origin), place<Number>(pair.b, origin),
          static_cast<Number>(pair.a.polygon.radius) + static_cast<Number>(pair.b.polygon.radius)};
}

template <class Number>
std::array<Number, kMaxVertices> face_separations(const World<Number>& world, Side side) {
  const WorldPolygon<Number>& polygon = world[side];
  const WorldPolygon<Number>& opposing = world[other(side)];
  std::array<Number, kMaxVertices> separations{};
  for (int i = 0; i < polygon.count; ++i) {
    Number nearest = std::numeric_limits<Number>::infinity();
    for (int j = 0; j < opposing.count; ++j) {
      const Vector2<Number> apart = opposing.vertices[j] - polygon.vertices[i];
      nearest = std::min(nearest, polygon.normals[i].dot(apart));
    }
    separations[i] = nearest;
  }
  return separations;
}

template World<double> place(const PairCase&);
template World<Real> place(const PairCase&);
template std::array<double, kMaxVertices> face_separations(const World<double>&, Side);
template std::array<Real, kMaxVertices> face_separations(const World<Real>&, Side);

std::array<Real, kMaxVertices> normal_dots(const World<Real>& world, Side side, int face) {
  const WorldPolygon<Real>& opposing = world[other(side)];
  std::array<Real, kMaxVertices> dots{};
  for (int j = 0; j < opposing.count; ++j) {
    dots[j] = world[side].normals[face].dot(opposing.normals[j]);
  }
  return dots;
}

double separation(const PairCase& pair) {
  const World<double> world = place<double>(pair);
  double greatest = -std::numeric_limits<double>::infinity();
  for (const Side side : {Side::a, Side::b}) {
    const auto separations = face_separations(world, side);
    for (int i = 0; i < world[side].count; ++i) greatest = std::max(greatest, separations[i]);
  }
  return greatest;
}

Clip clip(const PairCase& pair, const World<Real>& world, Side reference_side, int reference_face,
          int incident) {
  const WorldPolygon<Real>& polygon = world[reference_side];
  const WorldPolygon<Real>& opposing = world[other(reference_side)];
  const Reference reference{polygon.vertices[reference_face],
                            polygon.normals[reference_face],
                            counter_clockwise_quarter(polygon.normals[reference_face]),
                            reference_face,
                            polygon.next(reference_face),
                            reference_side};
  const std::array<int, 2> ends{opposing.next(incident), incident};  // along the reference face
  const Vector edge = opposing.vertices[ends[1]] - opposing.vertices[ends[0]];

  Clip result;
  const Vector outward = reference_side == Side::a ? reference.normal : Vector(-reference.normal);
  result.normal = into_frame_of_a(pair, outward);
  result.normal /= std::sqrt(result.normal.dot(result.normal));
  result.edge_length = std::sqrt(edge.dot(edge));
  result.cosine = std::abs(reference.direction.dot(edge)) / result.edge_length;

  Span span;
  span.width = reference.direction.dot(polygon.vertices[reference.second] - reference.corner) +
               2 * world.total_radius;
  for (int end : {0, 1}) {
    span.along[end] = reference.direction.dot(opposing.vertices[ends[end]] - reference.corner) +
                      world.total_radius;
  }
  result.slab_width = span.width;
  result.gap = span.gap();
  const auto add = [&](int end, Real share) {
    const bool crossing = share != static_cast<Real>(end);
    const Vector at =
        crossing ? Vector(opposing.vertices[ends[0]] + share * edge) : opposing.vertices[ends[end]];
    result.points[result.count++] = {
        into_frame_of_a(pair, at), world.total_radius - reference.normal.dot(at - reference.corner),
        features_of(reference, span, end, crossing, incident, ends[end]), crossing,
        span.margin(end)};
  };
  if (span.misses()) {
    const int nearest = span.margin(0) <= span.margin(1) ? 0 : 1;
    add(nearest, nearest);
  } else {
    add(0, span.clipped_share(0));
    add(1, span.clipped_share(1));
  }
  return result;
}

}  // namespace manifuzz::truth
