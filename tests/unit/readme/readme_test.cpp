// The C++ of README.md, compiled as it stands there and run.

#include <vector>

#include <catch2/catch.hpp>

#include "cases/corpus.hpp"
#include "geometry/collider.hpp"
#include "readme_1.inc"

namespace manifuzz {
namespace {

/// The depths that the library's snippet finds between two boxes of side 2.
std::vector<float> depths_of_boxes(const Pose<float>& pose_a, const Pose<float>& pose_b) {
  std::vector<float> depths;
  const auto complain = [&](std::string_view) { return depths; };
  const auto use = [&](const auto&, const auto&, float depth) { depths.push_back(depth); };
#include "readme_2.inc"
  return depths;
}

TEST_CASE("the library's snippet finds both depths of two boxes a quarter into each other") {
  const Pose<float> pose_a;
  const Pose<float> pose_b{{1.75F, 0.5F}, {1, 0}};
  CHECK(depths_of_boxes(pose_a, pose_b) == std::vector<float>{0.25F, 0.25F});
}

TEST_CASE("the adapter's plain article gives no contact for two triangles that overlap by 100") {
  const Collider mine = make_mine();
  CHECK(mine.declaration.name == "mine");
  const Vector2<float> a[] = {{100, 0}, {0, 0.001F}, {-200, 0}};
  const Vector2<float> b[] = {{-0.2F, -100}, {0, 0}, {-1, 200}};
  const PairCase pair{{make_polygon<float>(a), {}}, {make_polygon<float>(b), {}}};
  CHECK(std::get<Manifold<double>>(mine.collide(pair)).count == 0);
}

}  // namespace
}  // namespace manifuzz
