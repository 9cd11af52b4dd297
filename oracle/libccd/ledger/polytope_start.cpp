#include <algorithm>

#include "oracle/libccd/ledger/polytope.hpp"

// libccd, ccd.c: simplexToPolytope2 to simplexToPolytope4.

namespace manifuzz::ledger_of {
namespace {

/// ccd_points_on_sphere: the first of them. No two corners of a difference are its farthest along
/// the first one and all of the five around it.
constexpr std::array kPointsOnSphere{std::array{0.0, -0.0, -1.0},
                                     std::array{0.723608, -0.525725, -0.447219},
                                     std::array{-0.276388, -0.850649, -0.447219},
                                     std::array{-0.894426, -0.0, -0.447216},
                                     std::array{-0.276388, 0.850649, -0.447220},
                                     std::array{0.723608, 0.525725, -0.447219}};

}  // namespace

bool CcdPolytope::make_of_two(const CcdSimplex& simplex) {
  const CcdVector& a = simplex.corners[0];
  const CcdVector& b = simplex.corners[1];
  const auto is_new = [&](const CcdVector& corner) {
    return !ccd_equal(a, corner) && !ccd_equal(b, corner);
  };
  std::array<CcdVector, 4> around{};
  const auto find_around = [&] {
    for (const auto& [x, y, z] : kPointsOnSphere) {
      around[0] = prisms_->support({x, y, z});
      if (is_new(around[0])) break;
    }
    if (!is_new(around[0])) return false;
    around[1] = prisms_->support(around[0] * -1.0);
    if (!is_new(around[1])) return false;
    const CcdVector dir = ccd_cross<double>(around[0] - a, around[1] - a);
    around[2] = prisms_->support(dir);
    if (!is_new(around[2])) return false;
    around[3] = prisms_->support(dir * -1.0);
    return is_new(around[3]);
  };
  if (!find_around()) {
    CcdElement* const from = add_vertex(a);
    nearest_ = add_edge(from, add_vertex(b));
    return false;
  }
  first_ = {{a, b, around[0], around[2]},
            {a, b, around[2], around[1]},
            {a, b, around[1], around[3]},
            {a, b, around[3], around[0]}};
  std::array<CcdElement*, 6> v{};
  const std::array places{a, around[0], b, around[1], around[2], around[3]};
  std::ranges::transform(places, v.begin(), [&](const CcdVector& at) { return add_vertex(at); });
  std::array<CcdElement*, 12> e{};
  for (std::size_t i = 0; i < 4; ++i) e[i] = add_edge(v[i], v[(i + 1) % 4]);
  for (std::size_t i = 4; i < 12; ++i) e[i] = add_edge(v[i / 4 + 3], v[i % 4]);
  for (const std::size_t tip : {4, 8}) {
    for (std::size_t i = 0; i < 4; ++i) add_face(e[tip + i], e[tip + (i + 1) % 4], e[i]);
  }
  return true;
}

bool CcdPolytope::make_of_three(const CcdSimplex& simplex) {
  const auto& [a, b, c, unused] = simplex.corners;
  const CcdVector dir = ccd_cross<double>(b - a, c - a);
  const std::array tips{prisms_->support(dir), prisms_->support(dir * -1.0)};
  const auto is_flat = [&](const CcdVector& tip) {
    return ccd_is_zero(nearest_of_triangle<double>(tip, a, b, c, false).square);
  };
  const std::array base{add_vertex(a), add_vertex(b), add_vertex(c)};
  const bool is_touching = std::ranges::any_of(tips, is_flat);
  first_ = {{a, b, c, tips[0]}, {a, b, c, tips[1]}};
  std::vector<CcdElement*> corners;
  if (!is_touching) corners = {add_vertex(tips[0]), add_vertex(tips[1])};
  const std::array around{add_edge(base[0], base[1]), add_edge(base[1], base[2]),
                          add_edge(base[2], base[0])};
  if (is_touching) {
    add_face(around[0], around[1], around[2]);
    nearest_ = store_.back().type == 3 ? &store_.back() : nullptr;
    return false;
  }
  std::vector<std::array<CcdElement*, 3>> sides;
  for (CcdElement* const tip : corners) {
    sides.push_back({add_edge(tip, base[0]), add_edge(tip, base[1]), add_edge(tip, base[2])});
  }
  for (const auto& side : sides) {
    for (std::size_t i = 0; i < 3; ++i) add_face(side[i], side[(i + 1) % 3], around[i]);
  }
  return true;
}

bool CcdPolytope::make_of_four(CcdSimplex simplex) {
  auto& ps = simplex.corners;
  const auto is_on = [&](std::size_t i, std::size_t j, std::size_t k) {
    return ccd_is_zero(
        nearest_of_triangle<double>(CcdVector::Zero(), ps[i], ps[j], ps[k], false).square);
  };
  // As there, what is set is what is looked at next.
  bool is_on_face = is_on(0, 1, 2);
  if (is_on(0, 2, 3)) is_on_face = true, ps[1] = ps[2], ps[2] = ps[3];
  if (is_on(0, 1, 3)) is_on_face = true, ps[2] = ps[3];
  if (is_on(1, 2, 3)) is_on_face = true, ps[0] = ps[1], ps[1] = ps[2], ps[2] = ps[3];
  if (is_on_face) return make_of_three(simplex);
  first_ = {ps};
  std::array<CcdElement*, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) v[i] = add_vertex(ps[i]);
  const std::array e{add_edge(v[0], v[1]), add_edge(v[1], v[2]), add_edge(v[2], v[0]),
                     add_edge(v[3], v[0]), add_edge(v[3], v[1]), add_edge(v[3], v[2])};
  add_face(e[0], e[1], e[2]);
  add_face(e[3], e[4], e[0]);
  add_face(e[4], e[5], e[1]);
  add_face(e[5], e[3], e[2]);
  return true;
}

}  // namespace manifuzz::ledger_of
