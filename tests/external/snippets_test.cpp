#include <catch2/catch.hpp>

#include "engines/colliders.hpp"
#include "external/snippet_programs.hpp"
#include "support/installed_collider.hpp"

// The programs that reports on other engines hold: of shapes of every kind they run, and find as
// many points, as deep, as the collider did.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

void check_script(std::string_view engine, const Prints& prints = {}) {
  const auto collider = installed_collider(engine);
  if (!collider) return;
  check_programs(*collider, "snippet.mjs", "node '{file}'", prints,
                 {in_engine(engine, "node_modules").string()});
}

/// The place in an engine's folder, quoted for a shell but for what it may hold of patterns.
std::string quoted_in_engine(std::string_view engine, std::string_view file) {
  return "'" + in_engine(engine, file).string() + "'";
}

const std::string kCompileCpp = MANIFUZZ_COMPILE_CPP " '{file}' -o '{folder}/snippets' ";
const std::string kRunCompiled = "'{folder}/snippets' {}";

}  // namespace

TEST_CASE("the programs of Box2D and Chipmunk compile and run on shapes of every kind") {
  check_at_once(find_collider("box2d"), kCpp,
                kCompileCpp + MANIFUZZ_COMPILE_WITH_BOX2D " " MANIFUZZ_LINK_WITH_BOX2D,
                kRunCompiled);
  check_at_once(find_collider("chipmunk"), kCpp, kCompileCpp + "-lchipmunk", kRunCompiled);
}

TEST_CASE("the programs of Bullet compile and run on shapes of every kind") {
  for (const char* const engine :
       {"bullet-epa", "bullet-minkowski", "bullet-convex2d", "bullet-perturbed"}) {
    const auto collider = installed_collider(engine);
    if (!collider) continue;
    // The adapter leaves those of a prism's four points that differ in the plane.
    check_at_once(*collider, kCpp, kCompileCpp + "$(pkg-config --cflags --libs bullet)",
                  kRunCompiled, {.has_count = std::string_view(engine) != "bullet-perturbed"});
  }
}

TEST_CASE("the programs of libccd, Box2D 3 and cute_c2 compile and run on shapes of every kind") {
  const std::string crates = "\"$HOME\"/.cargo/registry/src/*/";
  const std::string built = quoted_in_engine("box2d3", "adapter/target/release/build");
  const std::string ccd = "$(pkg-config --cflags --libs ccd) -lm";
  struct Engine {
    std::string name;
    std::string with;
    Prints prints{};
  };
  for (const Engine& engine :
       {Engine{"libccd-gjk", ccd, {.least_touching = 1}},
        {"libccd-mpr", ccd, {.least_touching = 1}},
        {"box2d3", "-I " + crates + "boxdd-sys-0.6.0/third-party/box2d/include " + built +
                       "/boxdd-sys-*/out/*.a -lm -lpthread"},
        {"cute_c2", "-I " + crates + "c2-sys-0.1.0/cute-header " + crates +
                        "c2-sys-0.1.0/cute-header/cute_c2.c -lm"}}) {
    const auto collider = installed_collider(engine.name);
    if (!collider) continue;
    check_programs(*collider, "snippet.c",
                   "cc '{file}' -o '{folder}/snippet' " + engine.with + " && '{folder}/snippet'",
                   engine.prints);
  }
}

TEST_CASE("the programs of parry compile and run on shapes of every kind") {
  const std::string built = quoted_in_engine("parry2d", "adapter/target/release/deps");
  for (const auto& [engine, crate] : {std::pair<std::string, std::string>{"parry2d", "parry2d"},
                                      {"parry2d-simplified", "parry2d"},
                                      {"parry2d-f64", "parry2d_f64"}}) {
    const auto collider = installed_collider(engine);
    if (!collider) continue;
    check_at_once(*collider, kRust,
                  "rustc --edition 2024 -C panic=abort -L " + built +
                      " '{file}' -o '{folder}/snippets' --extern " + crate + "=$(ls " + built +
                      "/lib" + crate + "-*.rlib)",
                  kRunCompiled);
  }
}

TEST_CASE("the program of planck runs on shapes of every kind") {
  check_script("planck");
}

TEST_CASE("the program of phaser-box2d runs on shapes of every kind") {
  check_script("phaser-box2d");
}

TEST_CASE(
    "the programs of Box2D in TypeScript, matter-js and nape-js run on shapes of every kind") {
  check_script("box2d-core");
  check_script("matter-js", {.least_touching = 1});
  check_script("nape-js", {.least_touching = 4});
}

TEST_CASE("the programs of p2-es and SAT.js run on shapes of every kind") {
  // p2 gives places alone.
  check_script("p2-es", {.least_touching = 8, .has_depths = false});
  check_script("sat", {.least_touching = 4});
}

TEST_CASE("the programs of Rapier run on shapes of every kind") {
  check_script("rapier2d");
  check_script("rapier2d-contact");
}

TEST_CASE("the programs of dyn4j and jbox2d run on shapes of every kind") {
  for (const char* const engine : {"dyn4j-sat", "dyn4j-gjk", "jbox2d"}) {
    const auto collider = installed_collider(engine);
    if (!collider) continue;
    const std::string installed = "'" + in_engine(engine, "installed").string() + "/*':'{folder}'";
    // jbox2d's world manifold has no separations.
    check_at_once(*collider, kJava, "javac -d '{folder}' -cp " + installed + " '{file}'",
                  "java -cp " + installed + " Snippets {}",
                  {.has_depths = std::string_view(engine) != "jbox2d"});
  }
}

TEST_CASE("the program of pymunk runs on shapes of every kind") {
  const auto collider = installed_collider("pymunk");
  if (!collider) return;
  check_programs(*collider, "snippet.py",
                 quoted_in_engine("pymunk", "installed/bin/python") + " '{file}'");
}

TEST_CASE("the program of cp runs on shapes of every kind") {
  const auto collider = installed_collider("cp");
  if (!collider) return;
  check_programs(
      *collider, "snippet.go", "cd '{folder}' && go run '{file}'", {},
      {in_engine("cp", "adapter/go.mod").string(), in_engine("cp", "adapter/go.sum").string()});
}

TEST_CASE("the program of Godot runs on shapes of every kind") {
  const auto collider = installed_collider("godot3");
  if (!collider) return;
  check_programs(*collider, "snippet.gd", "cd '{folder}' && godot3-server --no-window -s '{file}'",
                 {.has_depths = false});
}
