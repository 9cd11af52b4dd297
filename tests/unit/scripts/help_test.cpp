#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
namespace fs = std::filesystem;

namespace {

/// Scripts that run what they are given, or take the options of another program.
constexpr std::array<std::string_view, 3> kOthersOptions{"fuzz", "quietly", "zig"};

bool is_script(const fs::path& file) {
  return fs::is_regular_file(file) &&
         (fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none &&
         text_of(file).starts_with("#!/usr/bin/env bash\n# scripts/");
}

}  // namespace

TEST_CASE("every script says what it does with --help, and does nothing else") {
  int asked = 0;
  for (const std::string folder : {"scripts", "scripts/cluster"}) {
    for (const auto& entry : fs::directory_iterator(source_dir() / folder)) {
      const std::string name = entry.path().filename().string();
      if (!is_script(entry.path()) || std::ranges::count(kOthersOptions, name) > 0) continue;
      CAPTURE(name);
      const Outcome outcome = run_program({entry.path().string(), "--help"});
      CHECK(outcome.status == 0);
      CHECK(outcome.out.starts_with(folder + "/" + name));
      CHECK_FALSE(outcome.out.ends_with("\n\n"));
      CHECK(outcome.out.find("set -euo") == std::string::npos);
      CHECK(outcome.err.empty());
      ++asked;
    }
  }
  CHECK(asked > 30);
}

TEST_CASE("a script that needs arguments says so in one line where it has none") {
  for (const std::string name : {"build_from_headers", "engines --new", "install_engine",
                                 "libfuzzer", "new_engine", "pin_engine", "pin_engine --in",
                                 "playground", "python_packages", "update_engine", "wheel"}) {
    CAPTURE(name);
    const Outcome outcome =
        run_program({"bash", "-c", (source_dir() / "scripts").string() + "/" + name});
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("scripts/"));
    CHECK(outcome.err.find("unbound") == std::string::npos);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
  }
}
