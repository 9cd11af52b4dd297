#include "cli/engines.hpp"

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "oracle/external/external_collider.hpp"

namespace manifuzz {
namespace {

constexpr std::string_view kNode = "node and npm";
constexpr std::string_view kJava = "javac and mvn";
constexpr std::string_view kRust = "cargo (Rust 1.95)";

constexpr Engine kEngines[] = {
    {"box2d3", "Box2D 3 in C, its b2Collide functions",
     "@/rust/target/release/libmanifuzz_box2d3.so", "@/rust/target/release/libmanifuzz_box2d3.so",
     kRust},
    {"parry2d", "parry (Rapier's) in floats, polygons as they are",
     "@/rust/target/release/libmanifuzz_parry2d.so", "@/rust/target/release/libmanifuzz_parry2d.so",
     kRust},
    {"parry2d-f64", "parry in doubles, polygons as they are",
     "@/rust/target/release/libmanifuzz_parry2d_f64.so",
     "@/rust/target/release/libmanifuzz_parry2d_f64.so", kRust},
    {"parry2d-simplified", "parry in floats, polygons by from_convex_polyline",
     "@/rust/target/release/libmanifuzz_parry2d_simplified.so",
     "@/rust/target/release/libmanifuzz_parry2d_simplified.so", kRust},
    {"cute_c2", "cute_c2's c2Collide, in C", "@/rust/target/release/libmanifuzz_cute_c2.so",
     "@/rust/target/release/libmanifuzz_cute_c2.so", kRust},
    {"dyn4j-sat", "dyn4j's Sat and ClippingManifoldSolver",
     "java -XX:+UseSerialGC -cp @/java/installed:@/java/'installed/*' Dyn4j sat",
     "@/java/installed/Protocol.class", kJava},
    {"dyn4j-gjk", "dyn4j's Gjk and ClippingManifoldSolver",
     "java -XX:+UseSerialGC -cp @/java/installed:@/java/'installed/*' Dyn4j gjk",
     "@/java/installed/Protocol.class", kJava},
    {"jbox2d", "jbox2d's Collision, Box2D 2.2's way",
     "java -XX:+UseSerialGC -cp @/java/installed:@/java/'installed/*' Jbox2d",
     "@/java/installed/Protocol.class", kJava},
    {"pymunk", "Munk2D's cpShapesCollide, by pymunk",
     "@/python/installed/bin/python @/python/munk.py", "@/python/installed/requirements.txt",
     "python3 with venv"},
    {"cp", "Chipmunk's port to Go, ShapesCollide", "@/go/installed/libmanifuzz_cp.so",
     "@/go/installed/libmanifuzz_cp.so", "go and gcc"},
    {"godot3", "Godot 3's Shape2D.collide_and_get_contacts", "python3 @/gdscript/relay.py",
     "/usr/bin/godot3-server", "root or sudo", 10},
    {"planck", "planck of npm, under node", "node @/planck.mjs", "@/node_modules/planck", kNode},
    {"phaser-box2d", "phaser-box2d of npm, under node", "node @/phaser-box2d.mjs",
     "@/node_modules/phaser-box2d", kNode},
    {"box2d-core", "@box2d/core of npm, under node", "node @/box2d-core.mjs",
     "@/node_modules/@box2d/core", kNode},
    {"matter-js", "matter-js of npm, under node", "node @/matter-js.mjs",
     "@/node_modules/matter-js", kNode},
    {"p2-es", "p2-es of npm, under node", "node @/p2-es.mjs", "@/node_modules/p2-es", kNode},
    {"nape-js", "nape-js of npm, under node", "node @/nape-js.mjs",
     "@/node_modules/@newkrok/nape-js", kNode},
    {"rapier2d", "rapier2d-compat's contactPair, of npm, under node",
     "node @/rapier2d-manifold.mjs", "@/node_modules/@dimforge/rapier2d-compat", kNode},
    {"rapier2d-contact", "rapier2d-compat's contactCollider, of npm, under node",
     "node @/rapier2d-contact.mjs", "@/node_modules/@dimforge/rapier2d-compat", kNode},
    {"sat", "SAT.js's minimum translation, of npm, under node", "node @/sat.mjs",
     "@/node_modules/sat", kNode},
};

/// With the folder in the place of each @.
std::string in_folder(std::string_view text, const std::string& folder) {
  std::string result(text);
  for (std::size_t at = 0; (at = result.find("@/", at)) != std::string::npos;) {
    result.replace(at, 1, folder);
    at += folder.size();
  }
  return result;
}

}  // namespace

std::span<const Engine> engines() {
  return kEngines;
}

namespace {

bool is_library(const Engine& engine) {
  return engine.adapter.ends_with(".so");
}

/// The adapter's folder; throws UserError where it has nothing to ask.
std::string folder_of(const Engine& engine) {
  std::string folder = MANIFUZZ_ADAPTERS;
  if (std::filesystem::exists(in_folder(engine.needs, folder))) return folder;
  throw UserError(
      fmt::format("{} is not installed; scripts/setup --engines installs it, which needs {}",
                  engine.name, engine.tools));
}

}  // namespace

std::string library_of(const Engine& engine) {
  if (is_library(engine)) return in_folder(engine.adapter, folder_of(engine));
  throw UserError(
      fmt::format("{} is a program, whose time is mostly that of passing cases; only libraries are "
                  "timed",
                  engine.name));
}

Collider collider_of(const Engine& engine) {
  const std::string folder = folder_of(engine);
  Collider collider = is_library(engine)
                          ? collider_in_own_process(library_of(engine), engine.seconds_max)
                          : collider_of_command(in_folder(engine.adapter, quoted_for_shell(folder)),
                                                engine.seconds_max);
  collider.declaration.description = engine.description;
  return collider;
}

}  // namespace manifuzz
