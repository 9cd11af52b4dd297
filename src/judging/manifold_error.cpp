#include "judging/manifold_error.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "exact/clip.hpp"
#include "judging/by_curve.hpp"
#include "judging/unjudged.hpp"

namespace manifuzz {
namespace {

using Fine = ClipFigures::Number;

double length(const Fine& x, const Fine& y) {
  // Squares of such figures are beyond double.
  const double rough = std::hypot(exact::leading(x.value), exact::leading(y.value));
  if (!(rough < 1e150)) return rough;
  return exact::leading(sqrt(x * x + y * y).value);
}

ManifoldError error_of(const ContactPoint<double>& reported, const exact::Located<Fine>& truth) {
  return {.position = length(Fine(reported.position.x()) - truth.position.x,
                             Fine(reported.position.y()) - truth.position.y),
          .depth = std::abs(exact::leading((Fine(reported.depth) - truth.depth).value))};
}

double largest(const ManifoldError& share) {
  return std::max({share.normal, share.position, share.depth});
}

}  // namespace

void widen(ManifoldError& worst, const ManifoldError& other) {
  worst.normal = std::max(worst.normal, other.normal);
  worst.position = std::max(worst.position, other.position);
  worst.depth = std::max(worst.depth, other.depth);
}

ManifoldError share_of_size(const ManifoldError& error, double size) {
  return {error.normal, error.position / size, error.depth / size};
}

ClipFigures::ClipFigures(const exact::Clip& of)
    : clip(&of), normal(exact::true_normal<Number>(of)) {
  for (int k = 0; k < of.count; ++k) points[k] = exact::locate<Number>(of, of.points[k].end);
}

double normal_error(const Manifold<double>& manifold, const ClipFigures& truth) {
  return length(Fine(manifold.normal.x()) - truth.normal.x,
                Fine(manifold.normal.y()) - truth.normal.y);
}

ManifoldError point_error(const ContactPoint<double>& reported, const ClipFigures& truth, int k) {
  return error_of(reported, truth.points[k]);
}

ErrorAgainstClip error_against(const Manifold<double>& manifold, const ClipFigures& truth,
                               const Bounds& bounds) {
  const exact::Clip& clip = *truth.clip;
  ManifoldError error{.normal = normal_error(manifold, truth)};
  ManifoldError of_bound{.normal = error.normal / bounds.normal};
  for (int i = 0; i < manifold.count; ++i) {
    std::array<ManifoldError, 2> errors;
    for (int k = 0; k < clip.count; ++k) errors[k] = error_of(manifold.points[i], truth.points[k]);
    const int k = clip.count > 1 && errors[1].position < errors[0].position ? 1 : 0;
    const exact::ClipPoint& point = clip.points[k];
    widen(error, errors[k]);
    widen(of_bound, {.position = errors[k].position / position_bound(bounds, clip, point),
                     .depth = errors[k].depth / depth_bound(bounds, clip, point)});
  }
  return {error, of_bound, &clip};
}

std::optional<ErrorAgainstClip> nearest_error(const Manifold<double>& manifold,
                                              const Admissible& right, ClipFiguresCache& figures) {
  const auto distance = [](const ErrorAgainstClip& measured) {
    return measured.error.position + measured.error.depth;
  };
  std::optional<ErrorAgainstClip> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || clip->count == 0) continue;
    const ErrorAgainstClip measured =
        error_against(manifold, figures.of(*clip), bounds_of_face(right, *clip));
    if (!nearest || distance(measured) < distance(*nearest)) nearest = measured;
  }
  return nearest;
}

std::optional<ErrorAgainstClip> error_if_right(const Manifold<double>& manifold,
                                               const Admissible& right, ClipFiguresCache& figures) {
  std::optional<ErrorAgainstClip> nearest;
  for (const exact::Clip* clip : right.candidates) {
    if (manifold.count == 0 || mismatch(manifold, *clip, right).kind != Kind::none) continue;
    const ErrorAgainstClip measured =
        error_against(manifold, figures.of(*clip), bounds_of_face(right, *clip));
    if (!nearest || largest(measured.of_bound) < largest(nearest->of_bound)) nearest = measured;
  }
  return nearest;
}

std::optional<ErrorAgainstCurve> error_against(const exact::PenetrationCurve& curve,
                                               const exact::Truth& truth,
                                               const ColliderAnswer& given) {
  const auto said = said_along(given.answer);
  if (!said || !touches(given.answer)) return std::nullopt;
  const CurveBounds bounds = curve_bounds(truth.pair(), given.declaration, truth.extent());
  const auto off = [&](const Vector2<double>& normal) { return (normal - said->normal).norm(); };
  const auto minima = curve.minima(bounds.minimality);
  const ManifoldError error{.normal = off(*std::ranges::min_element(minima, {}, off)),
                            .depth = std::abs(said->depth - curve.least())};
  return ErrorAgainstCurve{
      error, {.normal = error.normal / bounds.normal, .depth = error.depth / bounds.minimality}};
}

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

bool is_same(const Answer& one, const Answer& other) {
  if (one.index() != other.index()) return false;
  if (const auto* const manifold = std::get_if<Manifold<double>>(&one)) {
    return *manifold == std::get<Manifold<double>>(other);
  }
  if (const auto* const partial = std::get_if<PartialManifold>(&one)) {
    const auto& partial_other = std::get<PartialManifold>(other);
    return partial->manifold == partial_other.manifold && partial->used == partial_other.used;
  }
  if (const auto* const penetration = std::get_if<Penetration>(&one)) {
    return *penetration == std::get<Penetration>(other);
  }
  return true;
}

Answer whole(Answer answer, const Admissible& right, const Declaration& declaration) {
  const auto* const given = std::get_if<PartialManifold>(&answer);
  if (given == nullptr || given->used) return answer;
  if (is_judged_by_curve(declaration, right.pair()) ||
      why_malformed(right.pair(), {declaration, answer})) {
    return Manifold<double>(given->manifold);
  }
  return completed(*given, right);
}

Answer whole(Answer answer, const PairCase& pair, const Declaration& declaration) {
  if (!std::holds_alternative<PartialManifold>(answer)) return answer;
  return whole(std::move(answer), admissible(pair, declaration), declaration);
}

Answer ask(const Collider& collider, const PairCase& pair) {
  return whole(collider.collide(pair), pair, collider.declaration);
}

}  // namespace manifuzz
