#include "corpus/plain_cases.hpp"

#include <algorithm>
#include <utility>

#include "corpus/shrink.hpp"

namespace manifuzz {
namespace {

using Corners = std::vector<Vector2<float>>;

constexpr int kGridSide = 4;
constexpr int kGridPoints = kGridSide * kGridSide;

Vector2<float> grid_point(int i) {
  const Vector2<int> place(i % kGridSide - 1, i / kGridSide - 1);
  return place.cast<float>();
}

bool fits_grid(const Vector2<float>& edge) {
  return edge.cwiseAbs().maxCoeff() <= 2;
}

/// Every triangle with corners on the grid {-1, 0, 1, 2}^2 and no wider or higher than 2.
std::vector<Corners> plain_triangles() {
  std::vector<Corners> triangles;
  for (int i = 0; i < kGridPoints; ++i) {
    for (int j = i + 1; j < kGridPoints; ++j) {
      for (int k = i + 1; k < kGridPoints; ++k) {
        const Corners corners{grid_point(i), grid_point(j), grid_point(k)};
        const bool small = fits_grid(corners[1] - corners[0]) &&
                           fits_grid(corners[2] - corners[1]) && fits_grid(corners[0] - corners[2]);
        if (small && !find_defect(corners)) triangles.push_back(corners);
      }
    }
  }
  return triangles;
}

/// The unit triangle against each of those and each against it, with these radii.
void add_plain_cases(float radius_a, float radius_b, std::vector<PairCase>& made) {
  const auto unit = make_polygon<float>(Corners{{0, 0}, {1, 0}, {0, 1}});
  for (const Corners& corners : plain_triangles()) {
    const auto other = make_polygon<float>(corners);
    for (const bool is_first : {true, false}) {
      PairCase pair{{is_first ? unit : other, {}}, {is_first ? other : unit, {}}};
      pair.a.polygon.radius = radius_a;
      pair.b.polygon.radius = radius_b;
      made.push_back(pair);
    }
  }
}

/// The simplest first, and equals as they stand. A comparison that worked out complexities would
/// take longer than what is then done with the cases.
std::vector<PairCase> sorted(const std::vector<PairCase>& cases) {
  std::vector<std::pair<Complexity, std::size_t>> order;
  for (const PairCase& pair : cases) order.emplace_back(complexity(pair), order.size());
  std::ranges::sort(order);
  std::vector<PairCase> result;
  for (const auto& [unused, i] : order) result.push_back(cases[i]);
  return result;
}

using Shapes = std::vector<ConvexPolygon<float>>;

/// Circles of radius 1, segments, and capsules of radius 1, on that grid.
Shapes plain_round_shapes() {
  Shapes shapes;
  for (int i = 0; i < kGridPoints; ++i) {
    shapes.push_back(make_polygon<float>(Corners{grid_point(i)}, 1.0F));
    for (int j = 0; j < kGridPoints; ++j) {
      if (i == j || !fits_grid(grid_point(j) - grid_point(i))) continue;
      for (const float radius : {0.0F, 1.0F}) {
        shapes.push_back(make_polygon<float>(Corners{grid_point(i), grid_point(j)}, radius));
      }
    }
  }
  return shapes;
}

/// The unit circle, segment, capsule and triangle against each of those, and each against them.
void add_plain_round_cases(std::vector<PairCase>& made) {
  const Shapes units{make_polygon<float>(Corners{{0, 0}}, 1.0F),
                     make_polygon<float>(Corners{{0, 0}, {1, 0}}),
                     make_polygon<float>(Corners{{0, 0}, {1, 0}}, 1.0F),
                     make_polygon<float>(Corners{{0, 0}, {1, 0}, {0, 1}})};
  for (const ConvexPolygon<float>& shape : plain_round_shapes()) {
    for (const ConvexPolygon<float>& unit : units) {
      made.push_back({{unit, {}}, {shape, {}}});
      made.push_back({{shape, {}}, {unit, {}}});
    }
  }
}

/// Plain cases of round pairs, the simplest first.
const std::vector<PairCase>& plain_round_cases() {
  static const std::vector<PairCase> cases = [] {
    std::vector<PairCase> made;
    add_plain_round_cases(made);
    return sorted(made);
  }();
  return cases;
}

/// Plain cases of polygons; where a case has radii, those with some too.
const std::vector<PairCase>& plain_polygon_cases(bool has_radii) {
  static const std::vector<PairCase> without_radii = [] {
    std::vector<PairCase> made;
    add_plain_cases(0, 0, made);
    return sorted(made);
  }();
  static const std::vector<PairCase> with_radii = [] {
    std::vector<PairCase> made = without_radii;
    for (const auto& [radius_a, radius_b] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
      add_plain_cases(static_cast<float>(radius_a), static_cast<float>(radius_b), made);
    }
    return sorted(made);
  }();
  return has_radii ? with_radii : without_radii;
}

}  // namespace

const std::vector<PairCase>& plain_cases(const PairCase& pair) {
  return is_round(pair) ? plain_round_cases() : plain_polygon_cases(total_radius(pair) > 0);
}

}  // namespace manifuzz
