#include "canary/edits.hpp"

#include <catch2/catch.hpp>

#include "canary/switches.hpp"
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
  test::Outcome outcome =
      test::run_program({MANIFUZZ_PLANT, folder.write("edits.txt", table), folder.path().string(),
                         output, "src/a.cpp", "--edits", path, "--as", suffix, "src/a.cpp"});
  if (outcome.status == 0) outcome.out = canary::read_text(output);
  return outcome;
}

bool says(const test::Outcome& outcome, const char* text) {
  return outcome.err.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("an edit is planted under a namespace of its own") {
  const char* const odd = "namespace manifuzz {\n  int sum = 1 +\n      2;\n}\n";
  const auto planted = plant("wrong_two: two is three\nsrc/a.cpp\n-2;\n+3;\n", odd);
  CHECK(planted.status == 0);
  CHECK(planted.out.find("namespace manifuzz::planted::wrong_two {\n  int sum = 1 +\n3;\n}") !=
        std::string::npos);
}

TEST_CASE("edits that fit behind switches have copies together, and so has what is not edited") {
  const auto planted = plant(
      "unedited: nothing\nsrc/a.cpp\n\nthree: two is three\nsrc/a.cpp\n-int two = 2;\n"
      "+int two = 3;\n\nfour: two is four\nsrc/a.cpp\n-int two = 2;\n+int two = 4;\n",
      "namespace manifuzz {\n  int two = 2;\n}\nconst Bug bugs[] = {PLANTED_BUGS};\n");
  CHECK(planted.out.find("namespace manifuzz::planted::edits_src {\nint two = "
                         "canary::is_acting(4) ? (3) : canary::is_acting(9) ? (4) : (2);\n}") !=
        std::string::npos);
  CHECK(planted.out.find("bugs[] = {{\"unedited\", 1, \"edits\"}, {\"three\", 4, \"edits\"}, "
                         "{\"four\", 9, \"edits\"}, };") != std::string::npos);
}

TEST_CASE("an edit fits behind a switch if it leaves the code around it as it was") {
  struct Row {
    const char* old_line;
    const char* new_line;
    const char* switched;  ///< empty: it does not fit
  };
  const Row row = GENERATE(
      Row{"f(x);", "g(x);", "if (canary::is_acting(7)) {\ng(x);\n} else { f(x); }\n"},
      Row{"if (x) return 1;", "", "if (canary::is_acting(7)) {\n} else { if (x) return 1; }\n"},
      Row{"x.y = 1;", "if (z) x.y = 2;",
          "if (canary::is_acting(7)) {\nif (z) x.y = 2;\n} else { x.y = 1; }\n"},
      Row{"return 1;  // why", "return 2;",
          "if (canary::is_acting(7)) {\nreturn 2;\n} else { return 1; }\n"},
      Row{"const auto& x = f(y);", "const auto& x = g(y);",
          "const auto& x = canary::is_acting(7) ? (g(y)) : (f(y));\n"},
      Row{"if (a < b) {", "if (a > b) {", "if (canary::is_acting(7) ? (a > b) : (a < b)) {\n"},
      Row{"const int x = 1;", "", ""}, Row{"const int x = 1;", "const int y = 1;", ""},
      Row{"const X x = {1};", "const X x = {2};", ""}, Row{"X x{1};", "X x{2};", ""},
      Row{"const int x = 1;", "const int x = 1;\nreturn x;", ""},
      Row{"constexpr int x = 1;", "constexpr int x = 2;", ""},
      Row{"for (int i = 0; i < 2; ++i) {", "for (int i = 1; i < 2; ++i) {", ""},
      Row{"f(x,", "g(x,", ""}, Row{"f(x);", "if (y) {", ""});
  CAPTURE(row.old_line, row.new_line);
  const auto new_lines = *row.new_line == 0 ? std::string() : std::string(row.new_line) + "\n";
  const canary::Edit edit{"bug", "why", "a.cpp", row.old_line, new_lines, 7};
  const std::string text = std::string("{\n  ") + row.old_line + "\n}\n";
  const bool fits = *row.switched != 0;
  CHECK(canary::fits_switch(edit, text) == fits);
  if (fits) CHECK(canary::switched({&edit, 1}, text) == std::string("{\n") + row.switched + "}\n");
}

TEST_CASE("a line within a statement, or before an else, does not fit behind a switch") {
  const canary::Edit edit{"bug", "why", "a.cpp", "f(x);", "g(x);\n", 7};
  CHECK(canary::fits_switch(edit, "a();\nf(x);\nb();\n"));
  CHECK_FALSE(canary::fits_switch(edit, "y = x +\n    f(x);\n"));
  CHECK_FALSE(canary::fits_switch(edit, "for (;;)\n  f(x);\n"));
  CHECK_FALSE(canary::fits_switch(edit, "if (y)\n  f(x);\nelse\n  g(x);\n"));
}

TEST_CASE("edits are those in a folder, or in one file") {
  const char* const table = "wrong_two: two is three\nsrc/a.cpp\n-int two = 2;\n+int two = 3;\n";
  for (const char* path : {"src", "src/a.cpp"}) {
    CHECK(plant(table, kSource, path).out.find("two = canary::is_acting") != std::string::npos);
  }
  for (const char* path : {"sr", "src/a.cp", "src/b.cpp"}) {
    CHECK(plant(table, kSource, path).out.find("namespace") == std::string::npos);
  }
}

TEST_CASE(
    "each root that has a bug may give it a name of its own, and each copy its include guard") {
  const char* const guarded = "#define MANIFUZZ_A_INL\nnamespace manifuzz { }\nint two = 2;\n";
  const auto planted =
      plant("wrong_two: why\nsrc/a.cpp\n-int two = 2;\n+int three = 3;\n", guarded, "src", "_in_a");
  CHECK(planted.out.find("namespace manifuzz::planted::wrong_two_in_a { }") != std::string::npos);
  CHECK(planted.out.find("#define MANIFUZZ_A_INL_wrong_two_in_a\n") != std::string::npos);
}

TEST_CASE("a source that is not copied is not included") {
  const auto planted = plant("bug: why\nsrc/a.cpp\n-f();\n+g();\n",
                             "#include \"b.cpp\"\n#include \"b.hpp\"\nf();\n");
  CHECK(planted.out.find("#include \"b.cpp\"") == std::string::npos);
  CHECK(planted.out.find("#include \"b.hpp\"") != std::string::npos);
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
