#include <array>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "cli/colliders.hpp"
#include "report/words.hpp"
#include "support/installed_collider.hpp"
#include "support/run_program.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// The programs that reports on other engines hold: of shapes of every kind they run, and find as
// many points as the collider did.

using namespace manifuzz;
using namespace manifuzz::test;

namespace fs = std::filesystem;

namespace {

ConvexPolygon<float> shape_of(int vertices) {
  const std::array<Vector2<float>, 4> corners{Vector2<float>(-1, -1), Vector2<float>(1, -1),
                                              Vector2<float>(1, 1), Vector2<float>(-1, 1)};
  const std::array<Vector2<float>, 2> ends{Vector2<float>(-1, 0.75F), Vector2<float>(1, 0.75F)};
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  if (vertices == 1) return make_polygon<float>(center, 1.0F);
  if (vertices == 2) return make_polygon<float>(ends, 0.25F);
  return make_polygon<float>(corners, 0.01F);
}

/// Two shapes of so many vertices, the second turned a little, above the first and into it.
PairCase pair_of(int vertices_a, int vertices_b) {
  PairCase pair{{shape_of(vertices_a), {}}, {shape_of(vertices_b), {}}};
  pair.b.pose.position = {0.25F, vertices_b == 2 ? 0.2F : 1.9F};
  pair.b.pose.rotation = {0.9998F, 0.02F};
  return pair;
}

constexpr int kTouching = 100;  ///< in place of points, where a collider gives none
constexpr int kApart = -1;

/// The pairs that the collider takes, with the points that it finds.
std::vector<std::pair<PairCase, int>> pairs_for(const Collider& collider) {
  std::vector<std::pair<PairCase, int>> pairs;
  for (const int a : {1, 2, 4}) {
    for (const int b : {1, 2, 4}) {
      PairCase pair = pair_of(a, b);
      const Declaration& declaration = collider.declaration;
      if (!declaration.takes_radius && !declaration.takes_round) {
        if (a > 2) pair.a.polygon.radius = 0;
        if (b > 2) pair.b.polygon.radius = 0;
      }
      const Answer answer = ask(collider, pair);
      if (const auto* const found = manifold_in(answer)) pairs.emplace_back(pair, found->count);
      if (const auto* const found = std::get_if<Penetration>(&answer)) {
        pairs.emplace_back(pair, found->touches ? kTouching : kApart);
      }
    }
  }
  return pairs;
}

/// What a program prints of so many points; SAT.js has none, and is asked whether they touch.
std::string said(int points) {
  if (points == kTouching) return "they touch";
  return points == kApart ? "no contact" : std::to_string(points) + " points";
}

/// What the program prints of each pair, run by `command_for` its file.
template <class CommandFor>
void check_programs(const Collider& collider, const fs::path& folder, std::string_view file,
                    const CommandFor& command_for, int least_with_points = 5) {
  int with_points = 0;
  for (const auto& [pair, points] : pairs_for(collider)) {
    const std::string program = filled_in(collider.declaration.snippet, pair);
    INFO(program);
    for (const char* const left : {"@a.", "@b.", "@*", "@^", "@each", "@asked"}) {
      CHECK(program.find(left) == std::string::npos);
    }
    const fs::path path = folder / file;
    std::ofstream(path) << program;
    const test::Outcome ran = run_program({"sh", "-c", command_for(path.string())});
    INFO(ran.err << ran.out);
    CHECK(ran.status == 0);
    CHECK(ran.out.find(said(points)) != std::string::npos);
    if (points > 0) ++with_points;
  }
  CHECK(with_points >= least_with_points);
}

void check_script(std::string_view engine, std::string_view package, int least_with_points = 5) {
  const fs::path adapters = source_dir() / "scripts/colliders";
  if (!fs::exists(adapters / "node_modules" / package)) {
    return skip(std::string(engine) + " is not installed");
  }
  const auto collider = installed_collider(engine);
  REQUIRE(collider);
  INFO(engine);
  const TemporaryFolder folder;
  fs::create_directory_symlink(adapters / "node_modules", folder.path() / "node_modules");
  check_programs(
      *collider, folder.path(), "snippet.mjs",
      [](const std::string& file) { return "node '" + file + "'"; }, least_with_points);
}

fs::path adapters_in(std::string_view language) {
  return source_dir() / "scripts/colliders" / language;
}

}  // namespace

TEST_CASE("Box2D's program compiles and runs on shapes of every kind") {
  const TemporaryFolder folder;
  const std::string program = (folder.path() / "snippet").string();
  check_programs(find_collider("box2d"), folder.path(), "snippet.cpp",
                 [&program](const std::string& file) {
                   return std::string(MANIFUZZ_COMPILE_WITH_BOX2D) + " '" + file + "' -o '" +
                          program + "' " + MANIFUZZ_LINK_WITH_BOX2D + " && '" + program + "'";
                 });
}

TEST_CASE("Chipmunk's program compiles and runs on shapes of every kind") {
  const TemporaryFolder folder;
  const std::string program = (folder.path() / "snippet").string();
  check_programs(find_collider("chipmunk"), folder.path(), "snippet.cpp",
                 [&program](const std::string& file) {
                   return std::string(MANIFUZZ_COMPILE_WITH_CHIPMUNK) + " '" + file + "' -o '" +
                          program + "' -lchipmunk && '" + program + "'";
                 });
}

TEST_CASE("the programs of Box2D 3 and cute_c2 compile and run on shapes of every kind") {
  const std::string crates = "\"$HOME\"/.cargo/registry/src/*/";
  const std::string built = "'" + (adapters_in("rust") / "target/release/build").string() + "'";
  for (const auto& [engine, with] :
       {std::pair<std::string, std::string>{
            "box2d3", "-I " + crates + "boxdd-sys-0.6.0/third-party/box2d/include " + built +
                          "/boxdd-sys-*/out/*.a -lm -lpthread"},
        {"cute_c2", "-I " + crates + "c2-sys-0.1.0/cute-header " + crates +
                        "c2-sys-0.1.0/cute-header/cute_c2.c -lm"}}) {
    const auto collider = installed_collider(engine);
    if (!collider) continue;
    INFO(engine);
    const TemporaryFolder folder;
    const std::string program = (folder.path() / "snippet").string();
    check_programs(*collider, folder.path(), "snippet.c", [&](const std::string& file) {
      return "cc '" + file + "' -o '" + program + "' " + with + " && '" + program + "'";
    });
  }
}

TEST_CASE("planck's program runs on shapes of every kind") {
  check_script("planck", "planck");
}

TEST_CASE("phaser-box2d's program runs on shapes of every kind") {
  check_script("phaser-box2d", "phaser-box2d");
}

TEST_CASE("the programs of other engines of npm run on shapes of every kind that they take") {
  check_script("box2d-core", "@box2d/core");
  check_script("matter-js", "matter-js", 1);
  check_script("nape-js", "@newkrok/nape-js", 4);
  check_script("p2-es", "p2-es");
  check_script("rapier2d", "@dimforge/rapier2d-compat");
  check_script("rapier2d-contact", "@dimforge/rapier2d-compat");
  check_script("sat", "sat", 4);
}

TEST_CASE("the programs of dyn4j and jbox2d run on shapes of every kind") {
  for (const char* const engine : {"dyn4j-sat", "dyn4j-gjk", "jbox2d"}) {
    const auto collider = installed_collider(engine);
    if (!collider) continue;
    INFO(engine);
    const TemporaryFolder folder;
    check_programs(*collider, folder.path(), "Snippet.java", [](const std::string& file) {
      return "java -cp '" + (adapters_in("java") / "installed/*").string() + "' '" + file + "'";
    });
  }
}

TEST_CASE("pymunk's program runs on shapes of every kind") {
  const auto collider = installed_collider("pymunk");
  if (!collider) return;
  const TemporaryFolder folder;
  check_programs(*collider, folder.path(), "snippet.py", [](const std::string& file) {
    return "'" + (adapters_in("python") / "installed/bin/python").string() + "' '" + file + "'";
  });
}

TEST_CASE("cp's program runs on shapes of every kind") {
  const auto collider = installed_collider("cp");
  if (!collider) return;
  const TemporaryFolder folder;
  for (const char* const file : {"go.mod", "go.sum"}) {
    fs::copy_file(adapters_in("go") / file, folder.path() / file);
  }
  check_programs(*collider, folder.path(), "snippet.go", [&](const std::string& file) {
    return "cd '" + folder.path().string() + "' && go run '" + file + "'";
  });
}

TEST_CASE("Godot's program runs on shapes of every kind") {
  const auto collider = installed_collider("godot3");
  if (!collider) return;
  const TemporaryFolder folder;
  check_programs(*collider, folder.path(), "snippet.gd", [&](const std::string& file) {
    return "cd '" + folder.path().string() + "' && godot3-server --no-window -s '" + file + "'";
  });
}
