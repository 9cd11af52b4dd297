#include "oracle/bullet/ledger/voronoi_simplex.hpp"

#include <algorithm>
#include <limits>

namespace manifuzz::ledger_of {
namespace {

/// Whether the origin and d are on opposite sides of a, b and c; -1 where d is in their plane.
int outside_of_plane(const Space& a, const Space& b, const Space& c, const Space& d) {
  const Space normal = cross(Space(b - a), Space(c - a));
  const float sign_of_origin = dot(Space(-a), normal);
  const float sign_of_d = dot(Space(d - a), normal);
  if (sign_of_d * sign_of_d < 1e-4F * 1e-4F) return -1;
  return sign_of_origin * sign_of_d < 0 ? 1 : 0;
}

}  // namespace

bool VoronoiSimplex::Weights::is_valid() const {
  return std::ranges::all_of(of, [](float weight) { return weight >= 0; });
}

bool VoronoiSimplex::holds(const Space& w) const {
  const auto end = corners_.begin() + count_;
  const auto is_near = [&](const DifferenceCorner& corner) {
    return squared(Space(w - corner.w)) <= 0.0001F;
  };
  return std::any_of(corners_.begin(), end, is_near) || w == last_;
}

bool VoronoiSimplex::holds_another(const Space& w) const {
  const auto end = corners_.begin() + count_;
  const auto is_it = [&](const DifferenceCorner& corner) { return corner.w == w; };
  return holds(w) && w != last_ && std::none_of(corners_.begin(), end, is_it);
}

VoronoiSimplex::Weights VoronoiSimplex::of_segment() const {
  Weights weights;
  const Space& from = corners_[0].w;
  const Space along = corners_[1].w - from;
  float t = dot(along, Space(-from));
  if (t <= 0) {
    t = 0;
    weights.used[0] = true;
  } else if (const float square = squared(along); t < square) {
    t /= square;
    weights.used[0] = weights.used[1] = true;
  } else {
    t = 1;
    weights.used[1] = true;
  }
  weights.of = {1 - t, t, 0, 0};
  return weights;
}

VoronoiSimplex::Weights VoronoiSimplex::of_triangle(const Space& a, const Space& b, const Space& c,
                                                    Space* place) {
  const Space ab = b - a;
  const Space ac = c - a;
  const float d1 = dot(ab, Space(-a));
  const float d2 = dot(ac, Space(-a));
  if (d1 <= 0 && d2 <= 0) return *place = a, Weights{{1, 0, 0, 0}, {true}};
  const float d3 = dot(ab, Space(-b));
  const float d4 = dot(ac, Space(-b));
  if (d3 >= 0 && d4 <= d3) return *place = b, Weights{{0, 1, 0, 0}, {false, true}};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const float v = d1 / (d1 - d3);
    return *place = a + v * ab, Weights{{1 - v, v, 0, 0}, {true, true}};
  }
  const float d5 = dot(ab, Space(-c));
  const float d6 = dot(ac, Space(-c));
  if (d6 >= 0 && d5 <= d6) return *place = c, Weights{{0, 0, 1, 0}, {false, false, true}};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const float w = d2 / (d2 - d6);
    return *place = a + w * ac, Weights{{1 - w, 0, w, 0}, {true, false, true}};
  }
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return *place = b + w * (c - b), Weights{{0, 1 - w, w, 0}, {false, true, true}};
  }
  const float share = 1.0F / (va + vb + vc);
  const float v = vb * share;
  const float w = vc * share;
  *place = a + ab * v + ac * w;
  return {{1 - v - w, v, w, 0}, {true, true, true}};
}

bool VoronoiSimplex::find_tetrahedron(Weights& weights) {
  // The corners of each face, and the one that is off it.
  constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
  std::array<int, 4> is_outside{};
  for (int i = 0; i < 4; ++i) {
    const auto& [a, b, c, d] = faces[i];
    is_outside[i] = outside_of_plane(corners_[a].w, corners_[b].w, corners_[c].w, corners_[d].w);
  }
  is_degenerate_ = std::ranges::min(is_outside) < 0;
  if (is_degenerate_ || std::ranges::max(is_outside) == 0) return false;
  float nearest = std::numeric_limits<float>::max();
  for (int i = 0; i < 4; ++i) {
    if (is_outside[i] == 0) continue;
    const auto& face = faces[i];
    Space place;
    const Weights found =
        of_triangle(corners_[face[0]].w, corners_[face[1]].w, corners_[face[2]].w, &place);
    if (!(squared(place) < nearest)) continue;
    nearest = squared(place);
    weights = {};
    for (int k = 0; k < 3; ++k) {
      weights.of[face[k]] = found.of[k];
      weights.used[face[k]] = found.used[k];
    }
  }
  return true;
}

void VoronoiSimplex::make_closest(const Weights& weights) {
  const auto& of = weights.of;
  const auto sum = [&](Space DifferenceCorner::*side) {
    if (count_ == 2) {
      return Space(corners_[0].*side + of[1] * (corners_[1].*side - corners_[0].*side));
    }
    Space all = corners_[0].*side * of[0];
    for (int i = 1; i < count_; ++i) all += corners_[i].*side * of[i];
    return all;
  };
  closest_.on_a = sum(&DifferenceCorner::on_a);
  closest_.on_b = sum(&DifferenceCorner::on_b);
  closest_.w = closest_.on_a - closest_.on_b;
}

void VoronoiSimplex::reduce(const Weights& weights) {
  for (int i = std::min(count_, 4) - 1; i >= 0; --i) {
    if (!weights.used[i]) corners_[i] = corners_[--count_];
  }
}

bool VoronoiSimplex::add(const DifferenceCorner& corner) {
  last_ = corner.w;
  corners_[count_++] = corner;
  if (count_ == 1) {
    closest_ = corner;
    closest_.w = corner.on_a - corner.on_b;
    return true;
  }
  Weights weights;
  Space place;
  if (count_ == 2) weights = of_segment();
  if (count_ == 3) weights = of_triangle(corners_[0].w, corners_[1].w, corners_[2].w, &place);
  if (count_ == 4 && !find_tetrahedron(weights)) {
    if (!is_degenerate_) closest_.w.setZero();
    return !is_degenerate_;
  }
  if (count_ > 4) return false;
  make_closest(weights);
  reduce(weights);
  return weights.is_valid();
}

}  // namespace manifuzz::ledger_of
