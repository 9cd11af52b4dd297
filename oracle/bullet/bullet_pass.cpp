#include "oracle/bullet/bullet_pass.hpp"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>
#include <deque>
#include <memory>

#include "external/external_collider.hpp"
#include "oracle/bullet/pair_detector.hpp"
#include "oracle/bullet/perturbed.hpp"

namespace manifuzz {
namespace {

using namespace manifuzz_bullet;

struct PreparedPrisms {
  PreparedPrisms(const manifuzz_body& body_a, const manifuzz_body& body_b)
      : a(hull_of(body_a, half_heights(body_a, body_b).a)),
        b(hull_of(body_b, half_heights(body_a, body_b).b)),
        place_a(place_of(body_a)),
        place_b(place_of(body_b)) {}

  btConvexHullShape a;
  btConvexHullShape b;
  btTransform place_a;
  btTransform place_b;
  btPointCollector found{};
};

/// A pair's prisms as bodies of a world.
struct PreparedObjects {
  PreparedObjects(const manifuzz_body& body_a, const manifuzz_body& body_b)
      : prisms(body_a, body_b), objects(prisms.a, prisms.place_a, prisms.b, prisms.place_b) {}
  PreparedObjects(const PreparedObjects&) = delete;
  PreparedObjects& operator=(const PreparedObjects&) = delete;

  PreparedPrisms prisms;
  CollisionObjects objects;
  std::size_t found = 0;
};

template <class Solver>
std::function<void()> pass_with(std::span<const PairCase> pairs) {
  const auto all = std::make_shared<std::deque<PreparedPrisms>>();
  for (const PairCase& pair : pairs) all->emplace_back(c_body(pair.a), c_body(pair.b));
  return [all] {
    Solver solver;
    for (PreparedPrisms& pair : *all) {
      pair.found = closest_points(pair.a, pair.place_a, pair.b, pair.place_b, solver);
    }
  };
}

}  // namespace

std::function<void()> bullet_epa_pass(std::span<const PairCase> pairs) {
  return pass_with<btGjkEpaPenetrationDepthSolver>(pairs);
}

std::function<void()> bullet_minkowski_pass(std::span<const PairCase> pairs) {
  return pass_with<btMinkowskiPenetrationDepthSolver>(pairs);
}

std::function<void()> bullet_perturbed_pass(std::span<const PairCase> pairs) {
  const auto all = std::make_shared<std::deque<PreparedObjects>>();
  for (const PairCase& pair : pairs) all->emplace_back(c_body(pair.a), c_body(pair.b));
  return [all] {
    for (PreparedObjects& pair : *all) pair.found = perturbed_points(pair.objects).size();
  };
}

}  // namespace manifuzz
