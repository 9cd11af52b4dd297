#include "oracle/exact/clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz::exact {
namespace {

using Rough = Approximate<double>;
using Fine = Approximate<DoubleDouble>;

std::array<int, 2> vertices_of(const PairCase& pair, FaceOf reference, int incident) {
  return {pair[other(reference.side)].polygon.next(incident), incident};
}

/// From the reference face's first corner to an end of the incident edge, along the face and times
/// its length.
template <class Number>
Number scaled_along(const PairCase& pair, const Clip& clip, int end) {
  const FaceOf& face = clip.reference;
  const Point<Number> corner = vertex<Number>(pair, face.side, face.index);
  return dot(direction<Number>(pair, face),
             vertex<Number>(pair, other(face.side), clip.vertex(pair, end)) - corner);
}

/// The sign of what a rough value says, or else of the exact sum.
template <class Expression>
int decide_from(const Rough& rough, const Expression& expression) {
  const auto s = sign(rough);
  return s ? *s : decide(expression);
}

/// The sign of (distance of an end from the first side plane, inwards) - length.
int compare_with_first(const PairCase& pair, const Clip& clip, int end, double length) {
  return decide_from(clip.along[end] - Rough(length), [&]<class Number>() {
    return RootSum<Number>{
        {{scaled_along<Number>(pair, clip, end)},
         {total_radius<Number>(pair) - Number(length), square<Number>(pair, clip.reference)},
         {}}};
  });
}

/// The sign of (distance of an end beyond the second side plane, outwards) - length.
int compare_with_second(const PairCase& pair, const Clip& clip, int end, double length) {
  return decide_from(clip.along[end] - clip.width - Rough(length), [&]<class Number>() {
    const Number face = square<Number>(pair, clip.reference);
    return RootSum<Number>{{{scaled_along<Number>(pair, clip, end) - face},
                            {-(total_radius<Number>(pair) + Number(length)), face},
                            {}}};
  });
}

Feature feature(Feature::Kind kind, int index) {
  return {kind, static_cast<unsigned char>(index)};
}

FeaturePair features_of(const PairCase& pair, const Clip& clip, int end, bool crossing) {
  const FaceOf& reference = clip.reference;
  Feature of_reference = feature(Feature::Kind::face, reference.index);
  Feature of_incident = feature(Feature::Kind::vertex, clip.vertex(pair, end));
  if (crossing) {
    const int corner = clip.cuts[end] == Cut::before
                           ? reference.index
                           : pair[reference.side].polygon.next(reference.index);
    of_reference = feature(Feature::Kind::vertex, corner);
    of_incident = feature(Feature::Kind::face, clip.incident);
  }
  return reference.side == Side::a ? FeaturePair{of_reference, of_incident}
                                   : FeaturePair{of_incident, of_reference};
}

/// The end nearer to the slab that the edge misses; of equals the first.
int nearest_end(const PairCase& pair, const Clip& clip) {
  const int apart = decide([&]<class Number>() {
    return RootSum<Number>{
        {{scaled_along<Number>(pair, clip, 1) - scaled_along<Number>(pair, clip, 0)}, {}, {}}};
  });
  return (clip.cuts[0] == Cut::before ? apart : -apart) > 0 ? 1 : 0;
}

/// Where the line of the incident edge is after the clip, from A's position, in the world.
template <class Number>
Point<Element<Number>> world_position(const PairCase& pair, const Clip& clip, int end,
                                      const Number& face) {
  using E = Element<Number>;
  const Side opposing = other(clip.reference.side);
  const auto element = [&](const Number& number) { return with_root(number, Number(0.0), face); };
  if (clip.cuts[end] == Cut::inside || clip.count < 2) {
    const Point<Number> at = vertex<Number>(pair, opposing, clip.vertex(pair, end));
    return {element(at.x), element(at.y)};
  }
  // The share of the edge at which it crosses the side plane: before 0, or beyond face + 2 r.
  const bool before = clip.cuts[end] == Cut::before;
  const Number radius = total_radius<Number>(pair);
  const Number first = scaled_along<Number>(pair, clip, 0);
  const Number whole = scaled_along<Number>(pair, clip, 1) - first;
  const E share = with_root(((before ? Number(0.0) : face) - first) / whole,
                            (before ? -radius : radius) / whole, face);
  const Point<Number> from = vertex<Number>(pair, opposing, clip.vertex(pair, 0));
  const Point<Number> edge = vertex<Number>(pair, opposing, clip.vertex(pair, 1)) - from;
  return {element(from.x) + share * element(edge.x), element(from.y) + share * element(edge.y)};
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
Located<Number> located(const PairCase& pair, const Clip& clip, const ClipPoint& point) {
  if constexpr (std::is_same_v<Number, Rough>) {
    return point.located;
  } else {
    return locate<Number>(pair, clip, point.end);
  }
}

/// The first sign that `compare` finds, from rough numbers to exact ones.
template <class Compare>
int settle(const Compare& compare) {
  if (const auto s = compare.template operator()<Rough>()) return *s;
  if (const auto s = compare.template operator()<Fine>()) return *s;
  return *compare.template operator()<Rational>();
}

}  // namespace

int Clip::vertex(const PairCase& pair, int end) const {
  return vertices_of(pair, reference, incident)[static_cast<std::size_t>(end)];
}

double Clip::gap() const {
  const auto [least, most] = std::minmax(along[0].value, along[1].value);
  return std::max(-most, least - width.value);
}

template <class Number>
Located<Number> locate(const PairCase& pair, const Clip& clip, int end) {
  using E = Element<Number>;
  const Number face = square<Number>(pair, clip.reference);
  const auto element = [&](const Number& number) { return with_root(number, Number(0.0), face); };
  const Point<E> world = world_position<Number>(pair, clip, end, face);
  const Point<Number> corner = vertex<Number>(pair, clip.reference.side, clip.reference.index);
  const Point<Number> out = outward<Number>(pair, clip.reference);
  const E scaled = element(out.x) * (world.x - element(corner.x)) +
                   element(out.y) * (world.y - element(corner.y));
  const E depth = element(total_radius<Number>(pair)) -
                  scaled * with_root(Number(0.0), Number(1.0) / face, face);
  const Point<Number> r = widen<Number>(pair.a.pose.rotation);
  const Number scale_a = scale<Number>(pair.a);
  const E cosine = element(r.x / scale_a);
  const E sine = element(r.y / scale_a);
  return {{cosine * world.x + sine * world.y, cosine * world.y - sine * world.x}, depth};
}

template <class Number>
Point<Element<Number>> true_normal(const PairCase& pair, FaceOf face) {
  const Point<Number> out = outward<Number>(pair, face);
  const Point<Number> local =
      turned_back(pair.a, face.side == Side::a ? out : Point<Number>{-out.x, -out.y});
  const Number length_squared = dot(local, local);
  return {with_root(Number(0.0), local.x / length_squared, length_squared),
          with_root(Number(0.0), local.y / length_squared, length_squared)};
}

template Point<Rough> true_normal<Rough>(const PairCase&, FaceOf);
template Point<Fine> true_normal<Fine>(const PairCase&, FaceOf);
template Point<Quadratic> true_normal<Rational>(const PairCase&, FaceOf);
template Located<Rough> locate(const PairCase&, const Clip&, int);
template Located<Fine> locate(const PairCase&, const Clip&, int);
template Located<Rational> locate(const PairCase&, const Clip&, int);

Clip clip(const PairCase& pair, FaceOf reference, int incident) {
  Clip result;
  result.reference = reference;
  result.incident = incident;
  const Rough face = sqrt(square<Rough>(pair, reference));
  const Rough radius = total_radius<Rough>(pair);
  result.width = face + Rough(2) * radius;
  for (const int end : {0, 1}) {
    result.along[end] = scaled_along<Rough>(pair, result, end) / face + radius;
  }
  for (const int end : {0, 1}) {
    if (compare_with_first(pair, result, end, 0) < 0) {
      result.cuts[end] = Cut::before;
    } else {
      result.cuts[end] = compare_with_second(pair, result, end, 0) > 0 ? Cut::beyond : Cut::inside;
    }
  }
  const FaceOf edge{other(reference.side), incident};
  result.edge_length = sqrt(square<Rough>(pair, edge)).value;
  result.cosine = std::abs((result.along[1] - result.along[0]).value) / result.edge_length;
  const auto ends = vertices_of(pair, reference, incident);
  const Point<Rough> along_edge =
      vertex<Rough>(pair, edge.side, ends[1]) - vertex<Rough>(pair, edge.side, ends[0]);
  const Rough rise = dot(outward<Rough>(pair, reference), along_edge) / face;
  const bool is_steep = !(result.cosine > 0);  // or too short for doubles to tell
  result.tangent = is_steep ? std::numeric_limits<double>::infinity()
                            : std::abs(rise.value) / result.edge_length / result.cosine;
  const auto normal = true_normal<Rough>(pair, reference);
  result.normal = {normal.x.value, normal.y.value};

  const bool misses = result.cuts[0] == result.cuts[1] && result.cuts[0] != Cut::inside;
  const auto add = [&](int end) {
    ClipPoint& point = result.points[result.count];
    point.end = end;
    point.crossing = !misses && result.cuts[end] != Cut::inside;
    point.features = features_of(pair, result, end, point.crossing);
    ++result.count;
  };
  if (misses) {
    add(nearest_end(pair, result));
  } else {
    add(0);
    add(1);
  }
  for (int i = 0; i < result.count; ++i) {
    result.points[i].located = locate<Rough>(pair, result, result.points[i].end);
  }
  return result;
}

Manifold<double> true_manifold(const PairCase& pair, const Clip& clip, double slack) {
  Manifold<double> manifold;
  manifold.reference = clip.reference.side;
  const auto normal = true_normal<Fine>(pair, clip.reference);
  manifold.normal = {leading(normal.x.value), leading(normal.y.value)};
  if (compare_gap(pair, clip, slack) > 0) return manifold;
  for (int i = 0; i < clip.count; ++i) {
    const ClipPoint& point = clip.points[i];
    if (compare_depth(pair, clip, point, 0) < 0) continue;
    const auto [position, depth] = locate<Fine>(pair, clip, point.end);
    manifold.points[manifold.count++] = {{leading(position.x.value), leading(position.y.value)},
                                         leading(depth.value),
                                         point.features};
  }
  return manifold;
}

int compare_gap(const PairCase& pair, const Clip& clip, double length) {
  const int before = std::min(-compare_with_first(pair, clip, 0, -length),
                              -compare_with_first(pair, clip, 1, -length));
  const int beyond = std::min(compare_with_second(pair, clip, 0, length),
                              compare_with_second(pair, clip, 1, length));
  return std::max(before, beyond);
}

int compare_width(const PairCase& pair, const Clip& clip, double length) {
  return decide_from(clip.width - Rough(length), [&]<class Number>() {
    return RootSum<Number>{{{Number(1.0), square<Number>(pair, clip.reference)},
                            {Number(2.0) * total_radius<Number>(pair) - Number(length)},
                            {}}};
  });
}

int compare_margin(const PairCase& pair, const Clip& clip, int end, double length) {
  const int of_first = std::max(compare_with_first(pair, clip, end, length),
                                -compare_with_first(pair, clip, end, -length));
  const int of_second = std::max(compare_with_second(pair, clip, end, length),
                                 -compare_with_second(pair, clip, end, -length));
  return std::min(of_first, of_second);
}

int compare_depth(const PairCase& pair, const Clip& clip, const ClipPoint& point, double length) {
  return settle([&]<class Number>() {
    return sign(located<Number>(pair, clip, point).depth - Element<Number>(length));
  });
}

bool is_near_position(const PairCase& pair, const Clip& clip, const ClipPoint& point,
                      const Vector2<double>& position, double bound) {
  if (!position.allFinite()) return false;
  return settle([&]<class Number>() {
           return sign_within(located<Number>(pair, clip, point).position,
                              reported<Number>(position), Element<Number>(bound));
         }) >= 0;
}

bool is_near_depth(const PairCase& pair, const Clip& clip, const ClipPoint& point, double depth,
                   double bound) {
  if (!std::isfinite(depth)) return false;
  return settle([&]<class Number>() {
           const auto off = located<Number>(pair, clip, point).depth - Element<Number>(depth);
           const Element<Number> within(bound);
           return sign(within * within - off * off);
         }) >= 0;
}

bool is_near_normal(const PairCase& pair, const Clip& clip, const Vector2<double>& normal,
                    double bound) {
  if (!normal.allFinite()) return false;
  return settle([&]<class Number>() {
           return sign_within(true_normal<Number>(pair, clip.reference), reported<Number>(normal),
                              Element<Number>(bound));
         }) >= 0;
}

int compare_apart(const PairCase& pair, const Clip& clip, double length) {
  return -settle([&]<class Number>() {
    return sign_within(located<Number>(pair, clip, clip.points[0]).position,
                       located<Number>(pair, clip, clip.points[1]).position,
                       Element<Number>(length));
  });
}

}  // namespace manifuzz::exact
