#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "support/run_program.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// scripts/libfuzzer over small colliders, with the libraries of this build.

using namespace manifuzz::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A collider of polygons in C, whose `manifuzz_collide` does this.
std::string collider(const std::string& does) {
  return "#include <stdlib.h>\n#include \"manifuzz_collider.h\"\n"
         "const manifuzz_declaration manifuzz_collider = {.interface = MANIFUZZ_INTERFACE,\n"
         "  .name = \"tiny\", .version = \"1\", .vertices_max = 8, .takes_radius = 1};\n"
         "int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b,\n"
         "                     manifuzz_manifold* m) {\n"
         "  (void)a, (void)b, (void)m;\n" +
         does + "\n}\n";
}

Outcome script(const std::vector<std::string>& arguments, const std::string& variable = {}) {
  std::vector<std::string> command{"env", std::string("MANIFUZZ_BUILD=") + MANIFUZZ_BUILD_DIR};
  if (!variable.empty()) command.push_back(variable);
  command.push_back((source_dir() / "scripts/libfuzzer").string());
  return run_program(with(command, arguments));
}

/// Runs it over that source in a folder, the program being built there.
Outcome fuzz(const TemporaryFolder& folder, const std::string& source,
             const std::vector<std::string>& run) {
  const std::string file = folder.write("tiny.c", source);
  return script(with({"--folder", (folder.path() / "kept").string(), file}, run));
}

/// Says why where it cannot run here.
bool cannot_run() {
#if defined(__SANITIZE_ADDRESS__)
  skip("this build has another compiler's sanitizers");
  return true;
#else
  const TemporaryFolder folder;
  const std::string source =
      folder.write("empty.cpp",
                   "extern \"C\" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) {"
                   " return 0; }\n");
  const Outcome built = run_program(
      {"sh", "-c", "clang++-14 -fsanitize=fuzzer " + source + " -o " + source + ".out"});
  if (built.status != 0) skip("clang 14's libFuzzer is missing; scripts/setup --sanitizers has it");
  return built.status != 0;
#endif
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code unknown;
  for (const auto& entry : fs::directory_iterator(folder, unknown)) files.push_back(entry.path());
  return files;
}

bool has_artifact(const fs::path& folder, const std::string& prefix) {
  return std::ranges::any_of(entries_of(folder), [&](const fs::path& file) {
    return file.filename().string().starts_with(prefix);
  });
}

}  // namespace

TEST_CASE("wrong answers are saved once a bucket, and only the collider guides libFuzzer") {
  if (cannot_run()) return;
  const TemporaryFolder folder;
  const std::vector<std::string> run{"-runs=2000", "-seed=1"};
  const Outcome outcome = fuzz(folder, collider("return 0;"), run);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("Done 2000 runs"));
  CHECK_THAT(outcome.err, Contains(" cov: 1 ft: 1 "));  // of its one block alone
  const auto found = entries_of(folder.path() / "kept" / "findings");
  CHECK(found.size() > 3);
  for (const fs::path& file : found) {
    const manifuzz::CorpusCase saved = manifuzz::read_case_file(file.string());
    REQUIRE(saved.expect);
    CHECK_THAT(saved.expect->bucket, Contains("subject/subject_wrong/missed_contact/"));
    CHECK(saved.expect->subject == "tiny");
  }
  CHECK(fuzz(folder, collider("return 0;"), run).status == 0);  // nothing is new
}

TEST_CASE("a run stops at the first wrong answer where it is told to") {
  if (cannot_run()) return;
  const TemporaryFolder folder;
  const Outcome outcome = fuzz(folder, collider("return 0;"), {"-runs=2000", "--stop"});
  CHECK(outcome.status == 1);
  CHECK(has_artifact(folder.path() / "kept", "crash-"));
  CHECK(entries_of(folder.path() / "kept" / "findings").size() == 1);
}

TEST_CASE("a crash and a hang of the collider are libFuzzer's findings") {
  if (cannot_run()) return;
  const TemporaryFolder folder;
  const std::vector<std::string> run{"-runs=20000", "-seed=1", "-timeout=1"};
  CHECK(fuzz(folder, collider("if (a->count == 7) abort(); return 1;"), run).status == 1);
  CHECK(has_artifact(folder.path() / "kept", "crash-"));
  const std::string hangs = "volatile int i = 0; while (b->count == 7) ++i; return 1;";
  CHECK(fuzz(folder, collider(hangs), run).status == 1);
  CHECK(has_artifact(folder.path() / "kept", "timeout-"));
}

TEST_CASE("constants that floats are compared with are found") {
  if (cannot_run()) return;
  const TemporaryFolder folder;
  const std::string source =
      collider("if (a->position.x == 1234.567f && b->position.y == a->radius) abort(); return 1;");
  const Outcome outcome = fuzz(folder, source, {"-runs=200000", "-seed=1"});
  CHECK(outcome.status == 1);
  CHECK(has_artifact(folder.path() / "kept", "crash-"));
}

TEST_CASE("a seed repeats its run") {
  if (cannot_run()) return;
  const std::string source = collider(
      "if (a->position.x > b->position.x && a->radius == b->radius) return 1;"
      "return a->count > 5 || a->vertices[0].x < 0.3f ? 1 : 1 + (b->position.y == 7);");
  std::string first;
  for (int run = 0; run < 3; ++run) {
    const TemporaryFolder folder;
    const std::string said = fuzz(folder, source, {"-seed=5", "-runs=5000"}).err;
    const std::size_t done = said.find("#5000\tDONE");
    REQUIRE(done != std::string::npos);
    const std::string counts = said.substr(done, said.find(" lim:", done) - done);
    if (run == 0) first = counts;
    CHECK(counts == first);
  }
}

TEST_CASE("sanitizers watch the collider") {
  if (cannot_run()) return;
  const TemporaryFolder folder;
  const std::string file =
      folder.write("tiny.c", collider("float all[4] = {0}; volatile int i = a->count;"
                                      "return all[i] == 1 ? 0 : 1;"));
  const Outcome outcome = script({"--sanitize", "--folder", (folder.path() / "kept").string(), file,
                                  "-runs=2000", "-detect_leaks=0"});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("out of bounds"));
}

TEST_CASE("corpus cases go into libFuzzer's corpus, and come back") {
  if (cannot_run()) return;
  const TemporaryFolder folder;
  const fs::path cases = folder.path() / "cases";
  manifuzz::write_corpus_case(cases, {.any = manifuzz::generate(1, manifuzz::regimes()[0], 0)});
  manifuzz::write_corpus_case(
      cases, {.any = manifuzz::generate(1, manifuzz::round_regimes()[0], 0)});  // not asked
  const std::string bytes = (folder.path() / "bytes").string();
  const std::string again = (folder.path() / "again").string();
  const Outcome from =
      fuzz(folder, collider("return 1;"), {"--from", cases.string(), bytes, "-runs=0"});
  CHECK(from.status == 0);
  CHECK_THAT(from.err, Contains("1 case to begin with, 1 left out"));
  CHECK(entries_of(bytes).size() == 1);
  const Outcome written = fuzz(folder, collider("return 1;"), {"--to-json", again, bytes});
  CHECK(written.status == 0);
  REQUIRE(entries_of(again).size() == 1);
  CHECK(fs::exists(cases / entries_of(again).front().filename()));
}

TEST_CASE("libFuzzer's script says in a line what is wrong with what it is given") {
  const TemporaryFolder folder;
  const std::string text = folder.write("collider.txt", "");
  const std::string source = folder.write("tiny.c", collider("return 0;"));
  const auto expect = [](const Outcome& outcome, const std::string& words) {
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK_THAT(outcome.err, Contains(words));
  };
  expect(script({}), "a collider's source is expected");
  expect(script({"missing.cpp"}), "'missing.cpp' is no file");
  expect(script({text}), "neither C nor C++");
  expect(script({"--form", source}), "there is no option '--form'");
  expect(script({"--folder"}), "a path is expected");
  expect(script({source}, "CXX=no-such-compiler"), "scripts/setup --sanitizers");
  expect(script({source}, "LIB_FUZZING_ENGINE=-lno-such-engine"), "cannot link libFuzzer");
}

TEST_CASE("a collider that does not compile or link is shown with the compiler's words") {
  if (cannot_run()) return;
  const TemporaryFolder folder;
  const Outcome broken = fuzz(folder, "int manifuzz_collide(", {});
  CHECK(broken.status == 2);
  CHECK_THAT(broken.err, Contains("error: "));
  CHECK_THAT(broken.err, Contains("does not compile"));
  const Outcome empty = fuzz(folder, "int nothing = 0;", {});
  CHECK(empty.status == 2);
  CHECK_THAT(empty.err, Contains("does not link"));
  const Outcome options = fuzz(folder, collider("return 1;"), {"--from", "nowhere.json"});
  CHECK(options.status == 2);
  CHECK_THAT(options.err, Contains("nowhere.json"));
}
