#include "oracle/dyn4j/detectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/vector.hpp"

namespace manifuzz::as_dyn4j {
namespace {

constexpr int kGjkIterations = 30;   // Gjk.DEFAULT_MAX_ITERATIONS
constexpr int kEpaIterations = 100;  // Epa.DEFAULT_MAX_ITERATIONS

Found by_circles(const Placed& a, const Placed& b) {
  Vector2<double> between = b.centre() - a.centre();
  const double radii = a.radius() + b.radius();
  if (!(between.x() * between.x() + between.y() * between.y() < radii * radii)) return {};
  const double depth = radii - normalize(between);
  return {true, between, depth, End::circles};
}

bool is_zero(const Vector2<double>& v) {
  return std::abs(v.x()) <= kEpsilon && std::abs(v.y()) <= kEpsilon;
}

/// MinkowskiSum.getSupportPoint.
Vector2<double> support(const Placed& a, const Placed& b, Vector2<double>& along) {
  const Vector2<double> first = a.farthest_point(along);
  along = -along;
  const Vector2<double> second = b.farthest_point(along);
  along = -along;
  return first - second;
}

/// Vector2.tripleProduct.
Vector2<double> triple_product(const Vector2<double>& p, const Vector2<double>& q,
                               const Vector2<double>& r) {
  const double turn = cross<double>(p, q);
  return {-r.y() * turn, r.x() * turn};
}

/// Gjk.checkSimplex: whether the origin is inside; else the next direction.
bool check_simplex(std::vector<Vector2<double>>& simplex, Vector2<double>& along,
                   double square_of_zero) {
  const Vector2<double> a = simplex.back();
  const Vector2<double> to_origin = -a;
  if (simplex.size() < 3) {
    const Vector2<double> ab = simplex[0] - a;
    // The triple product of ab, ao and ab.
    along = triple_product(ab, to_origin, ab);
    if (along.x() * along.x() + along.y() * along.y() <= square_of_zero) along = {ab.y(), -ab.x()};
    return false;
  }
  const Vector2<double> ab = simplex[1] - a;
  const Vector2<double> ac = simplex[0] - a;
  const double turn = ab.x() * ac.y() - ac.x() * ab.y();
  const Vector2<double> beyond_c(-ac.y() * turn, ac.x() * turn);
  if (beyond_c.dot(to_origin) >= 0) {
    simplex.erase(simplex.begin() + 1);
    along = beyond_c;
    return false;
  }
  const Vector2<double> beyond_b(ab.y() * turn, -ab.x() * turn);
  if (beyond_b.dot(to_origin) < 0) return true;
  simplex.erase(simplex.begin());
  along = beyond_b;
  return false;
}

/// Gjk.detect; the simplex has the origin inside where they touch.
bool finds_origin(const Placed& a, const Placed& b, double square_of_zero,
                  std::vector<Vector2<double>>& simplex) {
  Vector2<double> along = b.centre() - a.centre();
  if (is_zero(along)) along = {1, 0};
  simplex.push_back(support(a, b, along));
  if (simplex[0].dot(along) <= 0) return false;
  along = -along;
  for (int i = 0; i < kGjkIterations; ++i) {
    simplex.push_back(support(a, b, along));
    if (simplex.back().dot(along) <= 0) return false;
    if (check_simplex(simplex, along, square_of_zero)) return true;
  }
  return false;
}

/// ExpandingSimplexEdge.
struct SimplexEdge {
  Vector2<double> from;
  Vector2<double> to;
  Vector2<double> normal;
  double distance;

  SimplexEdge(const Vector2<double>& p, const Vector2<double>& q, bool is_clockwise)
      : from(p), to(q) {
    const Vector2<double> along = q - p;
    normal = is_clockwise ? Vector2<double>(-along.y(), along.x())
                          : Vector2<double>(along.y(), -along.x());
    normalize(normal);
    distance = std::abs(p.x() * normal.x() + p.y() * normal.y());
  }
};

/// java.util.PriorityQueue, which decides between equal edges.
class EdgeQueue {
 public:
  SimplexEdge& front() { return edges_.front(); }

  void push(const SimplexEdge& edge) {
    edges_.push_back(edge);
    std::size_t at = edges_.size() - 1;
    while (at > 0) {
      const std::size_t parent = (at - 1) / 2;
      if (!(edge.distance < edges_[parent].distance)) break;
      edges_[at] = edges_[parent];
      at = parent;
    }
    edges_[at] = edge;
  }

  SimplexEdge pop() {
    const SimplexEdge first = edges_.front();
    const SimplexEdge last = edges_.back();
    edges_.pop_back();
    std::size_t at = 0;
    while (at < edges_.size() / 2) {
      std::size_t child = 2 * at + 1;
      if (child + 1 < edges_.size() && edges_[child].distance > edges_[child + 1].distance) ++child;
      if (!(last.distance > edges_[child].distance)) break;
      edges_[at] = edges_[child];
      at = child;
    }
    if (!edges_.empty()) edges_[at] = last;
    return first;
  }

 private:
  std::vector<SimplexEdge> edges_;
};

/// ExpandingSimplex.getSimplexWinding.
bool is_clockwise(const std::vector<Vector2<double>>& simplex) {
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    const double turn = cross<double>(simplex[i], simplex[(i + 1) % simplex.size()]);
    if (turn != 0) return turn < 0;
  }
  return false;
}

/// Epa.getPenetration.
Found by_epa(const Placed& a, const Placed& b, const std::vector<Vector2<double>>& simplex) {
  const double distance_epsilon = std::sqrt(kEpsilon);  // Epa.DEFAULT_DISTANCE_EPSILON
  const bool clockwise = is_clockwise(simplex);
  EdgeQueue queue;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    queue.push(SimplexEdge(simplex[i], simplex[(i + 1) % simplex.size()], clockwise));
  }
  Found found{true, {0, 0}, 0, End::iterations};
  for (int i = 0; i < kEpaIterations; ++i) {
    SimplexEdge& edge = queue.front();
    const Vector2<double> point = support(a, b, edge.normal);
    found.depth = point.dot(edge.normal);
    found.normal = edge.normal;
    if (found.depth - edge.distance < distance_epsilon) {
      found.end = End::epsilon;
      return found;
    }
    const SimplexEdge split = queue.pop();
    queue.push(SimplexEdge(split.from, point, clockwise));
    queue.push(SimplexEdge(point, split.to, clockwise));
  }
  return found;
}

/// An axis, and how far both overlap along it; none where they do not.
std::optional<double> overlap_along(const Placed& a, const Placed& b, Vector2<double>& axis) {
  const Range of_a = a.project(axis);
  const Range of_b = b.project(axis);
  if (!of_a.overlaps(of_b)) return std::nullopt;
  double overlap = std::min(of_a.max, of_b.max) - std::max(of_a.min, of_b.min);
  if (of_a.contains(of_b) || of_b.contains(of_a)) {
    const double most = std::abs(of_a.max - of_b.max);
    const double least = std::abs(of_a.min - of_b.min);
    if (most > least) axis = -axis;
    overlap += std::min(most, least);
  }
  return overlap;
}

}  // namespace

std::vector<Found> overlaps_along_axes(const Placed& a, const Placed& b) {
  std::vector<Vector2<double>> axes = a.axes(b.foci());
  const std::vector<Vector2<double>> of_b = b.axes(a.foci());
  axes.insert(axes.end(), of_b.begin(), of_b.end());
  const Vector2<double> between = b.centre() - a.centre();
  std::vector<Found> all;
  for (Vector2<double>& axis : axes) {
    if (is_zero(axis)) continue;
    const auto overlap = overlap_along(a, b, axis);
    if (!overlap) return {};
    if (between.dot(axis) < 0) axis = -axis;
    all.push_back({true, axis, *overlap, End::axes});
  }
  return all;
}

Found by_axes(const Placed& a, const Placed& b) {
  if (a.is_circle() && b.is_circle()) return by_circles(a, b);
  const std::vector<Found> all = overlaps_along_axes(a, b);
  const auto least = std::ranges::min_element(all, {}, &Found::depth);
  return least == all.end() ? Found{} : *least;
}

Found by_gjk(const Placed& a, const Placed& b, double square_of_zero) {
  if (a.is_circle() && b.is_circle()) return by_circles(a, b);
  std::vector<Vector2<double>> simplex;
  if (!finds_origin(a, b, square_of_zero, simplex)) return {};
  return by_epa(a, b, simplex);
}

}  // namespace manifuzz::as_dyn4j
