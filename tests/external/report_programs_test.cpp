#include <cstdlib>
#include <filesystem>
#include <functional>

#include <catch2/catch.hpp>

#include "base/file.hpp"
#include "external/printed_figures.hpp"
#include "external/snippet_programs.hpp"
#include "judging/compare.hpp"
#include "judging/ledger.hpp"
#include "support/installed_collider.hpp"
#include "support/source_tree.hpp"

// The programs of the kept reports print what the reports say that was got, in as many digits.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

struct KeptReport {
  std::string id;
  std::string program;
  std::string got;
  bool is_of_frame = false;  ///< it says that its figures came by way of A's frame
};

/// What stands between two texts; all of it must be there.
std::string between(const std::string& text, const std::string& start, const std::string& end) {
  const std::size_t from = text.find(start);
  REQUIRE(from != std::string::npos);
  const std::size_t to = text.find(end, from + start.size());
  REQUIRE(to != std::string::npos);
  return text.substr(from + start.size(), to - from - start.size());
}

std::vector<KeptReport> reports_on(std::string_view engine) {
  std::vector<KeptReport> reports;
  for (const LedgerEntry& entry : ledger()) {
    if (entry.collider != engine || entry.is_no_bug) continue;
    auto file = source_dir() / "corpus" / witness_of(entry);
    file.replace_extension(".md");
    const std::string text = InputFile(file.string()).read_all();
    const std::string fenced = between(text, "\n```", "\n```\n");
    std::string got = between(text, "\n- Got: ", ".\n");
    const std::size_t read = got.find(" (figures by way of A's frame");
    const bool is_of_frame = read != std::string::npos;
    if (is_of_frame) got.erase(read);
    if (got.starts_with("no answer")) continue;  // a program that never ends
    reports.push_back({.id = std::string(entry.id),
                       .program = fenced.substr(fenced.find('\n') + 1) + '\n',
                       .got = got,
                       .is_of_frame = is_of_frame});
  }
  return reports;
}

void check_prints(const KeptReport& report, const Outcome& ran, bool is_float) {
  CAPTURE(report.id, report.got, ran.out, ran.err);
  const std::string_view killed = "was killed by signal ";
  if (report.got.starts_with(killed)) {
    CHECK(ran.status == 128 + std::atoi(report.got.c_str() + killed.size()));  // as a shell has it
    return;
  }
  CHECK(ran.status == 0);
  const int roundings = report.is_of_frame ? 4 : 0;
  CHECK(figures_not_printed(report.got, ran.out, is_float, roundings) ==
        std::vector<std::string>{});
  if (report.got == "no contact") {
    const bool is_said = ran.out.find("no contact") != std::string::npos ||
                         ran.out.find("0 points") != std::string::npos;
    CHECK(is_said);
  }
}

using Run = std::function<std::vector<Outcome>(const std::vector<std::string>&)>;

void check_reports(std::string_view engine, const Run& run) {
  const auto collider = collider_with_ledger(engine);
  if (!collider) return;
  const std::vector<KeptReport> reports = reports_on(engine);
  REQUIRE(!reports.empty());
  std::vector<std::string> programs;
  for (const KeptReport& report : reports) programs.push_back(report.program);
  const std::vector<Outcome> ran = run(programs);
  REQUIRE(ran.size() == reports.size());
  const bool is_float = collider->declaration.scalar == ScalarType::float32;
  for (std::size_t i = 0; i < reports.size(); ++i) check_prints(reports[i], ran[i], is_float);
}

std::string quoted_in_engine(std::string_view engine, std::string_view file) {
  return "'" + in_engine(engine, file).string() + "'";
}

Run cpp(const std::string& with) {
  return [with](const auto& programs) {
    return run_at_once(programs, kCpp,
                       MANIFUZZ_COMPILE_CPP " '{file}' -o '{folder}/snippets' " + with,
                       "'{folder}/snippets' {}");
  };
}

Run each(const std::string& file, const std::string& command,
         const std::vector<std::string>& links = {}) {
  return [=](const auto& programs) { return run_each(programs, file, command, links); };
}

Run c(const std::string& with) {
  return each("snippet.c", "cc '{file}' -o '{folder}/snippet' " + with + " && '{folder}/snippet'");
}

Run script(std::string_view engine) {
  return each("snippet.mjs", "node '{file}'", {in_engine(engine, "node_modules").string()});
}

const std::string kCrates = "\"$HOME\"/.cargo/registry/src/*/";

}  // namespace

TEST_CASE("kept reports on Box2D and Chipmunk print what was got") {
  check_reports("box2d", cpp(MANIFUZZ_COMPILE_WITH_BOX2D " " MANIFUZZ_LINK_WITH_BOX2D));
  check_reports("chipmunk", cpp("-lchipmunk"));
}

TEST_CASE("kept reports on Bullet print what was got") {
  for (const char* const engine :
       {"bullet-epa", "bullet-minkowski", "bullet-convex2d", "bullet-perturbed"}) {
    check_reports(engine, cpp("$(pkg-config --cflags --libs bullet)"));
  }
}

TEST_CASE("kept reports on libccd, Box2D 3 and cute_c2 print what was got") {
  const std::string built = quoted_in_engine("box2d3", "adapter/target/release/build");
  check_reports("libccd-gjk", c("$(pkg-config --cflags --libs ccd) -lm"));
  check_reports("libccd-mpr", c("$(pkg-config --cflags --libs ccd) -lm"));
  check_reports("box2d3", c("-I " + kCrates + "boxdd-sys-0.6.0/third-party/box2d/include " + built +
                            "/boxdd-sys-*/out/*.a -lm -lpthread"));
  check_reports("cute_c2", c("-I " + kCrates + "c2-sys-0.1.0/cute-header " + kCrates +
                             "c2-sys-0.1.0/cute-header/cute_c2.c -lm"));
}

TEST_CASE("kept reports on parry print what was got") {
  const std::string built = quoted_in_engine("parry2d", "adapter/target/release/deps");
  for (const auto& [engine, crate] : {std::pair<std::string, std::string>{"parry2d", "parry2d"},
                                      {"parry2d-simplified", "parry2d"},
                                      {"parry2d-f64", "parry2d_f64"}}) {
    const std::string compile = "rustc --edition 2024 -C panic=abort -L " + built +
                                " '{file}' -o '{folder}/snippets' --extern " + crate + "=$(ls " +
                                built + "/lib" + crate + "-*.rlib)";
    check_reports(engine, [compile](const auto& programs) {
      return run_at_once(programs, kRust, compile, "'{folder}/snippets' {}");
    });
  }
}

TEST_CASE("kept reports on engines in JavaScript print what was got") {
  for (const char* const engine : {"planck", "phaser-box2d", "box2d-core", "matter-js", "nape-js",
                                   "p2-es", "sat", "rapier2d", "rapier2d-contact"}) {
    check_reports(engine, script(engine));
  }
}

TEST_CASE("kept reports on dyn4j and jbox2d print what was got") {
  for (const char* const engine : {"dyn4j-sat", "dyn4j-gjk", "jbox2d"}) {
    check_reports(engine, [engine](const auto& programs) {
      const std::string installed =
          "'" + in_engine(engine, "installed").string() + "/*':'{folder}'";
      return run_at_once(programs, kJava, "javac -d '{folder}' -cp " + installed + " '{file}'",
                         "java -cp " + installed + " Snippets {}");
    });
  }
}

TEST_CASE("kept reports on pymunk, cp and Godot print what was got") {
  check_reports("pymunk", each("snippet.py",
                               quoted_in_engine("pymunk", "installed/bin/python") + " '{file}'"));
  check_reports("cp", each("snippet.go", "cd '{folder}' && go run '{file}'",
                           {in_engine("cp", "adapter/go.mod").string(),
                            in_engine("cp", "adapter/go.sum").string()}));
  check_reports("godot3",
                each("snippet.gd", "cd '{folder}' && godot3-server --no-window -s '{file}'"));
}

TEST_CASE("a wrong digit in a report is not printed") {
  const std::string got =
      "normal (0.707106781, -1) from B to A; point1 (2, 1.5e-07), distance -0.25; point1 (3, 4), "
      "distance 0.5";
  const std::string printed =
      "2 points, normal { x: 0.70710678118654, y: -1 } [ 2, 1.5000000001e-7 ] -0.25 [ 3, 4 ] 0.5";
  CHECK(figures_not_printed(got, printed, false).empty());
  CHECK(figures_not_printed("normal (1, 0) of length 1 - 2e-09; depth of 0 or above", "1 0", false)
            .empty());
  int changed = 0;
  for (std::size_t i = 1; i < got.size(); ++i) {
    if (got[i] < '0' || got[i] > '9' || got[i - 1] == 't') continue;
    std::string wrong = got;
    wrong[i] = wrong[i] == '9' ? '8' : static_cast<char>(wrong[i] + 1);
    CAPTURE(wrong);
    CHECK(figures_not_printed(wrong, printed, false).size() == 1);
    ++changed;
  }
  CHECK(changed > 15);
  // The coordinates of a place stand in their order, of one place.
  CHECK(figures_not_printed("(1, 2)", "2 1", false).size() == 1);
  CHECK(figures_not_printed("(1, 2)", "1 3 2", false).size() == 1);
  // Four roundings of the largest figure, and no more.
  CHECK(figures_not_printed("0.500000476", "0.5, 1", true, 4).empty());
  CHECK(figures_not_printed("0.500000478", "0.5, 1", true, 4).size() == 1);
}
