#include "geometry/convex_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz {
namespace {

/// A sum of doubles kept exactly, as terms that do not overlap and grow in magnitude.
struct Expansion {
  std::array<double, 12> terms{};
  int count = 0;

  /// Shewchuk's GROW-EXPANSION.
  void add(double value) {
    double carry = value;
    for (int i = 0; i < count; ++i) {
      const double sum = carry + terms[i];
      const double from_term = sum - carry;
      terms[i] = (carry - (sum - from_term)) + (terms[i] - from_term);
      carry = sum;
    }
    terms[count++] = carry;
  }

  void add_product(double x, double y) {
    const double product = x * y;
    add(product);
    add(std::fma(x, y, -product));
  }

  int sign() const {
    for (int i = count - 1; i >= 0; --i) {
      if (terms[i] != 0) return terms[i] > 0 ? 1 : -1;
    }
    return 0;
  }
};

int sign_by_expansion(const Vector2<double>& a, const Vector2<double>& b,
                      const Vector2<double>& c) {
  Expansion area;
  area.add_product(a.x(), b.y());
  area.add_product(-a.x(), c.y());
  area.add_product(b.x(), c.y());
  area.add_product(-b.x(), a.y());
  area.add_product(c.x(), a.y());
  area.add_product(-c.x(), b.y());
  return area.sign();
}

/// The area that two differences of points span: positive where the second turns left.
struct Area {
  double value = 0;
  double error = 0;  ///< at most: Shewchuk's ccwerrboundA
};

Area area_of(const Vector2<double>& p, const Vector2<double>& q) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const double left = p.x() * q.y();
  const double right = p.y() * q.x();
  return {left - right, (3 + 16 * u) * u * (std::abs(left) + std::abs(right))};
}

}  // namespace

int orientation(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c) {
  const Area area = area_of(a - c, b - c);
  if (std::abs(area.value) > area.error) return area.value > 0 ? 1 : -1;
  return sign_by_expansion(a, b, c);
}

namespace {

template <class Scalar>
using Vertices = std::span<const Vector2<Scalar>>;

/// Vertex i, counted round; i is below twice the count.
template <class Scalar>
const Vector2<Scalar>& cyclic(Vertices<Scalar> v, std::size_t i) {
  return v[i < v.size() ? i : i - v.size()];
}

template <class Scalar>
bool all_finite(Vertices<Scalar> v) {
  return std::all_of(v.begin(), v.end(),
                     [](const auto& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); });
}

template <class Scalar>
bool has_repeated_vertex(Vertices<Scalar> v) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t j = i + 1; j < v.size(); ++j) {
      if (v[i] == v[j]) return true;
    }
  }
  return false;
}

/// How a closed chain of edges turns.
struct Turns {
  bool are_plainly_left =
      true;        ///< every one, by more than rounding; never next to what is not finite
  int rounds = 0;  ///< of a chain of left turns
};

/// A closed chain of left turns goes round as often as its edges start to climb: none of the turns
/// is wide enough to pass over all the climbing directions. Without branches, which no processor
/// could foretell here.
template <class Scalar>
Turns turns_of(Vertices<Scalar> v) {
  Turns turns;
  Vector2<double> from = v.back().template cast<double>();
  Vector2<double> before = from - v[v.size() - 2].template cast<double>();
  for (const Vector2<Scalar>& vertex : v) {
    const Vector2<double> to = vertex.template cast<double>();
    const Vector2<double> after = to - from;
    const Area area = area_of(before, after);
    turns.are_plainly_left &= area.value > area.error;
    turns.rounds += static_cast<int>(after.y() > 0) & static_cast<int>(!(before.y() > 0));
    before = after;
    from = to;
  }
  return turns;
}

template <class Scalar>
std::optional<PolygonDefect> defect_of(Vertices<Scalar> v) {
  if (v.size() < kMinVertices) return PolygonDefect::too_few;
  if (v.size() > kMaxVertices) return PolygonDefect::too_many;
  const Turns turns = turns_of(v);
  const bool winds_once = turns.rounds == 1;
  if (winds_once && turns.are_plainly_left) return std::nullopt;
  if (!all_finite(v)) return PolygonDefect::not_finite;
  std::size_t left = 0;
  std::size_t right = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const int turn = orientation(v[i], cyclic(v, i + 1), cyclic(v, i + 2));
    if (turn > 0) ++left;
    if (turn < 0) ++right;
  }
  if (left == v.size() && winds_once) return std::nullopt;
  if (has_repeated_vertex(v)) return PolygonDefect::repeated_vertex;
  if (right == v.size()) return PolygonDefect::clockwise;
  if (left < v.size()) return PolygonDefect::not_strictly_convex;
  return PolygonDefect::winds_twice;
}

}  // namespace

std::optional<PolygonDefect> find_defect(std::span<const Vector2<float>> vertices) {
  return defect_of<float>(vertices);
}

std::optional<PolygonDefect> find_defect_in_doubles(std::span<const Vector2<double>> vertices) {
  return defect_of<double>(vertices);
}

std::optional<PolygonDefect> find_shape_defect(std::span<const Vector2<float>> vertices,
                                               float radius) {
  if (vertices.empty()) return PolygonDefect::too_few;
  if (vertices.size() >= kMinVertices) {
    if (const auto defect = find_defect(vertices)) return defect;
  } else {
    if (!all_finite(vertices)) return PolygonDefect::not_finite;
    if (has_repeated_vertex(vertices)) return PolygonDefect::repeated_vertex;
  }
  if (!(radius >= 0) || std::isinf(radius)) return PolygonDefect::radius_not_a_length;
  if (vertices.size() == 1 && !(radius > 0)) return PolygonDefect::no_radius;
  return std::nullopt;
}

std::variant<ConvexPolygon<float>, PolygonDefect> checked_polygon(
    std::span<const Vector2<float>> vertices, float radius, Rounding rounding) {
  if (const auto defect = find_shape_defect(vertices, radius)) return *defect;
  return make_polygon<float>(vertices, radius, rounding);
}

std::string_view describe(PolygonDefect defect) {
  switch (defect) {
    case PolygonDefect::too_few:
      return "too few vertices: a polygon has 3 to 8, a capsule 2, a circle 1";
    case PolygonDefect::too_many:
      return "too many vertices: a polygon has 3 to 8";
    case PolygonDefect::not_finite:
      return "a coordinate is not finite as a float: its magnitude must be below 3.4e38";
    case PolygonDefect::repeated_vertex:
      return "a vertex is repeated: all vertices must differ as floats";
    case PolygonDefect::clockwise:
      return "the vertices run clockwise: list them counter-clockwise";
    case PolygonDefect::not_strictly_convex:
      return "not strictly convex as floats: every corner must turn left";
    case PolygonDefect::winds_twice:
      return "the vertices go round more than once: the outline must not cross itself";
    case PolygonDefect::no_radius:
      return "one vertex without a radius: a circle's is above 0 as a float, 1e-45 or more";
    case PolygonDefect::radius_not_a_length:
      return "the radius is not a length: 0 or more is expected, and finite as a float";
  }
  return {};
}

double size(const ConvexPolygon<float>& polygon) {
  const double around = polygon.is_round() ? 2 * static_cast<double>(polygon.radius) : 0;
  return diameter(polygon) + around;
}

double reach(const ConvexPolygon<float>& polygon) {
  double squared = 0;
  for (const auto& vertex : polygon.corners()) {
    const Vector2<double> v = vertex.cast<double>();
    squared = std::max(squared, v.dot(v));
  }
  return std::sqrt(squared);
}

}  // namespace manifuzz
