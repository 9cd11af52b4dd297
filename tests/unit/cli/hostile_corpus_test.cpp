#include <filesystem>
#include <map>
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "support/bad_cases.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

// Folders of cases that hold what is no case: commands that read them end, and say what they left.

using namespace manifuzz::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A program that hangs is ended, which is status 124.
Outcome run_that_ends(const std::vector<std::string>& arguments) {
  return run_program(with({"timeout", "100", manifuzz_path()}, arguments));
}

Outcome fuzz_with(const TemporaryFolder& folder) {
  return run_that_ends({"fuzz", "--corpus", folder.path().string(), "--no-save", "--cases", "100",
                        "--seed", "1", "--jobs", "1"});
}

/// The good case is replayed; of the others there is a line each, as the map has them in order.
void check_replay(const TemporaryFolder& folder, const std::map<std::string, std::string>& broken) {
  const Outcome outcome = run_that_ends({"replay", folder.path().string()});
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.status == (broken.empty() ? 0 : 2));
  CHECK_THAT(outcome.out, Contains("1 case, 1 passed, 0 failed"));
  const auto lines = lines_of(outcome.err);
  REQUIRE(lines.size() == (broken.empty() ? 0 : broken.size() + 1));
  std::size_t i = 0;
  for (const auto& [file, complaint] : broken) {
    CHECK(is_one_clear_line(lines[i] + "\n"));
    CHECK_THAT(lines[i], Catch::StartsWith("manifuzz: " + (folder.path() / file).string() + ":") &&
                             Contains(complaint));
    ++i;
  }
}

/// A campaign does not begin: one line names the first of them.
void check_fuzz_refuses(const TemporaryFolder& folder, const std::string& complaint) {
  const Outcome outcome = fuzz_with(folder);
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains(complaint));
}

std::string nested(const std::string& open, const std::string& inside, const std::string& close) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += open;
  text += inside;
  for (int i = 0; i < 100'000; ++i) text += close;
  return text;
}

/// A good case but for a coordinate.
std::string with_number(const std::string& number) {
  return R"({"format": "manifuzz/case/1", "a": {"vertices": [[0,0],[1,0],[0,1]]}, )"
         R"("b": {"vertices": [[0,0],[1,0],[0,1]], "position": [)" +
         number + ", 0]}}";
}

}  // namespace

TEST_CASE("pipes, devices and links to them in a folder of cases are passed over") {
  const TemporaryFolder folder;
  folder.write("good.json", good_case());
  REQUIRE(mkfifo((folder.path() / "pipe.json").c_str(), 0600) == 0);
  REQUIRE(mkfifo((folder.path() / "pipe.jsonl").c_str(), 0600) == 0);
  for (const char* const ending : {".json", ".jsonl"}) {
    fs::create_symlink("pipe.json", folder.path() / (std::string("to-pipe") + ending));
    for (const char* const device : {"zero", "full", "null", "random", "tty"}) {
      fs::create_symlink(std::string("/dev/") + device,
                         folder.path() / (device + std::string(ending)));
    }
  }
  fs::create_symlink("/dev/zero", folder.path() / "subjects.json");
  check_replay(folder, {});
  const Outcome outcome = fuzz_with(folder);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("links to themselves, each other and folders above end no walk, and are a line each") {
  const TemporaryFolder folder;
  folder.write("good.json", good_case());
  fs::create_directory(folder.path() / "below");
  fs::create_symlink("..", folder.path() / "below/up");
  fs::create_symlink(".", folder.path() / "here");
  fs::create_symlink("/", folder.path() / "root");
  fs::create_symlink("here.json", folder.path() / "here.json");
  fs::create_symlink("tock.json", folder.path() / "tick.json");
  fs::create_symlink("tick.json", folder.path() / "tock.json");
  fs::create_symlink("below", folder.path() / "folder.json");
  check_replay(folder, {{"folder.json", "is a folder; a file is expected"},
                        {"here.json", "Too many levels of symbolic links"},
                        {"tick.json", "Too many levels of symbolic links"},
                        {"tock.json", "Too many levels of symbolic links"}});
  check_fuzz_refuses(folder, "folder.json: is a folder");
}

TEST_CASE("files of a gigabyte of nothing are not read to their end, or a line at a time") {
  const TemporaryFolder folder;
  folder.write("good.json", good_case());
  fs::resize_file(folder.write("sparse.json", ""), std::uintmax_t{1} << 30);
  fs::resize_file(folder.write("sparse.jsonl", ""), std::uintmax_t{64} << 20);
  check_replay(folder, {{"sparse.json", "is larger than 1 MiB; that is too much to read"},
                        {"sparse.jsonl", ":1: longer than 1 MiB; one case a line is expected"}});
  check_fuzz_refuses(folder, "sparse.json: is larger than 1 MiB");
}

TEST_CASE("cases nested 100,000 deep are a line each, in files of one and of many") {
  const TemporaryFolder folder;
  folder.write("good.json", good_case());
  const std::map<std::string, std::string> texts{
      {"arrays", nested("[", "", "]")},
      {"note", with_number("0").insert(1, R"("note": )" + nested("[", "", "]") + ", ")},
      {"objects", nested(R"({"a": )", "1", "}")},
      {"open", nested("[", "", "")}};
  std::map<std::string, std::string> broken;
  for (const auto& [name, text] : texts) {
    for (const char* const ending : {".json", ".jsonl"}) {
      folder.write(name + ending, text + "\n");
      broken[name + ending] = "nested deeper than 32 levels";
    }
  }
  check_replay(folder, broken);
  check_fuzz_refuses(folder, "arrays.json: $: nested deeper than 32 levels");
}

TEST_CASE("numbers that are none, or beyond all, are a line each, in files of one and of many") {
  const TemporaryFolder folder;
  folder.write("good.json", good_case());
  const std::map<std::string, std::string> complaints{
      {"1e999", "1e999 is beyond the largest number"},
      {"-1e999", "-1e999 is beyond the largest number"},
      {"1e39", "beyond the largest float"},
      {"nan", "numbers must be finite"},
      {"-NaN", "numbers must be finite"},
      {"Infinity", "numbers must be finite"},
      {"1e99999999999999999999", "is beyond the largest number"}};
  std::map<std::string, std::string> broken;
  for (const auto& [number, complaint] : complaints) {
    for (const char* const ending : {".json", ".jsonl"}) {
      const std::string name = "is" + number + ending;
      folder.write(name, with_number(number) + "\n");
      broken[name] = complaint;
    }
  }
  check_replay(folder, broken);
  check_fuzz_refuses(folder, ".json: ");
}

TEST_CASE("subjects that are too much to read are one clear line that names them once") {
  const TemporaryFolder folder;
  folder.write("good.json", good_case());
  const std::string subjects = folder.write("subjects.json", "");
  const auto check = [&](const std::string& complaint) {
    const Outcome outcome = run_that_ends({"replay", folder.path().string()});
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK_THAT(outcome.err, Catch::EndsWith("subjects.json: " + complaint + "\n"));
    CHECK(outcome.err.find("subjects.json") == outcome.err.rfind("subjects.json"));
  };
  fs::resize_file(subjects, std::uintmax_t{1} << 30);
  check("is larger than 1 MiB; that is too much to read");
  folder.write("subjects.json", nested("[", "", "]"));
  check("$: nested deeper than 32 levels");
}
