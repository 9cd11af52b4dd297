#include "oracle/bullet/ledger/gjk.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace manifuzz::ledger_of {
namespace {

/// GJK_MIN_DISTANCE, GJK_ACCURACY and GJK_DUPLICATED_EPS.
constexpr float kGjkEpsilon = 0.0001F;

/// What projectorigin finds: a squared distance, below zero where there is none and no number where
/// squares overflow, and of which corners it is.
struct Projection {
  float square = -1;
  std::array<float, 4> weights{};
  unsigned mask = 0;
};

Projection project(const Space& a, const Space& b) {
  const Space d = b - a;
  const float l = squared(d);
  if (!(l > 0)) return {};
  const float t = -dot(a, d) / l;
  if (t >= 1) return {squared(b), {0, 1}, 2};
  if (t <= 0) return {squared(a), {1, 0}, 1};
  return {squared(Space(a + d * t)), {1 - t, t}, 3};
}

Projection project(const Space& a, const Space& b, const Space& c) {
  const std::array corners{&a, &b, &c};
  const std::array<Space, 3> edges{a - b, b - c, c - a};
  const Space n = cross(edges[0], edges[1]);
  const float l = squared(n);
  if (!(l > 0)) return {};
  Projection best;
  for (unsigned i = 0; i < 3; ++i) {
    if (!(dot(*corners[i], cross(edges[i], n)) > 0)) continue;
    const unsigned j = (i + 1) % 3;
    const Projection of_edge = project(*corners[i], *corners[j]);
    if (!(best.square < 0) && !(of_edge.square < best.square)) continue;
    best.square = of_edge.square;
    best.mask = ((of_edge.mask & 1) != 0 ? 1U << i : 0) + ((of_edge.mask & 2) != 0 ? 1U << j : 0);
    best.weights[i] = of_edge.weights[0];
    best.weights[j] = of_edge.weights[1];
    best.weights[(j + 1) % 3] = 0;
  }
  if (!(best.square < 0)) return best;
  const float root = std::sqrt(l);
  const Space p = n * (dot(a, n) / l);
  const float of_a = std::sqrt(squared(cross(edges[1], Space(b - p)))) / root;
  const float of_b = std::sqrt(squared(cross(edges[2], Space(c - p)))) / root;
  return {squared(p), {of_a, of_b, 1 - (of_a + of_b)}, 7};
}

Projection project(const Space& a, const Space& b, const Space& c, const Space& d) {
  const std::array corners{&a, &b, &c};
  const std::array<Space, 3> edges{a - d, b - d, c - d};
  const float volume = EpaGjk::determinant(edges[0], edges[1], edges[2]);
  const bool is_turned = volume * dot(a, cross(Space(b - c), Space(a - b))) <= 0;
  if (!is_turned || !(std::abs(volume) > 0)) return {};
  Projection best;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned j = (i + 1) % 3;
    if (!(volume * dot(d, cross(edges[i], edges[j])) > 0)) continue;
    const Projection of_face = project(*corners[i], *corners[j], d);
    if (!(best.square < 0) && !(of_face.square < best.square)) continue;
    best.square = of_face.square;
    best.mask = ((of_face.mask & 1) != 0 ? 1U << i : 0) + ((of_face.mask & 2) != 0 ? 1U << j : 0) +
                ((of_face.mask & 4) != 0 ? 8U : 0);
    best.weights[i] = of_face.weights[0];
    best.weights[j] = of_face.weights[1];
    best.weights[(j + 1) % 3] = 0;
    best.weights[3] = of_face.weights[2];
  }
  if (!(best.square < 0)) return best;
  const std::array<float, 3> w{EpaGjk::determinant(c, b, d) / volume,
                               EpaGjk::determinant(a, c, d) / volume,
                               EpaGjk::determinant(b, a, d) / volume};
  return {0, {w[0], w[1], w[2], 1 - (w[0] + w[1] + w[2])}, 15};
}

Projection project(const EpaGjk::Simplex& simplex) {
  const auto& c = simplex.c;
  if (simplex.rank == 2) return project(c[0].w, c[1].w);
  if (simplex.rank == 3) return project(c[0].w, c[1].w, c[2].w);
  if (simplex.rank == 4) return project(c[0].w, c[1].w, c[2].w, c[3].w);
  return {0};
}

}  // namespace

EpaDifference::EpaDifference(const BulletPair& pair, bool is_round)
    : a_(&pair.a), b_(&pair.b), is_round_(is_round) {
  const BulletPlace& a = pair.place_a;
  const BulletPlace& b = pair.place_b;
  to_a_ = {times(transposed(a.basis), b.basis), a.to_local(Space(b.origin - a.origin))};
  to_b_ = {times(transposed(b.basis), a.basis)};
}

Space EpaDifference::support_b(const Space& along) const {
  return to_a_.to_world(support(*b_, to_b_.to_world(along)));
}

float EpaGjk::determinant(const Space& a, const Space& b, const Space& c) {
  return a.y() * b.z() * c.x() + a.z() * b.x() * c.y() - a.x() * b.z() * c.y() -
         a.y() * b.x() * c.z() + a.x() * b.y() * c.z() - a.z() * b.y() * c.x();
}

EpaCorner EpaGjk::corner_along(const Space& along) const {
  const Space d = over(along, std::sqrt(squared(along)));
  return {d, difference_->support(d)};
}

void EpaGjk::append(const Space& along) {
  simplex.p[simplex.rank] = 0;
  simplex.c[simplex.rank++] = corner_along(along);
}

bool EpaGjk::reduce(Space& ray, Status& status) {
  const Projection found = project(simplex);
  if (!(found.square >= 0)) return false;
  const Simplex before = simplex;
  simplex.rank = 0;
  ray.setZero();
  for (int i = 0; i < before.rank; ++i) {
    if ((found.mask & (1U << i)) == 0) continue;
    simplex.c[simplex.rank] = before.c[i];
    simplex.p[simplex.rank++] = found.weights[i];
    ray += before.c[i].w * found.weights[i];
  }
  if (found.mask == 15) status = Status::inside;
  return true;
}

EpaGjk::Status EpaGjk::evaluate(const Space& guess) {
  constexpr int iterations_max = 128;
  simplex = {};
  append(squared(guess) > 0 ? Space(-guess) : Space(1, 0, 0));
  simplex.p[0] = 1;
  Space ray = simplex.c[0].w;
  std::array<Space, 4> last{ray, ray, ray, ray};
  unsigned last_at = 0;
  float alpha = 0;
  Status status = Status::valid;
  for (int i = 0; status == Status::valid;) {
    const float length = std::sqrt(squared(ray));
    is_near = length < kGjkEpsilon;
    if (is_near) return Status::inside;
    append(Space(-ray));
    const Space w = simplex.c[simplex.rank - 1].w;
    const bool is_known = std::ranges::any_of(
        last, [&](const Space& one) { return squared(Space(w - one)) < kGjkEpsilon; });
    if (!is_known) {
      last_at = (last_at + 1) & 3;
      last[last_at] = w;
      alpha = std::max(alpha, dot(ray, w) / length);
    }
    if (is_known || (length - alpha) - kGjkEpsilon * length <= 0 || !reduce(ray, status)) {
      --simplex.rank;
      return status;
    }
    if (++i >= iterations_max) status = Status::failed;
  }
  return status;
}

bool EpaGjk::is_enclosed_with(const Space& along) {
  append(along);
  if (enclose_origin()) return true;
  --simplex.rank;
  return false;
}

bool EpaGjk::enclose_origin() {
  const auto& c = simplex.c;
  if (simplex.rank == 4) {
    return std::abs(determinant(c[0].w - c[3].w, c[1].w - c[3].w, c[2].w - c[3].w)) > 0;
  }
  if (simplex.rank == 3) {
    const Space n = cross(Space(c[1].w - c[0].w), Space(c[2].w - c[0].w));
    return squared(n) > 0 && (is_enclosed_with(n) || is_enclosed_with(Space(-n)));
  }
  for (int i = 0; i < 3; ++i) {
    const Space axis = Space::Unit(i);
    const Space along = simplex.rank == 2 ? cross(Space(c[1].w - c[0].w), axis) : axis;
    if (!(squared(along) > 0)) continue;
    if (is_enclosed_with(along) || is_enclosed_with(Space(-along))) return true;
  }
  return false;
}

}  // namespace manifuzz::ledger_of
