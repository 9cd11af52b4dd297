#include <cstdlib>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// scripts/engines --update over stand-ins for what installs engines.

using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// scripts/engines --update of an engine to 99.0.0, where each of these tools says this and fails.
Outcome update(const std::string& engine, const std::string& said) {
  const TemporaryFolder folder;
  for (const char* const tool : {"cargo", "npm", "go", "python3", "mvn"}) {
    const std::string program = folder.write(tool, "#!/bin/sh\necho '" + said + "' >&2\nexit 1\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  return run_program({"env", "PATH=" + folder.path().string() + ":" + std::getenv("PATH"),
                      (source_dir() / "scripts/engines").string(), "--update", engine, "99.0.0"});
}

/// What an engine's folder holds that says which version it is.
std::string pins_of(const std::string& engine) {
  std::string pins;
  for (const char* const file : {"engine.json", "package.json", "package-lock.json", "install",
                                 "requirements.txt", "adapter/go.mod", "adapter/Cargo.toml"}) {
    pins += text_of(source_dir() / "oracle" / engine / file);
  }
  return pins;
}

}  // namespace

TEST_CASE("a version that is not served is one line, and changes nothing") {
  const auto [engine, package] = GENERATE(
      table<std::string, std::string>({{"parry", "cargo has no parry2d"},
                                       {"planck", "npm has no planck"},
                                       {"cp", "go has no github.com/jakecoffman/cp/v2"},
                                       {"pymunk", "pip has no pymunk"},
                                       {"dyn4j", "mvn has no org.dyn4j:dyn4j"},
                                       {"jbox2d", "mvn has no org.jbox2d:jbox2d-library"}}));
  CAPTURE(engine);
  const std::string before = pins_of(engine);
  const Outcome outcome = update(engine, "one\ntwo: no match for it\nthree");
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err ==
        "scripts/engines: --update: " + package + " 99.0.0 here: two: no match for it\n");
  CHECK(pins_of(engine) == before);
}

TEST_CASE("an engine that nothing here pins is one line on what does") {
  const Outcome outcome = update("box2d3", "");
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains("oracle/box2d3/adapter/box2d3/Cargo.toml"));
}
