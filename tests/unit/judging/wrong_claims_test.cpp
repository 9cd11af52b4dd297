#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "mistakes.hpp"
#include "support/named_tests.hpp"
#include "support/used_shapes_of.hpp"

namespace manifuzz::mistakes {
namespace {

void catch_all(const Mistake& mistake) {
  const Declaration declaration = mistake.declared();
  int made = 0;
  for_overlapping(regimes(), mistake.radius, [&](const Right& right) {
    const Given answer = mistake.wrong(right, declaration);
    if (!answer) return;
    ++made;
    const Kind kind = judge_by_curve(*right.truth, declaration, *answer).kind;
    INFO("called " << kKindNames[static_cast<std::size_t>(kind)]);
    const bool are_apart = right.curve.are_cores_apart() && !mistake.kinds_apart.empty();
    REQUIRE(std::ranges::count(are_apart ? mistake.kinds_apart : mistake.kinds, kind) == 1);
  });
  CHECK(made > 20);
}

[[maybe_unused]] const bool mistakes_registered = [] {
  for (const auto& mistakes : {of_separations(), of_points()}) {
    for (const Mistake& mistake : mistakes) {
      test::add_test("caught in an answer that claims less: " + std::string(mistake.name),
                     "[claims]", [mistake] { catch_all(mistake); });
    }
  }
  return true;
}();

const Declaration in_float = [] {
  Declaration declaration = of(Claims::separation);
  declaration.scalar = ScalarType::float32;
  return declaration;
}();

Kind kind_of(const PairCase& pair, const Declaration& declaration, const Answer& answer) {
  const Collider oracle = make_clip64();
  const Answer right = oracle.collide(pair);
  return judge(pair, {declaration, answer}, {oracle.declaration, right}).bucket.kind;
}

/// A manifold of these shapes.
Answer with_shapes(const Manifold<double>& manifold, const UsedShapes& used) {
  PartialManifold answer{.manifold = manifold, .used = used};
  return answer;
}

}  // namespace

TEST_CASE("shapes that are not the case's are a finding, and excuse no other") {
  const Declaration plain = make_clip64().declaration;
  Declaration altering = plain;
  altering.alters_shapes = true;
  int dropped = 0;
  for_overlapping(polygon_regimes(), 0.0F, [&](const Right& right) {
    const PairCase& pair = right.pair();
    const UsedShapes same = test::used_shapes_of(pair);
    REQUIRE(kind_of(pair, plain, with_shapes(right.manifold, same)) == Kind::none);

    UsedShapes moved = same;
    const double bound = alteration_bound(pair.a, ScalarType::float64);
    moved.a.all[0].x() += kClearly * bound;
    if (!find_defect_in_doubles(moved.a.corners())) {
      const auto altered = altered_by(*right.truth, {plain, with_shapes(right.manifold, moved)});
      REQUIRE(altered.has_value());
      if (altered->is_beyond_rounding) {
        REQUIRE(kind_of(pair, plain, with_shapes(right.manifold, moved)) != Kind::none);
      }
    }

    if (pair.b.polygon.count == kMinVertices) return;
    PairCase less = pair;
    less.b.polygon = make_polygon<float>(pair.b.polygon.corners().subspan(1), 0.0F);
    const Right of_less(less);
    const UsedShapes used = test::used_shapes_of(less);
    const Answer answer = with_shapes(of_less.manifold, used);
    REQUIRE(kind_of(pair, plain, answer) == Kind::altered_shape);
    REQUIRE(kind_of(pair, altering, answer) == Kind::none);
    ++dropped;
    if (of_less.manifold.count == 0 || !of_less.overlaps(in_float)) return;
    Manifold<double> reversed = of_less.manifold;
    reversed.normal = -reversed.normal;
    for (const Declaration& declaration : {plain, altering}) {
      REQUIRE(kind_of(pair, declaration, with_shapes(reversed, used)) == Kind::reversed);
    }
  });
  CHECK(dropped > 100);
}

TEST_CASE("shapes that are no polygons are a finding, without a verdict on the manifold") {
  for_overlapping(polygon_regimes(), 0.0F, [](const Right& right) {
    UsedShapes edge = test::used_shapes_of(right.pair());
    edge.a.count = 2;
    REQUIRE(kind_of(right.pair(), make_clip64().declaration, with_shapes({}, edge)) ==
            Kind::altered_shape);
  });
}

TEST_CASE("a positive distance is no depth") {
  int apart = 0;
  for (const Regime& regime : polygon_regimes()) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Right right(generate(53, regime, i, {.corpus = {}, .radius = 0}));
      if (!right.is_clear(right.depth, in_float) || right.depth > 0) continue;
      ++apart;
      for (const Declaration& declaration :
           {of(Claims::separation), in_float, of(Claims::touching)}) {
        const Kind kind =
            judge_by_curve(*right.truth, declaration, right.along(right.normal, -right.depth)).kind;
        REQUIRE(kind == Kind::phantom_contact);
      }
      Declaration speculating = of(Claims::separation);
      speculating.speculative = 2 * std::abs(right.depth);
      const Penetration distance{.touches = true, .normal = right.normal, .depth = right.depth};
      REQUIRE(judge_by_curve(*right.truth, speculating, distance).kind == Kind::none);
      const Penetration wrong{.touches = true, .normal = right.normal, .depth = -right.depth};
      REQUIRE(judge_by_curve(*right.truth, speculating, wrong).kind == Kind::inconsistent);
    }
  }
  CHECK(apart > 200);
}

}  // namespace manifuzz::mistakes
