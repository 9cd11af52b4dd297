#include <cstdlib>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "external/campaigns.hpp"
#include "generating/regime.hpp"
#include "support/installed_collider.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// The adapters of scripts/colliders, and those that its users write after the pages.

using namespace manifuzz;
using namespace manifuzz::test;
namespace fs = std::filesystem;

namespace {

constexpr double kAdapterSecondsMax = 10;  // over a case: other programs run beside it
constexpr double kStartSeconds = 60;       // a Java program is compiled at its start

bool is_there(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

fs::path adapters() {
  return source_dir() / "scripts/colliders";
}

Collider adapter(const std::string& command, const fs::path& file) {
  return collider_of_command(command + " " + quoted_for_shell(file.string()), kAdapterSecondsMax,
                             kStartSeconds);
}

/// A program in JavaScript beside the protocol and the engines that it imports.
Collider beside_protocol(const TemporaryFolder& folder, const std::string& program) {
  fs::create_directories(folder.path() / "node_modules");
  fs::create_directory_symlink(adapters() / "js", folder.path() / "node_modules/manifuzz-adapter");
  const fs::path planck = in_engine("planck", "node_modules/planck");
  if (fs::exists(planck)) {
    fs::create_directory_symlink(planck, folder.path() / "node_modules/planck");
  }
  return adapter("node", folder.write("mine.mjs", program));
}

/// A minimum translation, written with what protocol.mjs says of a body; `answer` is made of it.
std::string translation(const std::string& claims, const std::string& answer) {
  return R"(import { serve, toWorld } from "manifuzz-adapter";
const placed = ({vertices, count, pose}) => vertices.slice(0, count).map((v) => toWorld(pose, v));
const faces = (p, q, sign) => p.normals.map((normal, i) => {
  const n = toWorld({p: {x: 0, y: 0}, q: p.pose.q}, normal), [x, y] = toWorld(p.pose, p.vertices[i]);
  const gap = Math.min(...placed(q).map(([z, w]) => n[0]*(z - x) + n[1]*(w - y)));
  return {depth: p.radius + q.radius - gap, normal: n.map((c) => sign*c)};
});
serve({name: "mine", scalar: "float64", claims: ")" +
         claims + R"("}, (a, b) => {
  const {depth, normal} = [...faces(a, b, 1), ...faces(b, a, -1)].reduce((p, q) => q.depth < p.depth ? q : p);
  return )" +
         answer + R"(;
});
)";
}

}  // namespace

TEST_CASE("the clipping in Python is right in every regime") {
  if (!is_there("python3")) return skip("there is no python3");
  const Collider python = adapter("python3", adapters() / "python/clip.py");
  CHECK(python.declaration.name == "clip-python");
  Plan plan = plan_of(python);
  plan.regimes.clear();
  for (const Regime& regime : polygon_regimes()) plan.regimes.push_back(&regime);
  const JobsResult result = run(plan);
  CHECK(result.tally->cases() == kCases);
  CHECK(result.tally->unexplained() == 0);
  CHECK(result.tally->count(Verdict::unsupported) == 0);
  CHECK(result.tally->touching() > kCases / 3);
}

TEST_CASE("engines of other languages answer, and mostly as they should") {
  // Below the shares of right answers that were measured, 0.89 to 0.98.
  for (const auto& [name, share] :
       {std::pair("dyn4j-sat", 0.92), std::pair("dyn4j-gjk", 0.92), std::pair("jbox2d", 0.95),
        std::pair("pymunk", 0.92), std::pair("cp", 0.85), std::pair("godot3", 0.8)}) {
    const auto engine = installed_collider(name);
    if (!engine) continue;
    INFO(name);
    CHECK(engine->declaration.name == name);
    Plan plan = plan_of(*engine);
    plan.context.radius = 0.0F;
    plan.regimes.clear();
    for (const Regime& regime : polygon_regimes()) plan.regimes.push_back(&regime);
    const JobsResult result = run(plan);
    CHECK(result.tally->cases() == kCases);
    CHECK(result.tally->touching() > kCases / 3);
    const auto right = result.tally->count(Verdict::agree) + result.tally->count(Verdict::tie) +
                       result.tally->count(Verdict::ill_posed);
    CHECK(static_cast<double>(right) > share * static_cast<double>(kCases));
    const auto lost = {Verdict::crashed, Verdict::timed_out, Verdict::malformed};
    for (const Verdict verdict : lost) CHECK(result.tally->count(verdict) == 0);
  }
}

TEST_CASE("a body is to an adapter in JavaScript what protocol.mjs says") {
  if (!is_there("node")) return skip("there is no node");
  for (const auto& [claims, answer] : {std::pair("separation", "{depth, normal}"),
                                       std::pair("touching", "{touching: depth >= 0}")}) {
    INFO(claims);
    const TemporaryFolder folder;
    const JobsResult result = run(plan_of(beside_protocol(folder, translation(claims, answer))));
    CHECK(result.tally->cases() == kCases);
    CHECK(result.tally->touching() > kCases / 3);
    CHECK(result.tally->unexplained() == 0);
  }
}

TEST_CASE("the adapter of the README works, and misses contacts as it is said to") {
  if (!fs::exists(in_engine("planck", "node_modules/planck")))
    return skip("planck is not installed");
  const std::string readme = text_of(source_dir() / "README.md");
  const std::size_t begin = readme.find("```js\n") + 6;
  REQUIRE(begin > 6);
  const TemporaryFolder folder;
  Plan plan =
      plan_of(beside_protocol(folder, readme.substr(begin, readme.find("```", begin) - begin)));
  plan.regimes = {find_regime("sliver"), find_regime("tie_bias")};
  const JobsResult result = run(plan);
  CHECK(result.tally->cases() == kCases);
  CHECK(result.tally->count(Verdict::agree) > kCases / 2);
  CHECK(count_of(result, Kind::missed_contact) > 0);
  CHECK(result.tally->count(Verdict::malformed) == 0);
}
