#include "judging/ledger/separating_axes/godot_solver.hpp"

#include <algorithm>
#include <cmath>
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
std::vector<Vector2<float>> axes_of(const Shape& a, const Shape& b) {
  using Type = Shape::Type;
  std::vector<Vector2<float>> axes;
  const auto append = [&](const std::vector<Vector2<float>>& some) {
    axes.insert(axes.end(), some.begin(), some.end());
  };
  const auto corners_a = a.corners();
  const auto corners_b = b.corners();
  const auto between = [&](std::size_t i, std::size_t j) {
    axes.push_back(normalized(corners_a[i] - corners_b[j]));
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
struct PointPair {
  Vector2<float> first;
  Vector2<float> second;
};

/// The place of an edge's line on the line through a point along the normal.
Vector2<float> along_edge(const Supports& edge, const Vector2<float>& n, const Vector2<float>& at) {
  const Vector2<float> tangent = tangent_of(n);
  const Vector2<float> along = edge.points[1] - edge.points[0];
  const float run = tangent.dot(along);
  if (run == 0) return edge.points[0];
  return edge.points[0] + along * (tangent.dot(at - edge.points[0]) / run);
}

/// _generate_contacts_edge_edge.
std::vector<PointPair> of_edges(const Supports& a, const Supports& b, const Vector2<float>& n,
                                const Mends& mends) {
  struct End {
    float at;
    bool is_of_a;
    std::size_t index;
  };
  std::vector<End> ends;
  for (std::size_t i = 0; i < 2; ++i) ends.push_back({tangent_of(n).dot(a.points[i]), true, i});
  for (std::size_t i = 0; i < 2; ++i) ends.push_back({tangent_of(n).dot(b.points[i]), false, i});
  std::ranges::stable_sort(ends, {}, &End::at);
  const auto on_plane = [&](const Supports& edge, const Vector2<float>& at) {
    if (mends.is_along_edges) return along_edge(edge, n, at);
    return Vector2<float>(at - n * (n.dot(at) - n.dot(edge.points[0])));
  };
  std::vector<PointPair> pairs;
  for (const End& end : {ends[1], ends[2]}) {
    const Vector2<float> at = (end.is_of_a ? a : b).points[end.index];
    const Vector2<float> opposite = on_plane(end.is_of_a ? b : a, at);
    const PointPair pair = end.is_of_a ? PointPair{at, opposite} : PointPair{opposite, at};
    const double gap = static_cast<double>(n.dot(pair.second)) - kCmpEpsilon;
    if (static_cast<double>(n.dot(pair.first)) > gap) continue;
    pairs.push_back(pair);
  }
  return pairs;
}

/// Geometry::get_closest_point_to_segment_uncapped_2d.
Vector2<float> closest_uncapped(const Vector2<float>& point, const Supports& edge) {
  const Vector2<float> n = edge.points[1] - edge.points[0];
  const float square = n.dot(n);
  if (square < 1e-20F) return edge.points[0];
  return edge.points[0] + n * (n.dot(point - edge.points[0]) / square);
}

/// _generate_contacts_from_supports: of two points and their overlap, of a point and an edge, of
/// two edges.
std::vector<PointPair> pairs_of(const Supports& a, const Supports& b, const Vector2<float>& n,
                                const Mends& mends) {
  if (a.count == 2 && b.count == 2) return of_edges(a, b, n, mends);
  if (a.count == 2) return {{closest_uncapped(b.points[0], a), b.points[0]}};
  if (b.count == 2) return {{a.points[0], closest_uncapped(a.points[0], b)}};
  return {{a.points[0], b.points[0]}};
}

/// relay.py, of pairs on A and on B.
replayed::Contact contact_of(const std::vector<PointPair>& pairs) {
  replayed::Contact contact;
  double most = -1;
  for (const PointPair& pair : pairs) {
    const Vector2<double> on_a = pair.first.cast<double>();
    const Vector2<double> apart = on_a - pair.second.cast<double>();
    if (apart.isZero(0)) continue;
    contact.points.push_back({on_a, 0});
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

}  // namespace

GodotAnswer by_godot(const PairCase& pair, const Mends& mends,
                     const std::optional<Vector2<double>>& axis) {
  const Shape of_a(pair.a);
  const Shape of_b(pair.b);
  const bool is_swapped = of_a.type() > of_b.type();
  const Shape& a = is_swapped ? of_b : of_a;
  const Shape& b = is_swapped ? of_a : of_b;
  BestAxis best;
  for (const Vector2<float>& tested : axes_of(a, b)) {
    if (!test_axis(a, b, tested, best) && !axis) return {};
  }
  GodotAnswer answer;
  if (axis) best.axis = (is_swapped ? *axis : Vector2<double>(-*axis)).cast<float>();
  if (best.axis.isZero(0)) return answer;
  answer.axis = (is_swapped ? best.axis : Vector2<float>(-best.axis)).cast<double>();
  answer.depth = static_cast<double>(best.depth);
  const Supports on_a = a.supports(-best.axis, mends);
  const Supports on_b = b.supports(best.axis, mends);
  if (on_a.count == 0 || on_b.count == 0) return answer;
  auto pairs = pairs_of(on_a, on_b, best.axis, mends);
  if (is_swapped) {
    for (PointPair& one : pairs) std::swap(one.first, one.second);
  }
  answer.contact = contact_of(pairs);
  return answer;
}

}  // namespace manifuzz::as_godot
