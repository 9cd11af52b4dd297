#include "own_colliders/detected.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz::own {
namespace {

/// A pair with a normal from A to B, all in A's frame.
class AlongNormal {
 public:
  AlongNormal(const PairCase& pair, const Vector2<double>& normal)
      : a_(polygon_cast<double>(pair.a.polygon)),
        b_(transform(exact_b_in_a(pair), polygon_cast<double>(pair.b.polygon))),
        normal_(normal) {}

  /// The height of A's core, or of B's least high one.
  double top_of_a() const { return methods::greatest_height(a_, normal_); }
  double bottom_of_b() const { return -methods::greatest_height<double>(b_, -normal_); }

  Side likest_face() const {
    return likeness(a_, normal_) >= likeness(b_, -normal_) ? Side::a : Side::b;
  }

 private:
  static double likeness(const ConvexPolygon<double>& shape, const Vector2<double>& normal) {
    double most = -1;
    for (int i = 0; i < shape.face_count(); ++i) {
      most = std::max(most, shape.normals[i].dot(normal));
    }
    return most;
  }

  ConvexPolygon<double> a_;
  ConvexPolygon<double> b_;
  Vector2<double> normal_;
};

bool names_reference(const Answer& answer) {
  const auto* const partial = std::get_if<PartialManifold>(&answer);
  return partial == nullptr || partial->names_reference;
}

int deepest_point(const Manifold<double>& manifold) {
  return manifold.count > 1 && manifold.points[1].depth > manifold.points[0].depth ? 1 : 0;
}

}  // namespace

Pose<double> exact_b_in_a(const PairCase& pair) {
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  return {rotate_inverse<double>(
              rotation, pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>()),
          rotate_inverse<double>(rotation, pair.b.pose.rotation.cast<double>())};
}

std::optional<methods::DetectedPoint<double>> detected(const PairCase& pair,
                                                       const Declaration& declaration,
                                                       const Answer& answer) {
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr || manifold->count == 0) return std::nullopt;
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  const double local_per_world = 1 / std::sqrt(rotation.dot(rotation));
  const Vector2<double>& normal = manifold->normal;
  const ContactPoint<double>& point = manifold->points[deepest_point(*manifold)];
  const Vector2<double> through = point.depth * local_per_world * normal;
  const double radius_a = static_cast<double>(pair.a.polygon.radius) * local_per_world;
  const double radius_b = static_cast<double>(pair.b.polygon.radius) * local_per_world;
  const AlongNormal shapes(pair, normal);
  const bool is_named = names_reference(answer);
  const Side carrier = is_named ? manifold->reference : shapes.likest_face();

  const auto from_a = [&](const Vector2<double>& on_a) {
    return methods::DetectedPoint<double>{normal, on_a, on_a - through, carrier};
  };
  const auto from_b = [&](const Vector2<double>& on_b) {
    return methods::DetectedPoint<double>{normal, on_b + through, on_b, carrier};
  };
  switch (declaration.points) {
    case PointsAt::surface_a:
      return from_a(point.position);
    case PointsAt::surface_b:
      return from_b(point.position);
    case PointsAt::midpoint:
      return from_a(point.position + through / 2);
    default:
      break;
  }
  const bool is_on_surface = declaration.points == PointsAt::clip && is_round(pair);
  const double skin_a = is_on_surface ? 0 : radius_a;
  const double skin_b = is_on_surface ? 0 : radius_b;
  const double height = normal.dot(point.position);
  const double from_top = std::abs(height + skin_a - radius_a - shapes.top_of_a());
  const double from_bottom = std::abs(height - skin_b + radius_b - shapes.bottom_of_b());
  const bool is_clip_of_b = is_named && declaration.points == PointsAt::clip;
  const bool is_on_b = is_clip_of_b ? carrier == Side::a : from_bottom <= from_top;
  return is_on_b ? from_b(point.position - skin_b * normal)
                 : from_a(point.position + skin_a * normal);
}

}  // namespace manifuzz::own
