#include "canary/edits.hpp"

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

// The table of planted bugs, and the tool that plants them at build time.

using namespace manifuzz;

namespace {

constexpr const char* kSource = "namespace manifuzz {\n  int one = 1;\n  int two = 2;\n}\n";

test::Outcome plant(const std::string& table, const char* source = kSource,
                    const char* path = "src", const char* suffix = "") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "src");
  folder.write("src/a.cpp", source);
  const std::string output = (folder.path() / "out.cpp").string();
  test::Outcome outcome = test::run_program({MANIFUZZ_PLANT, folder.write("edits.txt", table),
                                             folder.path().string(), output, "src/a.cpp", "0", "1",
                                             "--edits", path, "--as", suffix, "src/a.cpp"});
  if (outcome.status == 0) outcome.out = canary::read_text(output);
  return outcome;
}

bool says(const test::Outcome& outcome, const char* text) {
  return outcome.err.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("an edit is planted under a namespace of its own") {
  const auto planted = plant("wrong_two: two is three\nsrc/a.cpp\n-int two = 2;\n+int two = 3;\n");
  CHECK(planted.status == 0);
  CHECK(
      planted.out.find("namespace manifuzz::planted::wrong_two {\n  int one = 1;\nint two = 3;") !=
      std::string::npos);
}

TEST_CASE("edits are those in a folder, or in one file") {
  const char* const table = "wrong_two: two is three\nsrc/a.cpp\n-int two = 2;\n+int two = 3;\n";
  for (const char* path : {"src", "src/a.cpp"}) {
    CHECK(plant(table, kSource, path).out.find("two = 3") != std::string::npos);
  }
  for (const char* path : {"sr", "src/a.cp", "src/b.cpp"}) {
    CHECK(plant(table, kSource, path).out.find("two = 3") == std::string::npos);
  }
}

TEST_CASE(
    "each root that has a bug may give it a name of its own, and each copy its include guard") {
  const char* const guarded = "#define MANIFUZZ_A_INL\nnamespace manifuzz { }\nint two = 2;\n";
  const auto planted =
      plant("wrong_two: why\nsrc/a.cpp\n-int two = 2;\n+int two = 3;\n", guarded, "src", "_in_a");
  CHECK(planted.out.find("namespace manifuzz::planted::wrong_two_in_a { }") != std::string::npos);
  CHECK(planted.out.find("#define MANIFUZZ_A_INL_wrong_two_in_a\n") != std::string::npos);
}

TEST_CASE("an edit that no longer applies fails the build") {
  const auto gone = plant("wrong_two: why\nsrc/a.cpp\n-int two = 4;\n+int two = 3;\n");
  CHECK(gone.status == 2);
  CHECK(says(gone, "line 1: wrong_two: the old line must be in src/a.cpp once"));
}

TEST_CASE("an edit that applies twice fails the build") {
  const char* const twice = "int two = 2;\nint two = 2;\n";
  const auto result = plant("wrong_two: why\nsrc/a.cpp\n-int two = 2;\n+int two = 3;\n", twice);
  CHECK(result.status == 2);
  CHECK(says(result, "it is there 2 times"));
}

TEST_CASE("a table that cannot be read fails the build, and says where") {
  CHECK(says(plant("no head\n"), "line 1: a block begins with"));
  CHECK(says(plant("Bug: why\n"), "line 1: a bug's name"));
  CHECK(says(plant("a: why\nsrc/a.cpp\n\n\na: again\nsrc/a.cpp\n"), "line 5: a name is used once"));
  CHECK(says(plant("a: why\nsrc/a.cpp\n-int one = 1;\n-int two = 2;\n"), "line 4: a block has"));
  CHECK(says(plant("a: why\nsrc/b.cpp\n-int one = 1;\n"), "cannot be read"));
}
