#include "report/round_truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "exact/curve.hpp"

namespace manifuzz {
namespace {

using Place = Vector2<double>;

/// A place of a core as it is seen along the contact's normal: how far along the tangent, and how
/// far along the normal.
struct SeenPlace {
  double along = 0;
  double height = 0;
  Feature feature{};
};

/// An edge from its first end along the tangent to its last; of a point both are one.
struct Edge {
  SeenPlace low;
  SeenPlace high;
  int face = 0;
  double cosine = 0;  ///< of the angle between its outward normal and the way to the other shape

  /// Its end there, or the place on it.
  SeenPlace at(double along) const {
    if (along <= low.along) return low;
    if (along >= high.along) return high;
    const double share = (along - low.along) / (high.along - low.along);
    return {along,
            low.height + share * (high.height - low.height),
            {Feature::Kind::face, static_cast<unsigned char>(face)}};
  }
};

/// Both cores along one normal, in world directions, seen from A's position.
class RoundContact {
 public:
  RoundContact(const PairCase& pair, const Vector2<double>& local_normal)
      : pair_(pair),
        placed_(exact::place_roughly(pair)),
        local_normal_(local_normal),
        normal_(world_normal(pair, local_normal)),
        a_(edge_of(Side::a)),
        b_(edge_of(Side::b)) {}

  /// `at`: the vertices that are nearest, A's and B's, where these are.
  Manifold<double> manifold(const std::optional<std::array<int, 2>>& at, double least,
                            const Declaration& declaration) const {
    Manifold<double> contact;
    contact.normal = local_normal_;
    contact.reference = reference();
    const double low = std::max(a_.low.along, b_.low.along);
    const double high = std::min(a_.high.along, b_.high.along);
    double first = depth_at(low) >= depth_at(high) ? low : high;
    double second = first == low ? high : low;
    if (at) {
      first = seen(Side::b, (*at)[1]).along;
      second = std::abs(low - first) > std::abs(high - first) ? low : high;
    }
    contact.points[contact.count++] = point(first, least, contact.reference);
    const bool are_edges = std::min(a_.cosine, b_.cosine) >= declaration.second_point.least_cosine;
    const bool is_far = low < high && std::abs(second - first) > bounds_of(declaration).position;
    if (are_edges && is_far && depth_at(second) >= 0) {
      contact.points[contact.count++] = point(second, depth_at(second), contact.reference);
    }
    order_points(contact);
    return contact;
  }

 private:
  Bounds bounds_of(const Declaration& declaration) const { return bounds(pair_, declaration); }

  SeenPlace seen(Side side, int vertex) const {
    const Place& at = placed_[side].vertices[vertex];
    return {cross<double>(normal_, at),
            normal_.dot(at),
            {Feature::Kind::vertex, static_cast<unsigned char>(vertex)}};
  }

  Edge edge_along(Side side, int face, const Place& towards) const {
    const exact::RoughPolygon& polygon = placed_[side];
    Edge edge{seen(side, face), seen(side, polygon.next(face)), face,
              polygon.normals[face].dot(towards)};
    if (edge.low.along > edge.high.along) std::swap(edge.low, edge.high);
    return edge;
  }

  /// The edge at the vertex that is farthest towards the other shape, the more perpendicular one.
  Edge edge_of(Side side) const {
    const exact::RoughPolygon& polygon = placed_[side];
    const Place towards = side == Side::a ? normal_ : Place(-normal_);
    int farthest = 0;
    for (int i = 1; i < polygon.count; ++i) {
      const Place ahead = polygon.vertices[i] - polygon.vertices[farthest];
      if (towards.dot(ahead) > 0) farthest = i;
    }
    if (polygon.face_count() == 0) return {seen(side, 0), seen(side, 0), 0, -1};
    const Edge edges[] = {edge_along(side, polygon.previous(farthest), towards),
                          edge_along(side, farthest, towards)};
    return edges[edges[1].cosine >= edges[0].cosine ? 1 : 0];
  }

  /// A point is incident, A's before B's; of edges the one less perpendicular to the normal.
  Side reference() const {
    if (placed_.a.face_count() == 0) return Side::b;
    return b_.cosine > a_.cosine ? Side::b : Side::a;
  }

  double depth_at(double along) const {
    return total_radius(pair_) + a_.at(along).height - b_.at(along).height;
  }

  /// On the incident shape's surface.
  ContactPoint<double> point(double along, double depth, Side reference) const {
    const SeenPlace of_a = a_.at(along);
    const SeenPlace of_b = b_.at(along);
    const bool on_b = reference == Side::a;
    const double radius = static_cast<double>(pair_[other(reference)].polygon.radius);
    const double height = on_b ? of_b.height - radius : of_a.height + radius;
    const Place from_a = along * counter_clockwise_quarter<double>(normal_) + height * normal_;
    const Pose<float> turned{{0, 0}, pair_.a.pose.rotation};
    return {to_local(turned, from_a), depth, {of_a.feature, of_b.feature}};
  }

  const PairCase& pair_;
  exact::RoughPair placed_;
  Vector2<double> local_normal_;
  Place normal_;
  Edge a_;
  Edge b_;
};

std::vector<Manifold<double>> round_manifolds(const Admissible& right,
                                              const Declaration& declaration) {
  const exact::PenetrationCurve curve(*right.truth, exact::Skin::round);
  std::vector<Manifold<double>> manifolds;
  if (curve.compare_least(right.bounds.separation) <= 0) manifolds.emplace_back();
  if (curve.compare_least(0) < 0) return manifolds;
  for (const Vector2<double>& normal : curve.minima(right.bounds.separation)) {
    manifolds.push_back(RoundContact(right.pair(), normal)
                            .manifold(curve.nearest_vertices(), curve.least(), declaration));
  }
  return manifolds;
}

}  // namespace

std::vector<Manifold<double>> manifolds_to_show(const Admissible& right,
                                                const Declaration& declaration) {
  if (!is_round(right.pair())) return right_manifolds(right);
  if (!std::isfinite(right.bounds.separation)) return {};
  return round_manifolds(right, declaration);
}

Manifold<double> contact_along(const PairCase& pair, const Vector2<double>& normal, double depth,
                               const Declaration& declaration) {
  return RoundContact(pair, normal).manifold(std::nullopt, depth, declaration);
}

}  // namespace manifuzz
