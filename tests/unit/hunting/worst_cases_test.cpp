#include "hunting/worst_cases.hpp"

#include <array>
#include <csignal>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "base/file.hpp"
#include "hunting/journal.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/bad_cases.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

constexpr Gauge kGauge = Gauge::depth_share;

/// A hunt of `clip` whose worst case is the first sliver from that index on of which a depth's
/// share is measured.
Hunt hunt_with_sliver(std::uint64_t index) {
  Hunt hunt;
  hunt.campaign.plan.subject = make_clip();
  hunt.campaign.plan.regimes = {find_regime("sliver")};
  Interruption interruption;
  WorstFound found;
  for (; found.value == 0; ++index) {
    found = {kGauge, 0, generate(77, *find_regime("sliver"), index), 0, {}};
    const auto observed = observed_now(make_clip(), *found.pair, interruption);
    if (observed) found.value = (*observed)[kGauge];
  }
  hunt.worst = {found};
  return hunt;
}

/// Two hunts, of which the second has found the worse case.
std::array<Hunt, 2> lesser_and_worse() {
  std::array<Hunt, 2> hunts{hunt_with_sliver(0), hunt_with_sliver(100)};
  if (hunts[1].worst[0].value < hunts[0].worst[0].value) std::swap(hunts[0], hunts[1]);
  REQUIRE(hunts[0].worst[0].value < hunts[1].worst[0].value);
  return hunts;
}

/// No file of this process grows beyond so many bytes.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFiles& operator=(SmallFiles&&) = delete;  // neither moved nor copied

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("the worst case that is known stays, whichever folder has it") {
  auto [lesser, worse] = lesser_and_worse();
  const TemporaryFolder folder;
  const std::filesystem::path corpus = folder.path() / "corpus";
  const std::filesystem::path found = folder.path() / "found";
  const std::array known{corpus, found};
  const std::string file = worst_file(corpus, "clip", kGauge).string();
  keep_worst(lesser, known, corpus);
  CHECK(lesser.worst[0].file == file);
  keep_worst(worse, known, corpus);
  CHECK(worse.worst[0].file == file);
  CHECK(read_case_file(file).pair() == *worse.worst[0].pair);

  lesser.worst[0].file.clear();
  keep_worst(lesser, known, found);
  CHECK(lesser.worst[0].file.empty());
  worse.worst[0].file.clear();
  keep_worst(worse, known, found);
  CHECK(worse.worst[0].file == file);
  CHECK_FALSE(std::filesystem::exists(found));
}

TEST_CASE("a pipe in place of a worst case is an error, and not waited for") {
  const TemporaryFolder folder;
  const std::array known{folder.path()};
  const std::filesystem::path file = worst_file(folder.path(), "clip", kGauge);
  std::filesystem::create_directories(file.parent_path());
  REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
  Hunt hunt = hunt_with_sliver(0);
  keep_worst(hunt, known, folder.path());
  CHECK(hunt.campaign.saving.unwritten == 1);
  CHECK_THAT(hunt.campaign.saving.first_error, Catch::Contains("is no file"));
  CHECK(hunt.worst[0].file.empty());
}

TEST_CASE("a journal has whole lines alone, also where the disk has been full") {
  const TemporaryFolder folder;
  Journal journal(folder.path().string(), "hunt", 1);
  const auto add = [&](char key) {
    journal.add(std::string(1, key), 0, [&] { return std::string(60, key); });
  };
  {
    const SmallFiles small(100);
    add('a');
    add('b');
  }
  add('c');
  CHECK(InputFile((folder.path() / "hunt-1.jsonl").string()).read_all() ==
        std::string(60, 'a') + "\n" + std::string(60, 'c') + "\n");
}

TEST_CASE("a journal has each greater value of a key, and takes the folder that it made away") {
  const TemporaryFolder folder;
  const std::filesystem::path found = folder.path() / "found";
  Journal journal(found.string(), "hunt", 1);
  const auto add = [&](double value, const std::string& line) {
    journal.add("error", value, [&] { return line; });
  };
  add(1, "one");
  add(1, "one again");
  add(3, "three");
  add(2, "two");
  CHECK(InputFile((found / "hunt-1.jsonl").string()).read_all() == "one\nthree\n");
  SECTION("where nothing else is there") {
    journal.end();
    CHECK_FALSE(std::filesystem::exists(found));
  }
  SECTION("but nothing that is there besides") {
    write_file(found / "other.json", "");
    journal.end();
    CHECK(std::filesystem::exists(found / "other.json"));
    CHECK_FALSE(std::filesystem::exists(found / "hunt-1.jsonl"));
  }
}

TEST_CASE("list worst lists what can be read, and ends with 2 where a file cannot") {
  const TemporaryFolder folder;
  const std::filesystem::path worst = folder.path() / "found" / "worst";
  const auto listed = [&] {
    return run_program({"sh", "-c", "cd \"$0\" && exec \"$@\"", folder.path().string(),
                        manifuzz_path(), "list", "worst"});
  };
  SECTION("one of its cases") {
    write_file(worst / "planck" / "error.json", good_case());
    write_file(worst / "planck" / "missed.json", "{");
    const Outcome outcome = listed();
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.out, Catch::StartsWith("planck ") && Catch::Contains("error.json"));
    CHECK_THAT(outcome.err, Catch::Contains("missed.json"));
    CHECK(is_one_clear_line(outcome.err));
  }
  SECTION("names that would break lines or colour them") {
    write_file(worst / "pl\nanck" / "er\x1b[31mror.json", good_case());
    const Outcome outcome = listed();
    CHECK(outcome.status == 0);
    CHECK(lines_of(outcome.out).size() == 1);
    CHECK(outcome.out.find('\x1b') == std::string::npos);
  }
  SECTION("what is no folder in place of it") {
    SECTION("a file") {
      write_file(worst, "");
    }
    SECTION("a link to nothing or to itself") {
      std::filesystem::create_directory(worst.parent_path());
      std::filesystem::create_symlink("worst", worst);
    }
    const Outcome outcome = listed();
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
}
