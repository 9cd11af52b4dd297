// The collider of src/external/README.md, compiled as it stands there and run; tests/install/
// does so with the library's code.

#include <catch2/catch.hpp>

#include "collider/collider.hpp"
#include "corpus/corpus.hpp"
#include "readme_1.inc"

namespace manifuzz {
namespace {

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
