#include <cstdlib>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "external/campaigns.hpp"
#include "support/run_program.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// Colliders from outside that claim less than a manifold of clips, or more.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// Without radii: a clip may cut off the deepest vertex of skins that meet at their corners.
JobsResult run_without_radii(const Collider& collider) {
  Plan plan = plan_of(collider);
  plan.context.radius = 0.0F;
  return run(plan);
}

}  // namespace

TEST_CASE("a program that claims less than a manifold is judged by what it claims") {
  for (const char* behaviour : {"touching", "separation", "point"}) {
    INFO(behaviour);
    CHECK(is_judged_by_curve(program(behaviour).declaration));
    const JobsResult result = run_without_radii(program(behaviour));
    CHECK(result.tally->cases() == kCases);
    CHECK(result.tally->unexplained() == 0);
  }
}

TEST_CASE("a program is not asked about the pairs that it declines, either way about") {
  const auto declared = [](const std::string& declines) {
    return program_declaration(
               "mine", R"({"declaration": {"vertices_min": 1, "declines": )" + declines + "}}")
        .declaration;
  };
  const std::array<Vector2<float>, 2> ends{Vector2<float>{-1, 0}, Vector2<float>{1, 0}};
  PairCase pair = overlapping_boxes();
  const Declaration declaration = declared(R"([["polygon", "capsule"]])");
  CHECK(takes_shapes(declaration, pair));
  pair.b.polygon = make_polygon<float>(ends, 0.25F);
  CHECK_FALSE(takes_shapes(declaration, pair));
  std::swap(pair.a, pair.b);
  CHECK_FALSE(takes_shapes(declaration, pair));
  pair.b = pair.a;
  CHECK(takes_shapes(declaration, pair));
  CHECK_THROWS_AS(declared(R"([["polygon"]])"), UserError);
  CHECK_THROWS_AS(declared(R"([["polygon", "square"]])"), UserError);
}

TEST_CASE("cases whose polygons are less than a collider declares are drawn again") {
  for (const auto& [least, regime_name] :
       {std::pair(R"({"turn": 0.0263})", "sliver"), std::pair(R"({"area": 1e-8})", "scaled")}) {
    INFO(least);
    Collider collider;
    collider.declaration =
        program_declaration("mine",
                            std::string(R"({"declaration": {"least_polygon": )") + least + "}}")
            .declaration;
    GenerationContext context;
    narrow_to({collider}, context);
    const Regime& regime = *find_regime(regime_name);
    int refused = 0;
    int still_refused = 0;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      refused += takes(collider, generate(1, regime, i)) ? 0 : 1;
      still_refused += takes(collider, generate(1, regime, i, context)) ? 0 : 1;
    }
    CHECK(refused > static_cast<int>(kCases) / 6);
    CHECK(still_refused < refused / 20);
  }
}

TEST_CASE(
    "a library declares its least polygon, against which it is not asked round shapes either") {
  const Told told("choosy");
  const Collider choosy = library();
  CHECK(choosy.declaration.least_polygon.turn == 0.1);
  const std::vector<Vector2<float>> flat{{0, 0}, {20, -0.01F}, {40, 0}};
  const std::vector<Vector2<float>> centre{{20, 0.5F}};
  PairCase pair = overlapping_boxes();
  pair.a.polygon = make_polygon<float>(flat);
  for (int i = 0; i < 2; ++i) {
    CHECK_FALSE(takes(choosy, pair));
    CHECK(std::get<Unsupported>(choosy.collide(pair)).why ==
          "takes no polygon so flat, or so small");
    pair.b.polygon = make_polygon<float>(centre, 1);
  }
}

TEST_CASE("cases with more vertices than a collider takes are drawn again") {
  Collider collider;
  collider.declaration.max_vertices = 4;
  GenerationContext context;
  narrow_to({collider}, context);
  for (std::uint64_t i = 0; i < 200; ++i) {
    CHECK(takes(collider, generate(1, *find_regime("generic"), i, context)));
  }
}

TEST_CASE("a least polygon has three corners that turn, and an area") {
  const LeastPolygon least{.turn = 0.1, .area = 0.5};
  const auto polygon = [](std::vector<Vector2<float>> vertices) {
    return make_polygon<float>(vertices);
  };
  CHECK(has_at_least(polygon({{0, 0}, {1, 0}, {0, 1}}), least));
  CHECK_FALSE(has_at_least(polygon({{0, 0}, {0.99F, 0}, {0, 1}}), least));
  CHECK(has_at_least(polygon({{0, 0}, {20, -0.01F}, {40, 0}, {20, 1}}), {.turn = 0.0009}));
  CHECK_FALSE(has_at_least(polygon({{0, 0}, {20, -0.01F}, {40, 0}, {20, 1}}), {.turn = 0.11}));
  CHECK(has_at_least(polygon({{0, 0}, {20, -2}, {40, 0}, {20, 2}}), least));
  for (const char* wrong :
       {R"({"turn": 2})", R"({"turn": -1})", R"({"area": -1})", R"({"width": 1})"}) {
    INFO(wrong);
    const std::string line = std::string(R"({"declaration": {"least_polygon": )") + wrong + "}}";
    CHECK_THROWS_AS(program_declaration("mine", line), UserError);
  }
}

TEST_CASE("a program whose normals point from B to A is found out, whatever it claims") {
  const JobsResult result = run_without_radii(program("reversed"));
  const std::uint64_t reversed = count_of(result, Kind::reversed);
  CHECK(reversed > kCases / 3);
  CHECK(result.tally->count(Verdict::subject_wrong) == reversed);
}

TEST_CASE("a library that claims less than a manifold is judged by what it claims") {
  for (const char* behaviour : {"touching", "separation", "unclipped"}) {
    INFO(behaviour);
    const Told told(behaviour);
    const Collider collider = library();
    CHECK(is_judged_by_curve(collider.declaration));
    CHECK(run_without_radii(collider).tally->unexplained() == 0);
  }
}

TEST_CASE("a library of interface 1 goes on loading") {
  for (const Collider& early : {collider_in_own_process(MANIFUZZ_TEST_INTERFACE_1, kSecondsMax),
                                collider_in_process(MANIFUZZ_TEST_INTERFACE_1)}) {
    CHECK(early.declaration.name == "early");
    CHECK(early.declaration.tie_bias == TieBias{.absolute = 0.25});
    CHECK(early.declaration.max_vertices == 6);
    CHECK(early.declaration.claims == Claims::manifold);
    CHECK(early.declaration.clips);
    const JobsResult result = run(plan_of(early));
    CHECK(count_of(result, Kind::missed_contact) >= result.tally->unexplained());
    CHECK(result.tally->unexplained() > kCases / 5);
  }
}

TEST_CASE("an answer that contradicts its declaration is malformed") {
  const JobsResult result = run_without_radii(program("two-points"));
  CHECK(result.tally->count(Verdict::malformed) > 0);
  CHECK(result.tally->unexplained() == result.tally->count(Verdict::malformed));
  const Told told("no-shapes");
  for (const Collider& silent : {program("no-shapes"), library()}) {
    CHECK(run(plan_of(silent)).tally->count(Verdict::malformed) >= 20);
  }
}

TEST_CASE("depths that differ contradict one depth for all points") {
  Manifold<double> manifold;
  manifold.count = 2;
  manifold.points[0].depth = 0.5;
  manifold.points[1].depth = 0.25;
  CHECK(contradiction(manifold, {.shares_depth = true}).has_value());
  CHECK_FALSE(contradiction(manifold, {}).has_value());
  manifold.points[1].depth = 0.5;
  CHECK_FALSE(contradiction(manifold, {.shares_depth = true}).has_value());
}

TEST_CASE("a collider that alters shapes is judged by those that it used") {
  CHECK(run_without_radii(program("alters")).tally->unexplained() == 0);
  const JobsResult unsaid = run_without_radii(program("alters-unsaid"));
  CHECK(unsaid.tally->unexplained() > kCases / 3);
  CHECK(count_of(unsaid, Kind::altered_shape) == unsaid.tally->unexplained());
}

TEST_CASE("what is right only by its tolerance is counted apart") {
  const JobsResult result = run_without_radii(program("stops-short"));
  CHECK(result.tally->unexplained() == 0);
  CHECK(result.tally->by_tolerance > kCases / 3);
}

TEST_CASE("what a program may claim is checked") {
  for (const char* declared :
       {R"("claims": "nothing")", R"("points": "vertex")", R"("clips": 3)", R"("depths": "some")",
        R"("speculative": -1)", R"("least_depth": -0.5)", R"("rotation": "quaternion")",
        R"("tie_bias": {"relative": 1})", R"("tie_bias": {"towards": "c"})",
        R"("tolerance": {"relative": 0.1})", R"("tolerance": {"relative": -1, "source": "s"})"}) {
    INFO(declared);
    CHECK_THROWS_AS(collider_of_command(std::string("echo '{\"declaration\": {") + declared + "}}'",
                                        kSecondsMax),
                    UserError);
  }
}

TEST_CASE("what a library may claim is checked") {
  for (const char* behaviour : {"unknown-claim", "unsourced"}) {
    const Told told(behaviour);
    CHECK_THROWS_AS(library(), UserError);
  }
}

TEST_CASE("the minimum translation in JavaScript is right, and judged as such") {
  if (std::system("command -v node > /dev/null") != 0) return skip("there is no node");
  const std::string file = (source_dir() / "scripts/colliders/js/translation.cjs").string();
  const Collider translation = collider_of_command("node " + file, 10 * kSecondsMax);
  CHECK(translation.declaration.claims == Claims::separation);
  CHECK(run(plan_of(translation)).tally->unexplained() == 0);
}

TEST_CASE("fuzz says in a line which mistake of an adapter makes its wrong answers") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "run.json").string();
  const auto fuzz = [&](const std::string& behaviour) {
    return run_manifuzz({"fuzz", "--subject-command",
                         std::string(MANIFUZZ_TEST_PROGRAM) + " " + behaviour, "--oracle", "clip64",
                         "--regime", "generic", "--regime", "boxes", "--seed", "1", "--cases",
                         "1000", "--radius", "0", "--no-save", "--json", json});
  };
  const Outcome reversed = fuzz("reversed");
  CHECK(reversed.status == 1);
  const auto hints = nlohmann::json::parse(text_of(json)).at("hints");
  REQUIRE(hints.size() == 1);
  CHECK(hints[0]["mistake"] == "reversed-normal");
  CHECK(hints[0]["of_wrong"] == hints[0]["right_when_undone"]);
  CHECK(hints[0]["of_wrong"].get<int>() >= 20);
  CHECK(reversed.out.find("\nhint: " + hints[0]["text"].get<std::string>() + "\n") !=
        std::string::npos);
  CHECK(fuzz("separation").out.find("hint") == std::string::npos);
  CHECK(nlohmann::json::parse(text_of(json)).at("hints").empty());
}
