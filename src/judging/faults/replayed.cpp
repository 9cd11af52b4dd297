#include "judging/faults/replayed.hpp"

#include <algorithm>
#include <cmath>

#include "judging/by_curve.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz::replayed {
namespace {

/// Rationals have no infinity.
bool is_finite(const Contact& contact) {
  return contact.points.empty() ||
         (contact.normal.allFinite() &&
          std::ranges::all_of(contact.points, [](const Contact::Point& point) {
            return point.at.allFinite() && std::isfinite(point.depth);
          }));
}

}  // namespace

Manifold<double> in_frame_of_a(const PairCase& pair, const Contact& contact) {
  Manifold<double> manifold;
  manifold.count = static_cast<int>(contact.points.size());
  if (contact.points.empty()) return manifold;
  manifold.normal = local_normal(pair, contact.normal);
  const Vector2<double> from = pair.a.pose.position.cast<double>() - contact.origin;
  for (std::size_t i = 0; i < contact.points.size(); ++i) {
    manifold.points[i].position =
        rotate_inverse<double>(pair.a.pose.rotation.cast<double>(), contact.points[i].at - from);
    manifold.points[i].depth = contact.points[i].depth;
  }
  return manifold;
}

bool is_same_answer(const Deviation& d, const Contact& contact) {
  const Manifold<double> replayed = in_frame_of_a(d.right.pair(), contact);
  if (replayed.count != d.got.count) return false;
  if (replayed.count == 0) return true;
  const Bounds& bounds = d.right.bounds;
  const auto is_same_point = [&](const ContactPoint<double>& p, const ContactPoint<double>& q) {
    return (p.position - q.position).norm() <= bounds.separation &&
           std::abs(p.depth - q.depth) <= bounds.separation;
  };
  // An answer's points are put into the order of the contract.
  const auto& [first, second] = replayed.points;
  const auto& points = d.got.points;
  const bool in_order =
      is_same_point(points[0], first) && (replayed.count < 2 || is_same_point(points[1], second));
  const bool in_reverse =
      replayed.count == 2 && is_same_point(points[0], second) && is_same_point(points[1], first);
  return (in_order || in_reverse) && (d.got.normal - replayed.normal).norm() <= bounds.normal;
}

bool is_right_answer(const Deviation& d, const Declaration& declaration, const Contact& contact) {
  if (!is_finite(contact)) return false;
  PartialManifold partial;
  partial.manifold = in_frame_of_a(d.right.pair(), contact);
  if (is_judged_by_curve(declaration, d.right.pair())) {
    return judge_by_curve(*d.right.truth, declaration, partial).kind == Kind::none;
  }
  return mismatch(completed(partial, d.right), d.right).kind == Kind::none;
}

bool is_same_separation(const Deviation& d, const Vector2<double>& normal, double depth) {
  return d.got.count > 0 &&
         (d.got.normal - local_normal(d.right.pair(), normal)).norm() <= d.right.bounds.normal &&
         std::abs(d.got.points[0].depth - depth) <= d.right.bounds.separation;
}

bool is_right_separation(const Deviation& d, const Declaration& declaration,
                         const Vector2<double>& normal, double depth) {
  const Penetration said{
      .touches = true, .normal = local_normal(d.right.pair(), normal), .depth = depth};
  return judge_by_curve(*d.right.truth, declaration, said).kind == Kind::none;
}

std::vector<Vector2<double>> least_normals(const Deviation& d) {
  const exact::PenetrationCurve curve(*d.right.truth, exact::skin_of(*d.right.truth));
  auto normals = curve.minima(d.right.bounds.separation);
  for (Vector2<double>& normal : normals) normal = world_normal(d.right.pair(), normal);
  return normals;
}

Vector2<double> least_normal_near(const Deviation& d, const Vector2<double>& normal) {
  const auto normals = least_normals(d);
  return *std::ranges::max_element(normals, {},
                                   [&](const Vector2<double>& least) { return least.dot(normal); });
}

}  // namespace manifuzz::replayed
