#include <filesystem>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "corpus/corpus.hpp"
#include "support/bad_cases.hpp"
#include "support/permissions.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;

namespace {

Outcome collide(const std::string& input) {
  return run_manifuzz({"collide", "--collider", "clip"}, input);
}

Outcome collide_file(const std::string& path) {
  return run_manifuzz({"collide", "--collider", "clip", path});
}

/// Nothing but one clear line on stderr, which contains `complaint`, and status 2.
void check_refused(const Outcome& outcome, const std::string& complaint) {
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(is_one_clear_line(outcome.err));
  CHECK(outcome.err.find(complaint) != std::string::npos);
}

/// The error's line stands for the bad case at `line`.
void check_error_line(const std::string& text, int line, const std::string& complaint) {
  INFO(text);
  const auto answer = nlohmann::json::parse(text, nullptr, false);
  REQUIRE(answer.is_object());
  CHECK(answer.size() == 2);
  CHECK(answer.value("error", "").find(complaint) != std::string::npos);
  CHECK(answer.value("line", 0) == line);
}

void check_as_file(const BadCase& row) {
  const TemporaryFolder folder;
  const Outcome outcome = collide_file(folder.write("case.json", row.text));
  CAPTURE(row.name, outcome.err);
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK(outcome.err.find("/case.json: ") != std::string::npos);
  CHECK(outcome.err.find(row.complaint) != std::string::npos);
}

}  // namespace

TEST_CASE("collide answers a bad line by its error, and the lines around it as ever",
          "[bad-input]") {
  const Outcome plain = collide(good_case() + "\n");
  REQUIRE(plain.status == 0);
  const std::vector<BadCase> bad = bad_case_of_each_kind();
  std::string input = good_case() + "\n";
  for (const BadCase& row : bad) input += row.text + "\n" + good_case() + "\n";
  const Outcome outcome = collide(input);
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK(outcome.err.starts_with("manifuzz: stdin:2: "));
  CHECK(outcome.err.find(bad[0].complaint) != std::string::npos);
  CHECK(outcome.err.find("(7 bad of 15)") != std::string::npos);
  const auto lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 15);
  for (std::size_t i = 0; i < lines.size(); i += 2) CHECK(lines[i] + "\n" == plain.out);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    check_error_line(lines[2 * i + 1], static_cast<int>(2 * i + 2), bad[i].complaint);
  }
}

TEST_CASE("collide refuses a bad file by its name and what is wrong", "[bad-input]") {
  for (const BadCase& row : bad_case_of_each_kind()) check_as_file(row);
}

TEST_CASE("collide refuses an empty input", "[bad-input]") {
  check_refused(collide(""), "stdin: is empty; one case a line is expected");
}

TEST_CASE("collide refuses blank lines alone", "[bad-input]") {
  check_refused(collide("\n \t\n\r\n"), "is empty");
}

TEST_CASE("collide refuses an empty file", "[bad-input]") {
  const TemporaryFolder folder;
  check_refused(collide_file(folder.write("a.jsonl", "")), "a.jsonl: is empty");
  const Outcome outcome = collide_file(folder.write("a.json", ""));
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
}

TEST_CASE("collide refuses a folder", "[bad-input]") {
  const TemporaryFolder folder;
  check_refused(collide_file(folder.path()), "is a folder; a file is expected");
  std::filesystem::create_directory(folder.path() / "a.json");
  check_refused(collide_file(folder.path() / "a.json"), "is a folder; a file is expected");
}

TEST_CASE("collide refuses a file that is not there", "[bad-input]") {
  check_refused(collide_file("/nowhere/a.json"), "/nowhere/a.json: cannot open it: No such file");
}

TEST_CASE("collide refuses a file without permission", "[bad-input]") {
  const BoundByPermissions bound;
  const TemporaryFolder folder;
  const std::string path = folder.write("a.jsonl", good_case());
  chmod(path.c_str(), 0);
  check_refused(collide_file(path), "Permission denied");
}

TEST_CASE("collide escapes the odd name of a file", "[bad-input]") {
  check_refused(collide_file("/nowhere/\x1b[31m\n.json"), "\\x1b[31m\\x0a");
}

TEST_CASE("collide refuses a binary file of many lines", "[bad-input]") {
  std::string noise;
  for (unsigned i = 1; i < 100000; ++i) noise += static_cast<char>(i * 2654435761U >> 24);
  const Outcome outcome = collide(noise);
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  const auto lines = lines_of(outcome.out);
  CHECK(lines.size() > 100);
  for (const auto& line : lines) CHECK(is_one_clear_line(line + "\n"));
}

TEST_CASE("collide refuses a case file that does not name its format", "[bad-input]") {
  const std::string text =
      R"({"a": {"vertices": [[0,0],[1,0],[0,1]]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}})";
  CHECK(collide(text).status == 0);
  const TemporaryFolder folder;
  const Outcome outcome = collide_file(folder.write("a.json", text));
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK(outcome.err.find("\"format\" is missing") != std::string::npos);
}

TEST_CASE("collide says why an answer is nonsense, as fuzz does", "[bad-input]") {
  const std::string negative =
      R"(while read -r line; do echo '{"points": [{"position": [0, 0], "depth": -0.25}], )"
      R"("normal": [0, 1]}'; done)";
  const std::string why = "point 0: depth -0.25 is below 0; 0 or more is expected";
  const Outcome generated = run_manifuzz({"generate", "--seed", "1", "--cases", "1"});
  const Outcome collided = run_manifuzz({"collide", "--collider-command", negative}, generated.out);
  INFO(collided.out << collided.err);
  CHECK(collided.status == 2);
  REQUIRE(lines_of(collided.out).size() == 1);
  check_error_line(collided.out, 1, why);
  const TemporaryFolder folder;
  const Outcome fuzzed = run_manifuzz({"fuzz", "--subject-command", negative, "--seed", "1",
                                       "--cases", "1", "--corpus", folder.path().string()});
  INFO(fuzzed.out << fuzzed.err);
  CHECK(fuzzed.status == 1);
  const manifuzz::Corpus saved = manifuzz::read_corpus_folder(folder.path());
  REQUIRE_FALSE(saved.cases.empty());
  CHECK(saved.cases.front().note.find(why) != std::string::npos);
}

TEST_CASE("collide says where numbers overflow in the collider", "[bad-input]") {
  const std::string huge = R"({"a": {"vertices": [[-3e38,-3e38],[3e38,-3e38],[0,3e38]]}, )"
                           R"("b": {"vertices": [[-3e38,-3e38],[3e38,-3e38],[0,3e38]]}})";
  const Outcome outcome = collide(huge);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  REQUIRE(lines_of(outcome.out).size() == 1);
  check_error_line(outcome.out, 1,
                   "clip answers nonsense: point 0: position (nan, nan) is not finite; smaller");
}
