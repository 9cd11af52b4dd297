#include <filesystem>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Catch::Contains;
namespace fs = std::filesystem;

TEST_CASE("what OSS-Fuzz and ClusterFuzzLite build runs by itself", "[longer]") {
#ifndef NDEBUG
  skip("the optimised build does this");
  return;
#endif
  const TemporaryFolder folder;
  const std::string source =
      folder.write("empty.cpp",
                   "extern \"C\" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) {"
                   " return 0; }\n");
  const std::string empty = (folder.path() / "empty").string();
  const std::string command = "clang++-14 -fsanitize=fuzzer " + source + " -o " + empty;
  if (run_program({"sh", "-c", command}).status != 0) {
    skip("clang 14's libFuzzer is missing; scripts/setup --sanitizers has it");
    return;
  }
  for (const char* const name : {"src", "out", "work"}) fs::create_directory(folder.path() / name);
  fs::create_symlink(source_dir(), folder.path() / "src" / "manifuzz");
  const auto variable = [&](const std::string& name, const char* to) {
    return name + "=" + (folder.path() / to).string();
  };
  const std::string flags =
      "-O1 -fno-omit-frame-pointer -gline-tables-only "
      "-fsanitize=fuzzer-no-link";
  const bool has_ccache = run_program({"sh", "-c", "command -v ccache"}).status == 0;
  const Outcome built =
      run_program({"env", variable("SRC", "src"), variable("OUT", "out"), variable("WORK", "work"),
                   "CC=clang-14", "CXX=clang++-14", "CFLAGS=" + flags, "CXXFLAGS=" + flags,
                   "LIB_FUZZING_ENGINE=-fsanitize=fuzzer",
                   std::string("CMAKE_CXX_COMPILER_LAUNCHER=") + (has_ccache ? "ccache" : ""),
                   (source_dir() / ".clusterfuzzlite/build.sh").string()});
  CAPTURE(built.out, built.err);
  REQUIRE(built.status == 0);
  const fs::path out = folder.path() / "out";
  CHECK(fs::exists(out / "clip_seed_corpus.zip"));
  CHECK_THAT(text_of(out / "clip.options"), Contains("use_value_profile = 1"));
  // Elsewhere there is nothing of what it was built of.
  fs::rename(out, folder.path() / "elsewhere");
  fs::remove_all(folder.path() / "work");
  const std::string program = (folder.path() / "elsewhere" / "clip").string();
  const Outcome run = run_program({program, "-runs=500", "-seed=1", "-use_value_profile=1"});
  CAPTURE(run.err);
  CHECK(run.status == 0);  // a wrong answer would have ended it
  CHECK_THAT(run.err, Contains("Done 500 runs"));
  const Outcome libraries = run_program({"ldd", program});
  CHECK_THAT(libraries.out, Contains("elsewhere/lib/libfmt"));
}
