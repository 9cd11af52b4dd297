#include "external/snippet_programs.hpp"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "report/upstream/program.hpp"
#include "report/words.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace manifuzz::test {
namespace {

namespace fs = std::filesystem;

enum class ShapeKind { circle, segment, capsule, polygon, rounded };
constexpr std::array kShapeKinds{ShapeKind::circle, ShapeKind::segment, ShapeKind::capsule,
                                 ShapeKind::polygon, ShapeKind::rounded};

ConvexPolygon<float> shape_of(ShapeKind kind, const Declaration& declaration) {
  const std::array<Vector2<float>, 4> corners{Vector2<float>(-1, -1), Vector2<float>(1, -1),
                                              Vector2<float>(1, 1), Vector2<float>(-1, 1)};
  const std::array<Vector2<float>, 2> ends{Vector2<float>(-1, 0.75F), Vector2<float>(1, 0.75F)};
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  if (kind == ShapeKind::circle) return make_polygon<float>(center, 1.0F);
  if (kind == ShapeKind::segment) return make_polygon<float>(ends, 0.0F);
  if (kind == ShapeKind::capsule) return make_polygon<float>(ends, 0.25F);
  if (kind == ShapeKind::polygon) {
    return make_polygon<float>(corners, declaration.takes_radius ? 0.01F : 0.0F);
  }
  ConvexPolygon<float> rounded = make_polygon<float>(corners, 0.125F);
  rounded.rounding = Rounding::round;
  return rounded;
}

/// Two shapes, the second turned a little, above the first and into it.
PairCase pair_of(ShapeKind a, ShapeKind b, const Declaration& declaration) {
  PairCase pair{{shape_of(a, declaration), {}}, {shape_of(b, declaration), {}}};
  const bool is_long = b == ShapeKind::segment || b == ShapeKind::capsule;
  pair.b.pose.position = {0.25F, is_long ? 0.2F : 1.7F};
  pair.b.pose.rotation = {0.9998F, 0.02F};
  return pair;
}

/// A pair that the collider takes, what it answers, and the program that asks for it.
struct SnippetCase {
  Answer answer;
  std::string program;
};

std::vector<SnippetCase> cases_for(const Collider& collider) {
  std::vector<SnippetCase> cases;
  for (const ShapeKind a : kShapeKinds) {
    for (const ShapeKind b : kShapeKinds) {
      const PairCase pair = pair_of(a, b, collider.declaration);
      const Answer answer = ask(collider, pair);
      if (manifold_in(answer) == nullptr && !std::holds_alternative<Penetration>(answer)) continue;
      cases.push_back({answer, filled_in(collider.declaration.snippet, pair)});
    }
  }
  return cases;
}

/// What the program says of the contact; SAT.js and libccd have no points.
std::string said_of(const Answer& answer) {
  if (const auto* const found = std::get_if<Penetration>(&answer)) {
    return found->touches ? "they touch" : "no contact";
  }
  return std::to_string(manifold_in(answer)->count) + " points";
}

std::vector<double> depths_of(const Answer& answer) {
  if (const auto* const found = std::get_if<Penetration>(&answer)) {
    return found->touches ? std::vector{found->depth} : std::vector<double>{};
  }
  std::vector<double> depths;
  const Manifold<double>& manifold = *manifold_in(answer);
  for (int i = 0; i < manifold.count; ++i) depths.push_back(manifold.points[i].depth);
  return depths;
}

/// Whether it stands in the text as a number, of either sign.
bool is_printed(double depth, const std::string& text) {
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end != at && std::abs(std::abs(number) - depth) <= 1e-5) return true;
    at = end == at ? at + 1 : end;
  }
  return false;
}

void check_output(const SnippetCase& asked, const Outcome& ran, const Prints& prints) {
  INFO(asked.program << ran.err << ran.out);
  for (const char* const left : {"@a.", "@b.", "@*", "@^", "@each", "@asked"}) {
    CHECK(asked.program.find(left) == std::string::npos);
  }
  CHECK(ran.status == 0);
  if (prints.has_count) CHECK(ran.out.find(said_of(asked.answer)) != std::string::npos);
  if (!prints.has_depths) return;
  for (const double depth : depths_of(asked.answer)) {
    CAPTURE(depth);
    CHECK(is_printed(depth, ran.out));
  }
}

void check_touching(const std::vector<SnippetCase>& cases, const Prints& prints) {
  const auto touches = [](const SnippetCase& asked) { return !depths_of(asked.answer).empty(); };
  CHECK(std::ranges::count_if(cases, touches) >= prints.least_touching);
}

std::string all_in_one(const std::vector<std::string>& texts, const Language& language) {
  std::string top;
  std::string programs;
  std::string chosen(language.begin);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    programs += fmt::format("{} case_{} {{\n", language.space, i);
    for (std::string line : lines_of(texts[i])) {
      boost::replace_all(line, language.main, language.run);
      const bool is_top = !language.top.empty() && line.starts_with(language.top);
      if (!is_top || i == 0) (is_top ? top : programs) += line + '\n';
    }
    programs += "}\n";
    chosen += fmt::format(fmt::runtime(language.choose), i) + '\n';
  }
  return top + programs + chosen + std::string(language.end);
}

Outcome run_in_shell(std::string command, const std::string& file, const TemporaryFolder& folder) {
  boost::replace_all(command, "{folder}", folder.path().string());
  boost::replace_all(command, "{file}", (folder.path() / file).string());
  return run_program({"sh", "-c", command});
}

std::vector<std::string> programs_of(const std::vector<SnippetCase>& cases) {
  std::vector<std::string> programs;
  for (const SnippetCase& asked : cases) programs.push_back(asked.program);
  return programs;
}

void check_outputs(const std::vector<SnippetCase>& cases, const std::vector<Outcome>& ran,
                   const Prints& prints) {
  REQUIRE(ran.size() == cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) check_output(cases[i], ran[i], prints);
  check_touching(cases, prints);
}

}  // namespace

std::vector<Outcome> run_each(const std::vector<std::string>& programs, const std::string& file,
                              const std::string& command, const std::vector<std::string>& links) {
  const TemporaryFolder folder;
  for (const fs::path link : links) fs::create_symlink(link, folder.path() / link.filename());
  std::vector<Outcome> ran;
  for (const std::string& program : programs) {
    std::ofstream(folder.path() / file) << program;
    ran.push_back(run_in_shell(command, file, folder));
  }
  return ran;
}

void check_programs(const Collider& collider, const std::string& file, const std::string& command,
                    const Prints& prints, const std::vector<std::string>& links) {
  INFO(collider.declaration.name);
  const std::vector<SnippetCase> cases = cases_for(collider);
  check_outputs(cases, run_each(programs_of(cases), file, command, links), prints);
}

const Language kCpp{"snippets.cpp",
                    "#include",
                    "int main() {",
                    "void run() {",
                    "namespace",
                    "#include <cstdlib>\nint main(int, char** words) {\n",
                    "if (atoi(words[1]) == {0}) case_{0}::run();",
                    "}\n"};

const Language kJava{"Snippets.java",
                     "import",
                     "public class Snippet {",
                     "class Snippet {",
                     "interface",
                     "class Snippets {\npublic static void main(String[] words) {\n",
                     "if (words[0].equals(\"{0}\")) case_{0}.Snippet.main(words);",
                     "}\n}\n"};

const Language kRust{"snippets.rs",
                     "",
                     "fn main() {",
                     "pub fn main() {",
                     "mod",
                     "fn main() {\nlet asked = std::env::args().nth(1).unwrap();\n",
                     "if asked == \"{0}\" {{ case_{0}::main() }}",
                     "}\n"};

std::vector<Outcome> run_at_once(const std::vector<std::string>& programs, const Language& language,
                                 const std::string& compile, const std::string& run) {
  const TemporaryFolder folder;
  const std::string file(language.file);
  std::ofstream(folder.path() / file) << all_in_one(programs, language);
  const Outcome compiled = run_in_shell(compile, file, folder);
  INFO(compiled.err);
  REQUIRE(compiled.status == 0);
  std::vector<Outcome> ran;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    std::string command = run;
    boost::replace_all(command, "{}", std::to_string(i));
    ran.push_back(run_in_shell(command, file, folder));
  }
  return ran;
}

void check_at_once(const Collider& collider, const Language& language, const std::string& compile,
                   const std::string& run, const Prints& prints) {
  INFO(collider.declaration.name);
  const std::vector<SnippetCase> cases = cases_for(collider);
  check_outputs(cases, run_at_once(programs_of(cases), language, compile, run), prints);
}

}  // namespace manifuzz::test
