#include "canary/company.hpp"

#include <algorithm>
#include <limits>

#include "clipping/collide.hpp"
#include "generating/regime.hpp"

namespace manifuzz::canary {
namespace {

/// Whether the chosen features' clip misses the overlap: what is found is the deepest contact.
bool takes_deepest_contact(const PairCase& pair) {
  const ConvexPolygon<float>& a = pair.a.polygon;
  const auto b = transform(relative_pose(pair.a.pose, pair.b.pose), pair.b.polygon);
  const auto manifold = clipping::collide_in_frame(a, b);
  if (manifold.count == 0) return false;
  constexpr float no_limit = std::numeric_limits<float>::infinity();
  const auto of_a = clipping::greatest_separation(a, b, no_limit);
  const auto of_b = clipping::greatest_separation(b, a, no_limit);
  const clipping::ContactFeatures features =
      of_b.separation > of_a.separation
          ? clipping::ContactFeatures{Side::b, of_b.face,
                                      clipping::incident_edge(a, b.normals[of_b.face])}
          : clipping::ContactFeatures{Side::a, of_a.face,
                                      clipping::incident_edge(b, a.normals[of_a.face])};
  return manifold != clipping::clip_features(a, b, features);
}

/// The first cases of each regime.
template <class Scalar>
std::vector<Placed<Scalar>> placed_cases(std::span<const Regime> regimes, std::uint64_t count) {
  std::vector<Placed<Scalar>> placed;
  for (std::uint64_t i = 0; i < count; ++i) {
    for (const Regime& regime : regimes) {
      placed.push_back(clipping::placed_pair<Scalar>(generate(2, regime, i)));
    }
  }
  return placed;
}

template <class Scalar>
const std::vector<Placed<Scalar>>& placed_companions() {
  static const std::vector<Placed<Scalar>> all = [] {
    std::vector<Placed<Scalar>> placed;
    for (const PairCase& pair : companions()) placed.push_back(clipping::placed_pair<Scalar>(pair));
    return placed;
  }();
  return all;
}

template <class Scalar>
std::vector<Placed<Scalar>> round_companions(std::uint64_t number, const Placed<Scalar>& pair) {
  static const std::vector<Placed<Scalar>> all = placed_cases<Scalar>(round_regimes(), 4);
  std::vector<Placed<Scalar>> others{pair};
  if (number % 3 == 0) return others;
  const auto are_circles = [](const Placed<Scalar>& of) {
    return std::pair(of.a.count == 1, of.b.count == 1);
  };
  std::ranges::copy_if(all, std::back_inserter(others), [&](const Placed<Scalar>& other) {
    return number % 3 == 1 || are_circles(other) == are_circles(pair);
  });
  return others;
}

}  // namespace

const std::vector<PairCase>& companions() {
  static const std::vector<PairCase> all = [] {
    std::vector<PairCase> made;
    for (const Regime& regime : polygon_regimes()) made.push_back(generate(2, regime, 0));
    const Regime& regime = *find_regime("near_collinear");
    std::uint64_t index = 0;
    while (!takes_deepest_contact(generate(2, regime, index))) ++index;
    made.push_back(generate(2, regime, index));
    return made;
  }();
  return all;
}

template <class Scalar>
std::vector<Placed<Scalar>> company(std::uint64_t number, const Placed<Scalar>& pair) {
  const std::vector<Placed<Scalar>> others =
      are_round(pair.a, pair.b) ? round_companions(number, pair) : placed_companions<Scalar>();
  const std::size_t size = number % 1000 == 999 ? 4200 : 23;
  std::vector<Placed<Scalar>> all;
  for (std::size_t i = 0; i < size; ++i) all.push_back(others[i % others.size()]);
  for (const std::size_t i : {std::size_t{0}, size / 2, size - 1}) all[i] = pair;
  return all;
}

template std::vector<Placed<float>> company(std::uint64_t, const Placed<float>&);
template std::vector<Placed<double>> company(std::uint64_t, const Placed<double>&);

}  // namespace manifuzz::canary
