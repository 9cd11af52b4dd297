#include "oracle/jbox2d/edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "judging/faults/replayed.hpp"
#include "oracle/jbox2d/shapes.hpp"

// EPCollider.collide, of an edge that has no neighbours, is repeated in float, and
// again with faults mended.

namespace manifuzz {
namespace {

using Float2 = Vector2<float>;

/// The polygon in the edge's frame, and what EPCollider finds.
class EdgeAndPolygonOfJbox2d {
 public:
  EdgeAndPolygonOfJbox2d(const Body& edge, const Body& polygon, unsigned mended)
      : edge_{edge}, polygon_{polygon}, mended_(mended) {
    between_.pose = relative_pose(edge.pose, polygon.pose);
    const jbox2d::Polygon placing{between_};
    for (int i = 0; i < polygon_.count(); ++i) {
      vertices_[i] = placing.placed(polygon_.vertex(i));
      normals_[i] = placing.turned(polygon_.normal(i));
    }
    const Float2 along = edge_.vertex(1) - edge_.vertex(0);
    const float length = std::sqrt(along.x() * along.x() + along.y() * along.y());
    const Float2 unit =
        length < std::numeric_limits<float>::epsilon() ? along : Float2(along * (1.0F / length));
    const Float2 normal(unit.y(), -unit.x());
    is_front_ = normal.dot(placing.placed(polygon_.centroid()) - edge_.vertex(0)) >= 0;
    if (is_mended(FaultOfJbox2dEdge::front)) {
      is_front_ = edge_separation(normal) >= edge_separation(-normal);
    }
    normal_ = is_front_ ? normal : Float2(-normal);
    radius_ = is_mended(FaultOfJbox2dEdge::radius) ? edge.polygon.radius + polygon.polygon.radius
                                                   : 2.0F * 0.01F;
  }

  /// With the normal from the edge to the polygon.
  replayed::Contact contact() const {
    const float of_edge = edge_separation(normal_);
    int face = 0;
    float of_polygon = polygon_separation(0);
    for (int i = 0; i < polygon_.count(); ++i) {
      const float separation = polygon_separation(i);
      if (separation > radius_) return {};
      if (separation > of_polygon) {
        of_polygon = separation;
        face = i;
      }
    }
    if (of_edge > radius_) return {};
    if (is_mended(FaultOfJbox2dEdge::corners) && std::max(of_edge, of_polygon) > 0) {
      return between_corners();
    }
    const bool is_mended_bias = is_mended(FaultOfJbox2dEdge::hysteresis);
    const bool is_b = of_polygon > (is_mended_bias ? of_edge : 0.98F * of_edge + 0.001F);
    return is_b ? clipped(vertices_[face], vertices_[polygon_.next(face)], normals_[face],
                          {edge_.vertex(0), edge_.vertex(1)}, true)
                : clipped(edge_.vertex(is_front_ ? 0 : 1), edge_.vertex(is_front_ ? 1 : 0), normal_,
                          incident(), false);
  }

 private:
  bool is_mended(FaultOfJbox2dEdge fault) const { return replayed::has(mended_, fault); }
  /// computeEdgeSeparation.
  float edge_separation(const Float2& normal) const {
    float least = std::numeric_limits<float>::max();
    for (int i = 0; i < polygon_.count(); ++i) {
      least = std::min(least, normal.dot(vertices_[i] - edge_.vertex(0)));
    }
    return least;
  }
  /// computePolygonSeparation, of a face.
  float polygon_separation(int i) const {
    const Float2 inward = -normals_[i];
    return std::min(inward.dot(vertices_[i] - edge_.vertex(0)),
                    inward.dot(vertices_[i] - edge_.vertex(1)));
  }
  jbox2d::Ends incident() const {
    int most_against = 0;
    for (int i = 1; i < polygon_.count(); ++i) {
      if (normal_.dot(normals_[i]) < normal_.dot(normals_[most_against])) most_against = i;
    }
    return {vertices_[most_against], vertices_[polygon_.next(most_against)]};
  }
  /// Along the line between the corners that are nearest to each other, of cores that are apart:
  /// what a clip along it keeps of the edge and of the face beside the corner that is flattest.
  replayed::Contact between_corners() const {
    int corner = 0;
    int end = 0;
    for (int i = 0; i < 2 * polygon_.count(); ++i) {
      if (between(i / 2, i % 2).norm() >= between(corner, end).norm()) continue;
      corner = i / 2;
      end = i % 2;
    }
    const Float2 nearest = between(corner, end);
    const auto distance = static_cast<double>(nearest.norm());
    if (distance == 0) return {};
    const auto radius = static_cast<double>(polygon_.body.polygon.radius);
    const double radii = static_cast<double>(edge_.body.polygon.radius) + radius;
    if (distance > radii) return {};
    const Vector2<double> out = edge_.turned(nearest).cast<double>() / distance;
    replayed::Contact contact{out, {}};
    const auto add = [&](const Float2& on_polygon, double separation) {
      contact.points.push_back(
          {edge_.placed(on_polygon).cast<double>() - radius * out, radii - separation});
    };
    add(vertices_[corner], distance);
    const int before = polygon_.previous(corner);
    const bool is_before = normals_[before].dot(nearest) < normals_[corner].dot(nearest);
    const int far = is_before ? before : polygon_.next(corner);
    const Float2 along_face = vertices_[far] - vertices_[corner];
    const Float2 along_edge = edge_.vertex(1 - end) - edge_.vertex(end);
    const Float2 tangent(nearest.y(), -nearest.x());
    const float of_face = along_face.dot(tangent);
    const float of_edge = along_edge.dot(tangent);
    if (!(of_face * of_edge > 0)) return contact;
    const float run = std::abs(of_face) < std::abs(of_edge) ? of_face : of_edge;
    const Float2 further = along_face * (run / of_face);
    const Float2 apart = nearest + further - along_edge * (run / of_edge);
    const double separation = static_cast<double>(apart.dot(nearest)) / distance;
    if (separation <= radii) add(vertices_[corner] + further, separation);
    return contact;
  }
  /// From an end of the edge to a corner.
  Float2 between(int corner, int end) const { return vertices_[corner] - edge_.vertex(end); }
  replayed::Contact clipped(const Float2& first, const Float2& last, const Float2& normal,
                            jbox2d::Ends ends, bool is_of_polygon) const {
    const Float2 side(normal.y(), -normal.x());
    const float wider = is_mended(FaultOfJbox2dEdge::slab) ? radius_ : 0.0F;
    if (!jbox2d::clip_to_line(ends, side, side.dot(first) + wider) ||
        !jbox2d::clip_to_line(ends, -side, (-side).dot(last) + wider)) {
      return {};
    }
    const Vector2<double> out =
        edge_.turned(is_of_polygon ? Float2(-normal) : normal).cast<double>();
    const Body& incident = is_of_polygon ? edge_.body : polygon_.body;
    // From the core to the surface.
    const double to_surface =
        (is_of_polygon ? 1 : -1) * static_cast<double>(incident.polygon.radius);
    const float radii = edge_.body.polygon.radius + polygon_.body.polygon.radius;
    replayed::Contact contact{out, {}};
    for (const Float2& end : ends) {
      const float separation = normal.dot(end - first);
      if (separation > radius_ || separation > radii) continue;
      contact.points.push_back({edge_.placed(end).cast<double>() + to_surface * out,
                                static_cast<double>(radii - separation)});
    }
    return contact;
  }

  jbox2d::Polygon edge_;
  jbox2d::Polygon polygon_;
  unsigned mended_;
  Body between_;
  std::array<Float2, kMaxVertices> vertices_;
  std::array<Float2, kMaxVertices> normals_;
  Float2 normal_;
  bool is_front_ = false;
  float radius_ = 0;
};

/// The contact of an edge and a polygon, with the normal from A to B.
replayed::Contact edge_by_jbox2d(const PairCase& pair, unsigned mended) {
  const bool is_swapped = pair.b.polygon.count == 2;
  const Body& edge = is_swapped ? pair.b : pair.a;
  const Body& polygon = is_swapped ? pair.a : pair.b;
  replayed::Contact contact = EdgeAndPolygonOfJbox2d(edge, polygon, mended).contact();
  if (is_swapped) contact.normal = -contact.normal;
  return contact;
}

}  // namespace

bool is_edge_at_fault(const Deviation& d, FaultOfJbox2dEdge fault) {
  const PairCase& pair = d.right.pair();
  if (std::min(pair.a.polygon.count, pair.b.polygon.count) != 2 ||
      std::max(pair.a.polygon.count, pair.b.polygon.count) < kMinVertices ||
      !replayed::is_same_answer(d, edge_by_jbox2d(pair, 0))) {
    return false;
  }
  const Declaration declaration{
      .frame = RoundingFrame::world, .min_vertices = 1, .takes_round = true};
  constexpr unsigned kAll = 31;
  return replayed::is_needed(static_cast<unsigned>(fault), kAll, [&](unsigned mended) {
    return replayed::is_right_answer(d, declaration, edge_by_jbox2d(pair, mended));
  });
}

}  // namespace manifuzz
