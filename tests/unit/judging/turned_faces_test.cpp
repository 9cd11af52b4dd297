#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "clipping/collide.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"
#include "own_colliders/own_colliders.hpp"

// Right colliders that take faces' normals from world vertices, as small engines do, and wrong ones
// that say so.

using namespace manifuzz;

namespace {

/// The polygon with its vertices rounded in the world, its normals taken from these; none where
/// rounding leaves no polygon.
template <class Scalar>
std::optional<ConvexPolygon<Scalar>> in_world(const Body& body) {
  std::vector<Vector2<Scalar>> vertices;
  Pose<Scalar> pose{body.pose.position.cast<Scalar>(), body.pose.rotation.cast<Scalar>()};
  Scalar scale = 1;
  if constexpr (std::is_same_v<Scalar, double>) {  // the matrix as it is, not quite unit
    scale = pose.rotation.norm();
    pose.rotation /= scale;
  }
  for (int i = 0; i < body.polygon.count; ++i) {
    vertices.push_back(
        transform<Scalar>(pose, scale * body.polygon.vertices[i].template cast<Scalar>()));
  }
  std::vector<Vector2<double>> exactly;
  for (const auto& vertex : vertices) exactly.push_back(vertex.template cast<double>());
  if (find_defect_in_doubles(exactly)) return std::nullopt;
  return make_polygon<Scalar>(vertices, static_cast<Scalar>(body.polygon.radius));
}

/// SAT and the article's clipping on these.
template <class Scalar>
Answer small_engine(const PairCase& pair) {
  const auto a = in_world<Scalar>(pair.a);
  const auto b = in_world<Scalar>(pair.b);
  if (!a || !b) return Unsupported{"no polygon is left in the world"};
  const Manifold<Scalar> in_scalar = clipping::collide_in_frame(*a, *b);
  Manifold<double> manifold;
  manifold.count = in_scalar.count;
  manifold.reference = in_scalar.reference;
  if (manifold.count == 0) return manifold;
  manifold.normal = local_normal(pair, in_scalar.normal.template cast<double>());
  for (int i = 0; i < manifold.count; ++i) {
    const auto& point = in_scalar.points[i];
    manifold.points[i] = {to_local(pair.a.pose, point.position.template cast<double>()),
                          static_cast<double>(point.depth), point.features};
  }
  return manifold;
}

template <class Scalar>
Collider small_collider(NormalsFrom normals) {
  constexpr bool is_float = std::is_same_v<Scalar, float>;
  Collider collider;
  collider.declaration = {.name = "small",
                          .version = "1",
                          .description = "a small engine",
                          .scalar = is_float ? ScalarType::float32 : ScalarType::float64,
                          .frame = RoundingFrame::world,
                          .normals = normals};
  collider.collide = small_engine<Scalar>;
  return collider;
}

/// How many of so many cases of each regime of polygons the collider is wrong on.
int wrong_of(const Collider& collider, std::uint64_t seed, std::uint64_t cases) {
  int wrong = 0;
  for (const Regime& regime : regimes()) {
    if (regime.is_round || regime.name == "corpus") continue;
    for (std::uint64_t i = 0; i < cases; ++i) {
      const PairCase pair = generate(seed, regime, i, {});
      const Answer answer = collider.collide(pair);
      if (std::holds_alternative<Unsupported>(answer)) continue;
      const ColliderAnswer given{collider.declaration, answer};
      const Judgement judgement = judge(pair, given, given);
      if (judgement.bucket.fault == Fault::none) continue;
      ++wrong;
      UNSCOPED_INFO(regime.name << " " << i << " " << to_string(judgement.bucket) << " "
                                << judgement.magnitude << " of " << judgement.bound);
    }
  }
  return wrong;
}

constexpr std::uint64_t kCases = 2000;

}  // namespace

TEST_CASE("normals of world vertices are right where they are declared, in float and double") {
  CHECK(wrong_of(small_collider<float>(NormalsFrom::world_vertices), 20, kCases) == 0);
  CHECK(wrong_of(small_collider<double>(NormalsFrom::world_vertices), 21, kCases) == 0);
}

TEST_CASE("normals of world vertices are wrong where they are not declared") {
  CHECK(wrong_of(small_collider<float>(NormalsFrom::given), 20, kCases / 10) > 0);
  CHECK(wrong_of(small_collider<double>(NormalsFrom::given), 21, kCases / 10) > 0);
}

TEST_CASE("the declaration excuses no error that world vertices do not make") {
  // Depths a hundredth too large, of pairs whose faces are long.
  const Collider right = small_collider<double>(NormalsFrom::world_vertices);
  const Regime* const boxes = manifuzz::find_by_name(regimes(), "boxes");
  REQUIRE(boxes != nullptr);
  int touching = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const PairCase pair = generate(3, *boxes, i, {});
    Answer answer = right.collide(pair);
    auto& manifold = std::get<Manifold<double>>(answer);
    if (manifold.count == 0) continue;
    ++touching;
    for (int k = 0; k < manifold.count; ++k) manifold.points[k].depth += 0.01 * size(pair);
    const ColliderAnswer given{right.declaration, answer};
    REQUIRE(judge(pair, given, given).bucket.fault == Fault::both);
  }
  CHECK(touching > 50);
}

TEST_CASE("where rounding decides which end of a short core is nearer, each may be taken for it") {
  // A circle of radius 200, and a capsule of radius 40 whose ends are 0.016 apart.
  PairCase pair;
  pair.a.polygon = make_polygon<float>(std::vector<Vector2<float>>{{0, 0}}, 200);
  pair.b.polygon = make_polygon<float>(
      std::vector<Vector2<float>>{{0.005239F, 0.008645F}, {-0.0087F, 0.01593F}}, 40);
  pair.b.pose.position = {-106.7F, -204.2F};
  const Declaration of_floats = make_clip().declaration;
  const auto towards = [&](int end) {
    const Vector2<double> at =
        pair.b.polygon.vertices[end].cast<double>() + pair.b.pose.position.cast<double>();
    Manifold<double> manifold;
    manifold.count = 1;
    manifold.normal = at.normalized();
    manifold.points[0].position = 200 * manifold.normal;
    manifold.points[0].depth = 240 - at.norm();
    return manifold;
  };
  const auto fault_of = [&](const Manifold<double>& manifold) {
    const Answer answer = manifold;
    return judge(pair, {of_floats, answer}, {of_floats, answer}).bucket.fault;
  };
  CHECK(fault_of(towards(0)) == Fault::none);
  CHECK(fault_of(towards(1)) == Fault::none);
  Manifold<double> beside = towards(0);
  beside.normal = (beside.normal + Vector2<double>(1e-3, 0)).normalized();
  beside.points[0].position = 200 * beside.normal;
  CHECK(fault_of(beside) == Fault::both);
}
