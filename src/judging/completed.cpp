#include "judging/completed.hpp"

#include <algorithm>
#include <span>

namespace manifuzz {
namespace {

/// Box2D 3 reports the point halfway between the incident edge, grown by its radius, and the
/// reference face: half the depth back along the normal, and the incident polygon's radius on.
/// (box2d v3, src/manifold.c, b2ClipPolygons.)
void move_to_incident_edge(Manifold<double>& manifold, const PairCase& pair) {
  const Side incident = other(manifold.reference);
  const double inwards = incident == Side::b ? 1 : -1;
  const double unit = pair.a.pose.rotation.cast<double>().norm();
  for (int i = 0; i < manifold.count; ++i) {
    const double along =
        static_cast<double>(pair[incident].polygon.radius) - manifold.points[i].depth / 2;
    manifold.points[i].position += inwards * along * manifold.normal / unit;
  }
}

/// With the reference of a model, and the features of its points nearest by.
template <class Points, class PositionOf>
Manifold<double> filled_in(const PartialManifold& given, const PairCase& pair, Side reference,
                           const Points& points, const PositionOf& position_of) {
  Manifold<double> manifold = given.manifold;
  if (!given.names_reference) manifold.reference = reference;
  if (given.has_midpoints) move_to_incident_edge(manifold, pair);
  for (int i = 0; i < manifold.count && !given.names_features; ++i) {
    ContactPoint<double>& point = manifold.points[i];
    const auto squared = [&](const auto& of_model) {
      const Vector2<double> apart = position_of(of_model) - point.position;
      return apart.dot(apart);
    };
    const auto nearest =
        std::ranges::min_element(points, {}, [&](const auto& p) { return squared(p); });
    point.features = nearest->features;
  }
  order_points(manifold);
  return manifold;
}

Manifold<double> as_the_clip_has_it(const PartialManifold& given, const PairCase& pair,
                                    const exact::Clip& clip) {
  return filled_in(given, pair, clip.reference.side,
                   std::span(clip.points.data(), static_cast<std::size_t>(clip.count)),
                   [](const exact::ClipPoint& point) { return point.position(); });
}

}  // namespace

Manifold<double> completed(const PartialManifold& given, const Admissible& right) {
  if (given.manifold.count <= 0 || right.candidates.empty()) return given.manifold;
  for (const exact::Clip* clip : right.candidates) {
    const Manifold<double> manifold = as_the_clip_has_it(given, right.pair(), *clip);
    if (mismatch(manifold, *clip, right).kind == Kind::none) return manifold;
  }
  return as_the_clip_has_it(given, right.pair(), *right.candidates.front());
}

Manifold<double> completed(const PartialManifold& given, const PairCase& pair,
                           const Manifold<double>& model) {
  if (given.manifold.count <= 0 || model.count <= 0) return given.manifold;
  return filled_in(given, pair, model.reference,
                   std::span(model.points.data(), static_cast<std::size_t>(model.count)),
                   [](const ContactPoint<double>& point) { return point.position; });
}

Answer completed(Answer answer, const Admissible& right) {
  if (const auto* const given = std::get_if<PartialManifold>(&answer)) {
    return completed(*given, right);
  }
  return answer;
}

bool is_same(const Answer& one, const Answer& other) {
  if (one.index() != other.index()) return false;
  if (const auto* const manifold = std::get_if<Manifold<double>>(&one)) {
    return *manifold == std::get<Manifold<double>>(other);
  }
  if (const auto* const partial = std::get_if<PartialManifold>(&one)) {
    return partial->manifold == std::get<PartialManifold>(other).manifold;
  }
  return true;
}

Answer whole(Answer answer, const PairCase& pair, const Declaration& declaration) {
  if (!std::holds_alternative<PartialManifold>(answer)) return answer;
  return completed(std::move(answer), admissible(pair, declaration));
}

Answer ask(const Collider& collider, const PairCase& pair) {
  return whole(collider.collide(pair), pair, collider.declaration);
}

}  // namespace manifuzz
