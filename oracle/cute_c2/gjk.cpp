#include "oracle/cute_c2/gjk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace manifuzz::as_cute {
namespace {

constexpr int kIterationsOfCute = 20;  // C2_GJK_ITERS

/// c2sv.
struct SimplexVertex {
  Vector2<float> of_a{0, 0};
  Vector2<float> of_b{0, 0};
  Vector2<float> p{0, 0};
  float u = 1;
  std::size_t index_a = 0;
  std::size_t index_b = 0;
};

/// c2Simplex.
struct Simplex {
  std::array<SimplexVertex, 4> vertices;
  float divisor = 1;
  int count = 1;

  /// The sum of what is asked of the vertices, each times its share.
  template <class Part>
  Vector2<float> weighted(const Part& part) const {
    const float share = 1.0F / divisor;
    if (count == 1) return part(vertices[0]);
    Vector2<float> sum = part(vertices[0]) * (share * vertices[0].u);
    for (int i = 1; i < count; ++i) sum += part(vertices[i]) * (share * vertices[i].u);
    return sum;
  }
  void keep(const SimplexVertex& only) {
    const SimplexVertex kept = only;
    vertices[0] = kept;
    vertices[0].u = 1;
    divisor = 1;
    count = 1;
  }
  void keep(const SimplexVertex& first, const SimplexVertex& second, float u, float v) {
    const SimplexVertex one = first;
    const SimplexVertex two = second;
    vertices[0] = one;
    vertices[1] = two;
    vertices[0].u = u;
    vertices[1].u = v;
    divisor = u + v;
    count = 2;
  }
};

/// c22.
void reduce_two(Simplex& s) {
  const Vector2<float> a = s.vertices[0].p;
  const Vector2<float> b = s.vertices[1].p;
  const float u = b.dot(b - a);
  const float v = a.dot(a - b);
  if (v <= 0) {
    s.keep(s.vertices[0]);
  } else if (u <= 0) {
    s.keep(s.vertices[1]);
  } else {
    s.keep(s.vertices[0], s.vertices[1], u, v);
  }
}

/// c23.
void reduce_three(Simplex& s) {
  auto& [sa, sb, sc, sd] = s.vertices;
  const Vector2<float> a = sa.p;
  const Vector2<float> b = sb.p;
  const Vector2<float> c = sc.p;
  const float u_ab = b.dot(b - a);
  const float v_ab = a.dot(a - b);
  const float u_bc = c.dot(c - b);
  const float v_bc = b.dot(b - c);
  const float u_ca = a.dot(a - c);
  const float v_ca = c.dot(c - a);
  const float area = cross<float>(b - a, c - a);
  const float u_abc = cross<float>(b, c) * area;
  const float v_abc = cross<float>(c, a) * area;
  const float w_abc = cross<float>(a, b) * area;
  if (v_ab <= 0 && u_ca <= 0) {
    s.keep(sa);
  } else if (u_ab <= 0 && v_bc <= 0) {
    s.keep(sb);
  } else if (u_bc <= 0 && v_ca <= 0) {
    s.keep(sc);
  } else if (u_ab > 0 && v_ab > 0 && w_abc <= 0) {
    s.keep(sa, sb, u_ab, v_ab);
  } else if (u_bc > 0 && v_bc > 0 && u_abc <= 0) {
    s.keep(sb, sc, u_bc, v_bc);
  } else if (u_ca > 0 && v_ca > 0 && v_abc <= 0) {
    s.keep(sc, sa, u_ca, v_ca);
  } else {
    sa.u = u_abc;
    sb.u = v_abc;
    sc.u = w_abc;
    s.divisor = u_abc + v_abc + w_abc;
  }
}

/// c2D.
Vector2<float> direction_of(const Simplex& s) {
  const Vector2<float>& a = s.vertices[0].p;
  if (s.count == 1) return -a;
  const Vector2<float> ab = s.vertices[1].p - a;
  return cross<float>(ab, -a) > 0 ? counter_clockwise_quarter(ab) : clockwise_quarter(ab);
}

SimplexVertex vertex_of(const Shape& a, std::size_t i, const Shape& b, std::size_t j) {
  SimplexVertex v{.of_a = a.vertex(i), .of_b = b.vertex(j), .index_a = i, .index_b = j};
  v.p = v.of_b - v.of_a;
  return v;
}

}  // namespace

Shape::Shape(const Body& body) : radius(body.polygon.radius) {
  const bool is_polygon = body.polygon.count > 2;
  if (is_polygon) placing = body.pose;
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<float> vertex = body.polygon.vertices[i];
    vertices.push_back(is_polygon ? vertex : transform(body.pose, vertex));
    if (is_polygon) normals.push_back(body.polygon.normals[i]);
  }
}

std::size_t Shape::support(const Vector2<float>& along) const {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < count(); ++i) {
    if (vertices[i].dot(along) > vertices[farthest].dot(along)) farthest = i;
  }
  return farthest;
}

Nearest nearest_by_cute(const Shape& a, const Shape& b) {
  Simplex s;
  s.vertices[0] = vertex_of(a, 0, b, 0);
  const auto difference = [](const SimplexVertex& v) { return v.p; };
  float last = std::numeric_limits<float>::max();
  bool is_within_epsilon = false;
  for (int i = 0; i < kIterationsOfCute; ++i) {
    std::array<SimplexVertex, 4> before = s.vertices;
    const int count = s.count;
    if (count == 2) reduce_two(s);
    if (count == 3) reduce_three(s);
    if (s.count == 3) break;
    const Vector2<float> p = s.weighted(difference);
    const float square = p.dot(p);
    if (square > last) break;
    last = square;
    const Vector2<float> d = direction_of(s);
    constexpr float kEpsilon = std::numeric_limits<float>::epsilon();
    is_within_epsilon = d.dot(d) < kEpsilon * kEpsilon;
    if (is_within_epsilon) break;
    const std::size_t of_a = a.support(rotate_back<float>(a.placing.rotation, -d));
    const std::size_t of_b = b.support(rotate_back(b.placing.rotation, d));
    s.vertices[s.count] = vertex_of(a, of_a, b, of_b);
    const bool is_known =
        std::any_of(before.begin(), before.begin() + count,
                    [&](const SimplexVertex& v) { return v.index_a == of_a && v.index_b == of_b; });
    if (is_known) break;
    ++s.count;
  }
  Nearest nearest{s.weighted([](const SimplexVertex& v) { return v.of_a; }),
                  s.weighted([](const SimplexVertex& v) { return v.of_b; }), 0};
  if (s.count == 3) return {nearest.on_b, nearest.on_b, 0};
  const Vector2<float> apart = nearest.on_a - nearest.on_b;
  nearest.distance = std::sqrt(apart.dot(apart));
  nearest.is_within_epsilon = is_within_epsilon && s.count == 1;
  return nearest;
}

}  // namespace manifuzz::as_cute
