#include "exact/clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz::exact {
namespace {

using Rough = Approximate<double>;
using Fine = Approximate<DoubleDouble>;

/// The sign of what a rough value says, or else of the exact sum.
template <class Expression>
int decide_from(const Rough& rough, const Expression& expression) {
  const auto s = sign(rough);
  return s ? *s : decide(expression);
}

/// The sign of (distance of an end from the first side plane, inwards) - length.
int compare_with_first(const Clip& clip, int end, double length) {
  return decide_from(clip.along[end] - Rough(length), [&]<class Number>() {
    return RootSum<Number>{{{scaled_along<Number>(clip, end)},
                            {radius_of<Number>(clip) - Number(length), squared_face<Number>(clip)},
                            {}}};
  });
}

/// The sign of (distance of an end beyond the second side plane, outwards) - length.
int compare_with_second(const Clip& clip, int end, double length) {
  return decide_from(clip.along[end] - clip.width - Rough(length), [&]<class Number>() {
    const Number face = squared_face<Number>(clip);
    return RootSum<Number>{{{scaled_along<Number>(clip, end) - face},
                            {-(radius_of<Number>(clip) + Number(length)), face},
                            {}}};
  });
}

Feature feature(Feature::Kind kind, int index) {
  return {kind, static_cast<unsigned char>(index)};
}

FeaturePair features_of(const Clip& clip, int end, bool crossing) {
  const FaceOf& reference = clip.reference;
  Feature of_reference = feature(Feature::Kind::face, reference.index);
  Feature of_incident = feature(Feature::Kind::vertex, clip.vertex(end));
  if (crossing) {
    const int corner = clip.cuts[end] == Cut::before
                           ? reference.index
                           : (*clip.pair)[reference.side].polygon.next(reference.index);
    of_reference = feature(Feature::Kind::vertex, corner);
    of_incident = feature(Feature::Kind::face, clip.incident);
  }
  return reference.side == Side::a ? FeaturePair{of_reference, of_incident}
                                   : FeaturePair{of_incident, of_reference};
}

/// The end nearer to the slab that the edge misses; of equals the first.
int nearest_end(const Clip& clip) {
  const int apart = decide([&]<class Number>() {
    return RootSum<Number>{
        {{scaled_along<Number>(clip, 1) - scaled_along<Number>(clip, 0)}, {}, {}}};
  });
  return (clip.cuts[0] == Cut::before ? apart : -apart) > 0 ? 1 : 0;
}

/// The sign of bound^2 - |p - q|^2, as far as the numbers tell.
template <class E>
std::optional<int> sign_within(const Point<E>& p, const Point<E>& q, const E& bound) {
  const Point<E> apart = p - q;
  return sign(bound * bound - dot(apart, apart));
}

template <class Number>
Point<Element<Number>> reported(const Vector2<double>& v) {
  return {Element<Number>(v.x()), Element<Number>(v.y())};
}

template <class Number>
Located<Number> located(const Clip& clip, const ClipPoint& point) {
  if constexpr (std::is_same_v<Number, Rough>) {
    return point.located;
  } else {
    return locate<Number>(clip, point.end);
  }
}

/// The first sign that `compare` finds, from rough numbers to exact ones.
template <class Compare>
int settle(const Compare& compare) {
  if (const auto s = compare.template operator()<Rough>()) return *s;
  if (const auto s = compare.template operator()<Fine>()) return *s;
  return *compare.template operator()<Rational>();
}

/// Finds where the ends lie along the reference face, and which of them its side planes cut.
void cut_ends(Clip& clip) {
  const Rough face = sqrt(squared_face<Rough>(clip));
  const Rough radius = radius_of<Rough>(clip);
  clip.width = face + Rough(2) * radius;
  for (const int end : {0, 1}) {
    clip.along[end] = scaled_along<Rough>(clip, end) / face + radius;
    clip.cuts[end] = compare_with_first(clip, end, 0) < 0    ? Cut::before
                     : compare_with_second(clip, end, 0) > 0 ? Cut::beyond
                                                             : Cut::inside;
  }
}

/// Finds the incident edge's length, and its angle to the reference face.
void measure_angle(Clip& clip) {
  const Point<Rough> edge = end_of<Rough>(clip, 1) - end_of<Rough>(clip, 0);
  const Rough face = sqrt(squared_face<Rough>(clip));
  const Rough rise = dot(outward<Rough>(*clip.pair, clip.reference), edge) / face;
  clip.edge_length =
      sqrt(square<Rough>(*clip.pair, {other(clip.reference.side), clip.incident})).value;
  clip.cosine = std::abs((clip.along[1] - clip.along[0]).value) / clip.edge_length;
  const bool is_steep = !(clip.cosine > 0);  // or too short for doubles to tell
  clip.tangent = is_steep ? std::numeric_limits<double>::infinity()
                          : std::abs(rise.value) / clip.edge_length / clip.cosine;
}

void add_point(Clip& clip, int end, bool crossing) {
  ClipPoint& point = clip.points[clip.count++];
  point.end = end;
  point.crossing = crossing;
  point.features = features_of(clip, end, crossing);
  point.located = locate<Rough>(clip, end);
}

}  // namespace

int Clip::vertex(int end) const {
  return end == 0 ? (*pair)[other(reference.side)].polygon.next(incident) : incident;
}

double Clip::gap() const {
  const auto [least, most] = std::minmax(along[0].value, along[1].value);
  return std::max(-most, least - width.value);
}

Clip clip(const StoredPair& pair, FaceOf reference, int incident) {
  Clip result;
  result.pair = &pair;
  result.reference = reference;
  result.incident = incident;
  cut_ends(result);
  measure_angle(result);
  const auto normal = true_normal<Rough>(result);
  result.normal = {normal.x.value, normal.y.value};
  if (result.misses()) {
    add_point(result, nearest_end(result), false);
  } else {
    for (const int end : {0, 1}) add_point(result, end, result.cuts[end] != Cut::inside);
  }
  return result;
}

Manifold<double> true_manifold(const Clip& clip, double slack) {
  Manifold<double> manifold;
  manifold.reference = clip.reference.side;
  const auto normal = true_normal<Fine>(clip);
  manifold.normal = {leading(normal.x.value), leading(normal.y.value)};
  if (compare_gap(clip, slack) > 0) return manifold;
  for (int i = 0; i < clip.count; ++i) {
    const ClipPoint& point = clip.points[i];
    if (compare_depth(clip, point, 0) < 0) continue;
    const auto [position, depth] = locate<Fine>(clip, point.end);
    manifold.points[manifold.count++] = {{leading(position.x.value), leading(position.y.value)},
                                         leading(depth.value),
                                         point.features};
  }
  return manifold;
}

int compare_gap(const Clip& clip, double length) {
  const int before =
      std::min(-compare_with_first(clip, 0, -length), -compare_with_first(clip, 1, -length));
  const int beyond =
      std::min(compare_with_second(clip, 0, length), compare_with_second(clip, 1, length));
  return std::max(before, beyond);
}

int compare_width(const Clip& clip, double length) {
  return decide_from(clip.width - Rough(length), [&]<class Number>() {
    return RootSum<Number>{{{Number(1.0), squared_face<Number>(clip)},
                            {Number(2.0) * radius_of<Number>(clip) - Number(length)},
                            {}}};
  });
}

int compare_margin(const Clip& clip, int end, double length) {
  const int of_first =
      std::max(compare_with_first(clip, end, length), -compare_with_first(clip, end, -length));
  const int of_second =
      std::max(compare_with_second(clip, end, length), -compare_with_second(clip, end, -length));
  return std::min(of_first, of_second);
}

int compare_depth(const Clip& clip, const ClipPoint& point, double length) {
  return settle([&]<class Number>() {
    return sign(located<Number>(clip, point).depth - Element<Number>(length));
  });
}

bool is_near_position(const Clip& clip, const ClipPoint& point, const Vector2<double>& position,
                      double bound) {
  if (!position.allFinite()) return false;
  return settle([&]<class Number>() {
           return sign_within(located<Number>(clip, point).position, reported<Number>(position),
                              Element<Number>(bound));
         }) >= 0;
}

bool is_near_depth(const Clip& clip, const ClipPoint& point, double depth, double bound) {
  if (!std::isfinite(depth)) return false;
  return settle([&]<class Number>() {
           const auto off = located<Number>(clip, point).depth - Element<Number>(depth);
           const Element<Number> within(bound);
           return sign(within * within - off * off);
         }) >= 0;
}

bool is_near_normal(const Clip& clip, const Vector2<double>& normal, double bound) {
  if (!normal.allFinite()) return false;
  return settle([&]<class Number>() {
           return sign_within(true_normal<Number>(clip), reported<Number>(normal),
                              Element<Number>(bound));
         }) >= 0;
}

int compare_apart(const Clip& clip, double length) {
  return -settle([&]<class Number>() {
    return sign_within(located<Number>(clip, clip.points[0]).position,
                       located<Number>(clip, clip.points[1]).position, Element<Number>(length));
  });
}

}  // namespace manifuzz::exact
