#include "afresh/afresh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <catch2/catch.hpp>

#include "afresh/boxes.hpp"
#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"
#include "kernel/batch.hpp"
#include "unit/scene/motion.hpp"

using namespace manifuzz;

namespace {

/// Bodies of two to the power of up to `octaves`, as often of each size, in a square `across` wide.
struct Crowd {
  std::vector<ConvexPolygon<float>> shapes;
  std::vector<kernel::Placement<float>> bodies;

  Crowd(std::uint64_t seed, int count, int octaves, double across) {
    Random random = test::motion(seed);
    for (int i = 0; i < count; ++i) {
      const double scale = std::ldexp(1.0, random.integer(0, octaves));
      const auto polygon = rounded(stretched(random_outline(random), scale, scale), 0.01F);
      if (!polygon) continue;
      const int kind = random.integer(0, 5);  // a circle, a capsule, round corners; else sharp
      const auto corners = kind < 2 ? polygon->corners().first(1 + kind) : polygon->corners();
      const float radius = kind < 2 ? 0.3F * static_cast<float>(scale) : 0.01F;
      const auto shape =
          kind < 3 ? make_polygon<float>(corners, radius, Rounding::round) : *polygon;
      const Vector2<double> at(random.uniform(0, across), random.uniform(0, across));
      bodies.push_back({static_cast<std::uint32_t>(shapes.size()),
                        {at.cast<float>(), random_direction(random).cast<float>()}});
      shapes.push_back(shape);
    }
  }
};

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Every pair of bodies collided: those that touch, and whether each is there with the same bits.
void check_all_pairs(const Crowd& crowd) {
  scene::Afresh afresh;
  kernel::Shapes<float> shapes;
  for (const auto& shape : crowd.shapes) {
    REQUIRE(std::holds_alternative<std::uint32_t>(afresh.add_shape(shape)));
    shapes.add(shape);
  }
  std::vector<kernel::BodyPair> pairs;
  for (std::uint32_t a = 0; a < crowd.bodies.size(); ++a) {
    for (std::uint32_t b = a + 1; b < crowd.bodies.size(); ++b) pairs.push_back({a, b});
  }
  std::vector<Manifold<float>> right(pairs.size());
  kernel::collide_pairs(shapes, crowd.bodies, pairs, 0, right);
  const auto touching = afresh.collide(crowd.bodies);
  Pairs found;
  std::size_t expected = 0;
  std::size_t same = 0;
  std::size_t at = 0;
  std::vector<std::size_t> place(crowd.bodies.size() * crowd.bodies.size());
  for (const auto& [a, b] : pairs) place[a * crowd.bodies.size() + b] = at++;
  for (const auto& manifold : right) expected += manifold.count > 0 ? 1 : 0;
  for (const scene::Touching& contact : touching) {
    const auto [a, b] = contact.bodies;
    REQUIRE(a < b);
    CHECK(found.insert({a, b}).second);
    same += same_bits(right[place[a * crowd.bodies.size() + b]], contact.manifold) ? 1 : 0;
  }
  CHECK(same == expected);
  CHECK(touching.size() == expected);
}

/// A crowd's boxes, filed.
struct Filed {
  std::vector<std::uint32_t> bodies;
  std::vector<scene::Box> boxes;
  scene::Cells cells;

  explicit Filed(const Crowd& crowd) : bodies(crowd.bodies.size()), boxes(crowd.bodies.size()) {
    scene::ShapeTable shapes(0);
    for (const auto& shape : crowd.shapes) shapes.add(shape);
    std::iota(bodies.begin(), bodies.end(), 0U);
    scene::padded_boxes(shapes, crowd.bodies, bodies, boxes);
    file();
  }

  void file() { cells.file(bodies, boxes, 1); }

  /// Whether the cells find the bodies whose boxes overlap this one's.
  void check_near(std::uint32_t body) {
    std::vector<std::uint32_t> right;
    for (const std::uint32_t other : bodies) {
      if (overlap(boxes[body], boxes[other])) right.push_back(other);
    }
    const std::span<const std::uint32_t> near = cells.near(boxes[body]);
    std::vector<std::uint32_t> found(near.begin(), near.end());
    std::ranges::sort(found);
    CHECK(std::ranges::equal(found, right));
  }
};

}  // namespace

TEST_CASE("all pairs afresh are all pairs, whatever the sizes: one to a thousand times") {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    CAPTURE(seed);
    check_all_pairs(Crowd(seed, 300, 0, 30));
    check_all_pairs(Crowd(seed, 300, 3, 100));
    check_all_pairs(Crowd(seed, 300, 10, 3000));
  }
}

TEST_CASE("all pairs afresh are all pairs, wherever the bodies lie") {
  check_all_pairs(Crowd(1, 1, 0, 1));
  check_all_pairs(Crowd(2, 200, 0, 1));    // on one heap
  check_all_pairs(Crowd(3, 300, 0, 1e6));  // cells that share a place
  Crowd line(4, 300, 1, 40);
  for (auto& body : line.bodies) body.pose.position.y() = 1e-3F * body.pose.position.y();
  check_all_pairs(line);
  for (auto& body : line.bodies) std::swap(body.pose.position.x(), body.pose.position.y());
  check_all_pairs(line);
  Crowd two_places(5, 300, 1, 10);
  for (std::size_t i = 0; i < two_places.bodies.size(); i += 2) {
    two_places.bodies[i].pose.position.x() += 1e12F;
  }
  check_all_pairs(two_places);
}

TEST_CASE("cells know all bodies whose boxes overlap one, of any size") {
  Filed filed(Crowd(7, 400, 6, 200));
  for (const std::uint32_t body : filed.bodies) filed.check_near(body);
}

TEST_CASE("boxes that move and grow are near what they overlap, until there is no room") {
  Filed filed(Crowd(8, 300, 2, 60));
  const std::vector<scene::Box> start = filed.boxes;
  Random random = test::motion(9);
  constexpr int kTogetherMax = 40;
  const auto last = static_cast<int>(filed.bodies.size()) - kTogetherMax;
  int refiled = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto first = static_cast<std::uint32_t>(random.integer(0, last));
    const auto count =
        static_cast<std::uint32_t>(random.chance(0.5) ? 1 : random.integer(1, kTogetherMax));
    const std::vector<scene::Box> before = filed.boxes;
    for (std::uint32_t body = first; body < first + count; ++body) {
      const auto by = static_cast<float>(random.uniform(-3, 3));
      const float larger = random.chance(0.02) ? 100 : 0;  // than all that were filed
      const scene::Box& from = start[body];
      filed.boxes[body] = {from.x_min + by, from.y_min - by, from.x_max + by + larger,
                           from.y_max - by};
    }
    const auto of = [&](std::size_t k) -> scene::Cells::Refiled {
      const std::size_t body = first + k;
      return {static_cast<std::uint32_t>(body), &before[body], &filed.boxes[body]};
    };
    if (filed.cells.refile(count, of)) {
      ++refiled;
    } else {
      filed.file();
    }
    for (std::uint32_t body = first; body < first + count; ++body) filed.check_near(body);
  }
  CHECK(refiled > 500);
}
