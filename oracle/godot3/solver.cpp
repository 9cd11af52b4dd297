#include "oracle/godot3/solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace manifuzz::as_godot {
namespace {

/// What SeparatorAxisTest2D keeps.
struct BestAxis {
  float depth = 1e15F;
  Vector2<float> axis{0, 0};  ///< from B to A
};

/// test_axis: false where they are apart.
bool test_axis(const Shape& a, const Shape& b, Vector2<float> axis, BestAxis& best) {
  const auto is_zero = [](float x) { return std::abs(x) < static_cast<float>(kCmpEpsilon); };
  if (is_zero(axis.x()) && is_zero(axis.y())) axis = {0, 1};
  const auto [min_a, max_a] = a.range(axis);
  auto [min_b, max_b] = b.range(axis);
  const auto rounded = [](double x) { return static_cast<float>(x); };
  const auto wide = [](float x) { return static_cast<double>(x); };
  min_b = rounded(wide(min_b) - wide(max_a - min_a) * 0.5);
  max_b = rounded(wide(max_b) + wide(max_a - min_a) * 0.5);
  float least = rounded(wide(min_b) - wide(min_a + max_a) * 0.5);
  const float most = rounded(wide(max_b) - wide(min_a + max_a) * 0.5);
  if (least > 0 || most < 0) return false;
  least = std::abs(least);
  if (most < least && most < best.depth) best = {most, axis};
  if (!(most < least) && least < best.depth) best = {least, -axis};
  return true;
}

/// The axes, in the order in which the functions of both types test them; A's type is not after
/// B's.
std::vector<Vector2<float>> axes_of(const Shape& a, const Shape& b, const Mends& mends) {
  using Type = Shape::Type;
  std::vector<Vector2<float>> axes;
  const auto append = [&](const std::vector<Vector2<float>>& some) {
    axes.insert(axes.end(), some.begin(), some.end());
  };
  const auto corners_a = a.corners();
  const auto corners_b = b.corners();
  const auto between = [&](std::size_t i, std::size_t j) {
    axes.push_back(normalized(corners_a[i] - corners_b[j], mends));
  };
  if (a.type() == Type::polygon ||
      (a.type() == Type::segment && b.type() != Type::circle && b.type() != Type::capsule)) {
    append(a.normals());
    append(b.normals());
    return axes;
  }
  if (b.type() == Type::polygon) {
    append(a.normals());
    const auto normals = b.normals();
    for (std::size_t j = 0; j < corners_b.size(); ++j) {
      for (std::size_t i = 0; i < corners_a.size(); ++i) between(i, j);
      axes.push_back(normals[j]);
    }
    return axes;
  }
  const bool is_b_first = a.type() == Type::capsule;
  append(is_b_first ? b.normals() : a.normals());
  append(is_b_first ? a.normals() : b.normals());
  for (std::size_t i = 0; i < corners_a.size(); ++i) {
    for (std::size_t j = 0; j < corners_b.size(); ++j) between(i, j);
  }
  return axes;
}

/// A pair of points, on the first shape that is given and on the second.
template <class Scalar>
struct PointPair {
  Vector2<Scalar> first;
  Vector2<Scalar> second;
};

/// The place of an edge's line on the line through a point along the normal, as a share of the
/// edge.
template <class Scalar>
Scalar share_along(const Supports<Scalar>& edge, const Vector2<Scalar>& n,
                   const Vector2<Scalar>& at) {
  const Vector2<Scalar> tangent(n.y(), -n.x());
  const Scalar run = tangent.dot(edge.points[1] - edge.points[0]);
  return run == 0 ? 0 : tangent.dot(at - edge.points[0]) / run;
}

template <class Scalar>
Vector2<Scalar> place_on(const Supports<Scalar>& edge, Scalar share) {
  return edge.points[0] + (edge.points[1] - edge.points[0]) * share;
}

/// _generate_contacts_edge_edge.
template <class Scalar>
std::vector<PointPair<Scalar>> of_edges(const Supports<Scalar>& a, const Supports<Scalar>& b,
                                        const Vector2<Scalar>& n, const Mends& mends) {
  struct End {
    Scalar at;
    bool is_of_a;
    std::size_t index;
  };
  const Vector2<Scalar> tangent(n.y(), -n.x());
  std::array ends{End{tangent.dot(a.points[0]), true, 0}, End{tangent.dot(a.points[1]), true, 1},
                  End{tangent.dot(b.points[0]), false, 0}, End{tangent.dot(b.points[1]), false, 1}};
  std::ranges::stable_sort(ends, {}, &End::at);
  const auto on_plane = [&](const Supports<Scalar>& edge, const Vector2<Scalar>& at) {
    if (mends.has(FaultOfGodot::first_ends)) return place_on(edge, share_along(edge, n, at));
    return Vector2<Scalar>(at - n * (n.dot(at) - n.dot(edge.points[0])));
  };
  std::vector<PointPair<Scalar>> pairs;
  for (const End& end : {ends[1], ends[2]}) {
    const Vector2<Scalar> at = (end.is_of_a ? a : b).points[end.index];
    const Vector2<Scalar> opposite = on_plane(end.is_of_a ? b : a, at);
    const auto pair =
        end.is_of_a ? PointPair<Scalar>{at, opposite} : PointPair<Scalar>{opposite, at};
    const double gap = static_cast<double>(n.dot(pair.second)) - kCmpEpsilon;
    if (static_cast<double>(n.dot(pair.first)) > gap) continue;
    pairs.push_back(pair);
  }
  return pairs;
}

/// Geometry::get_closest_point_to_segment_uncapped_2d.
template <class Scalar>
Vector2<Scalar> on_edge(const Vector2<Scalar>& point, const Supports<Scalar>& edge,
                        const Vector2<Scalar>& n, const Mends& mends) {
  const Vector2<Scalar> along = edge.points[1] - edge.points[0];
  const Scalar square = along.dot(along);
  const double least = mends.has(FaultOfGodot::short_edge) ? 0 : 1e-20;
  if (square == 0 || static_cast<double>(square) < least) return edge.points[0];
  if (mends.has(FaultOfGodot::uncapped_foot)) {
    return place_on(edge, std::clamp(share_along(edge, n, point), Scalar(0), Scalar(1)));
  }
  return place_on(edge, along.dot(point - edge.points[0]) / square);
}

/// _generate_contacts_from_supports: of two points and their overlap, of a point and an edge, of
/// two edges.
template <class Scalar>
std::vector<PointPair<Scalar>> pairs_of(const Supports<Scalar>& a, const Supports<Scalar>& b,
                                        const Vector2<Scalar>& n, const Mends& mends) {
  if (a.count == 2 && b.count == 2) return of_edges(a, b, n, mends);
  if (a.count == 2) return {{on_edge(b.points[0], a, n, mends), b.points[0]}};
  if (b.count == 2) return {{a.points[0], on_edge(a.points[0], b, n, mends)}};
  return {{a.points[0], b.points[0]}};
}

/// relay.py, of pairs on A and on B.
replayed::Contact contact_of(const std::vector<PointPair<double>>& pairs) {
  replayed::Contact contact;
  double most = -1;
  for (const PointPair<double>& pair : pairs) {
    const Vector2<double> apart = pair.first - pair.second;
    if (apart.isZero(0)) continue;
    contact.points.push_back({pair.first, 0});
    const double depth = std::hypot(apart.x(), apart.y());
    const Vector2<double> normal = apart / depth;
    const bool is_last = depth == most && std::pair(normal.x(), normal.y()) >
                                              std::pair(contact.normal.x(), contact.normal.y());
    if (!(depth > most || is_last)) continue;
    most = depth;
    contact.normal = normal;
  }
  for (replayed::Contact::Point& point : contact.points) point.depth = most;
  return contact;
}

/// generate_contacts, in an order of shapes that Godot or the case has.
template <class Scalar>
replayed::Contact contact_at(const Shape& a, const Shape& b, const Vector2<float>& axis,
                             const Mends& mends, bool is_swapped) {
  const auto on_a = a.template supports<Scalar>(-axis);
  const auto on_b = b.template supports<Scalar>(axis);
  if (on_a.count == 0 || on_b.count == 0) return {};
  std::vector<PointPair<double>> pairs;
  for (const auto& pair : pairs_of<Scalar>(on_a, on_b, axis.cast<Scalar>(), mends)) {
    pairs.push_back({pair.first.template cast<double>(), pair.second.template cast<double>()});
    if (is_swapped) std::swap(pairs.back().first, pairs.back().second);
  }
  return contact_of(pairs);
}

}  // namespace

GodotAnswer by_godot(const PairCase& pair, const Mends& mends,
                     const std::optional<Vector2<double>>& axis) {
  const Shape of_a(pair.a, mends, mends.edges[0]);
  const Shape of_b(pair.b, mends, mends.edges[1]);
  const bool is_swapped = of_a.type() > of_b.type();
  const Shape& a = is_swapped ? of_b : of_a;
  const Shape& b = is_swapped ? of_a : of_b;
  BestAxis best;
  if (mends.has(FaultOfGodot::start_values)) best.depth = std::numeric_limits<float>::infinity();
  for (const Vector2<float>& tested : axes_of(a, b, mends)) {
    if (!test_axis(a, b, tested, best) && !axis) return {};
  }
  GodotAnswer answer;
  if (axis) best.axis = (is_swapped ? *axis : Vector2<double>(-*axis)).cast<float>();
  if (best.axis.isZero(0)) return answer;
  const Vector2<float> from_a = is_swapped ? best.axis : Vector2<float>(-best.axis);
  answer.axis = from_a.cast<double>();
  answer.depth = static_cast<double>(best.depth);
  answer.edges = {of_a.edges_met(from_a), of_b.edges_met(-from_a)};
  answer.is_without_support =
      a.supports<float>(-best.axis).count == 0 || b.supports<float>(best.axis).count == 0;
  const auto contact =
      mends.has(FaultOfGodot::rounded_ends) ? contact_at<double> : contact_at<float>;
  answer.contact = contact(a, b, best.axis, mends, is_swapped);
  return answer;
}

}  // namespace manifuzz::as_godot
