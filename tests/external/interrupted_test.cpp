#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/interruption.hpp"
#include "support/temporary_folder.hpp"

// Signals while a subject does what it likes: the command ends soon, with what it found.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

using Words = std::vector<std::string>;

/// A program that answers nothing right, interrupts manifuzz at its case of that number, in
/// whichever of its processes comes first, and then does that, as every other process of it.
std::string ending(const TemporaryFolder& folder, const std::string& signal,
                   const std::string& then, int at = 100) {
  const std::string once = (folder.path() / "once").string();
  return "sh " + folder.write("ending.sh",
                              "trap '' TERM HUP\n"
                              "n=0\n"
                              "while read -r line; do\n"
                              "  n=$((n + 1))\n"
                              "  if [ $n -eq " +
                                  std::to_string(at) +
                                  " ]; then\n"
                                  "    mkdir '" +
                                  once + "' 2>/dev/null && kill -" + signal +
                                  " $MANIFUZZ_PROCESS\n    " + then +
                                  "\n  fi\n"
                                  "  echo '{\"points\": []}'\n"
                                  "done\n");
}

/// No answer is late, so that nothing but the signal ends anything.
const Words kPatient{"--time-limit", "3600"};

}  // namespace

TEST_CASE("a campaign ends with its findings whatever signal comes and whatever the program does") {
  for (const char* const signal : {"INT", "TERM", "HUP"}) {
    for (const char* const then :
         {"kill -STOP $$", "exec >&- 2>&-; while :; do sleep 1; done", "sleep 3600"}) {
      CAPTURE(signal, then);
      const TemporaryFolder folder;
      const std::string corpus = (folder.path() / "corpus").string();
      const std::string json = (folder.path() / "run.json").string();
      const Outcome outcome =
          run_interruptible(with({"fuzz", "--subject-command", ending(folder, signal, then),
                                  "--oracle", "clip64", "--regime", "boxes", "--cases", "100000",
                                  "--seed", "1", "--corpus", corpus, "--json", json},
                                 kPatient));
      CAPTURE(outcome.err, outcome.out);
      CHECK(outcome.status == 1);  // it found something
      CHECK(outcome.out.find("interrupted") != std::string::npos);
      const auto run = nlohmann::json::parse(text_of(json));
      CHECK(run["interrupted"] == true);
      REQUIRE(run["buckets"].size() > 0);
      for (const auto& bucket : run["buckets"]) {
        if (bucket["verdict"] == "tie") continue;  // nobody asked for them
        CHECK(std::filesystem::exists(bucket["file"].get<std::string>()));
      }
    }
  }
}

TEST_CASE("an interrupted command that found nothing ends with the signal's status") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "corpus").string();
  const std::string known = folder.write(
      "case.json",
      R"({"format": "manifuzz/case/1", "a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]]}, )"
      R"("b": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "position": [9, 0]}})");
  for (const auto& [signal, status] :
       {std::pair("INT", 130), std::pair("TERM", 143), std::pair("HUP", 143)}) {
    for (const Words& command :
         {Words{"fuzz", "--oracle", "clip64", "--no-save", "--cases", "3000"},
          Words{"property", "--no-save"}, Words{"smoke", "--no-save"}, Words{"replay", known},
          Words{"report", known, "--output", (folder.path() / "page.html").string()},
          Words{"shrink", known}}) {
      CAPTURE(signal, command[0]);
      const TemporaryFolder own;
      // It answers the case by which it declares itself, and no other in any process.
      const std::string begun = (own.path() / "begun").string();
      const std::string subject =
          "sh " + own.write("hangs.sh", "if mkdir '" + begun +
                                            "' 2>/dev/null; then\n"
                                            "  echo '{\"declaration\": {\"name\": \"hangs\"}}'\n"
                                            "  read -r line; echo '{\"points\": []}'\n"
                                            "fi\n"
                                            "read -r line; mkdir '" +
                                            begun + "/once' 2>/dev/null && kill -" + signal +
                                            " $MANIFUZZ_PROCESS\nsleep 3600\n");
      Words all = with(command, {"--subject-command", subject});
      if (command[0] != "smoke") all = with(all, kPatient);
      if (command[0] == "fuzz" || command[0] == "property" || command[0] == "smoke") {
        all = with(all, {"--seed", "1", "--corpus", corpus});
      }
      const Outcome outcome = run_interruptible(all);
      CAPTURE(outcome.err);
      CHECK(outcome.status == status);
      CHECK((outcome.out + outcome.err).find("interrupted") != std::string::npos);
    }
  }
}

// So late that what was found before is counted.
TEST_CASE("a second signal ends a campaign without its findings") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "corpus").string();
  const Outcome outcome = run_interruptible(
      with({"fuzz", "--subject-command",
            ending(folder, "INT $MANIFUZZ_PROCESS && kill -TERM", "sleep 3600", 3000), "--oracle",
            "clip64", "--regime", "boxes", "--cases", "100000", "--seed", "1", "--corpus", corpus},
           kPatient));
  CAPTURE(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("findings are not saved") != std::string::npos);
}

TEST_CASE("a command that measures ends at once with the signal's status") {
  const Outcome outcome = run_program(
      {"sh", "-c", "\"$0\" bench --quick & sleep 0.3; kill -HUP $!; wait $!", manifuzz_path()});
  CHECK(outcome.status == 143);
  CHECK(outcome.err.find("interrupted") != std::string::npos);
}

TEST_CASE("one that was started to outlive its terminal does") {
  const Outcome outcome = run_program(
      {"sh", "-c",
       "trap '' HUP; \"$0\" fuzz --cases 20000 --seed 1 --no-save --regime boxes & kill -HUP $!; "
       "wait $!",
       manifuzz_path()});
  CHECK(outcome.status == 0);
}

TEST_CASE("standard streams that are closed are no collider's fault") {
  for (const char* const closed : {"<&-", "2>&-", "<&- 2>&-", "<&- >&- 2>&-"}) {
    CAPTURE(closed);
    const TemporaryFolder folder;
    const std::string json = (folder.path() / "run.json").string();
    const std::string command =
        "\"$0\" fuzz --subject \"$1\" --oracle clip64 --cases 2000 --seed "
        "1 --no-save --corpus \"$2\" --json \"$3\" ";
    run_program({"sh", "-c", command + closed, manifuzz_path(), MANIFUZZ_TEST_LIBRARY,
                 (folder.path() / "corpus").string(), json});
    const auto run = nlohmann::json::parse(text_of(json));
    CHECK(run["cases"] == 2000);
    CHECK(run["verdicts"]["crashed"] == 0);
    CHECK(run["stopped_early"] == false);
  }
  const Outcome unread = run_program({"sh", "-c", "\"$0\" list colliders >&-", manifuzz_path()});
  CHECK(unread.status == 2);
}
