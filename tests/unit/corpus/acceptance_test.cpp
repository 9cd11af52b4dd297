#include "corpus/acceptance.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "support/bad_cases.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
using Catch::Contains;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The text of a case with these members more.
std::string case_with(const std::string& members) {
  std::string text = test::good_case();
  text.pop_back();  // the brace that closes it
  return text + ", " + members + "}";
}

CorpusCase read(const std::string& members) {
  return parse_case(case_with(members), FormatKey::required);
}

/// What is said against such members, or nothing.
std::string refusal(const std::string& members) {
  try {
    read(members);
    return "";
  } catch (const UserError& error) {
    return error.what();
  }
}

std::string found_with(const std::string& more) {
  return R"("found": {"seed": 1, "regime": "boxes", "index": 2, )" + more + "}";
}

Acceptance whole_acceptance() {
  return {.because = "known \"since\"\n2.3, caf\xc3\xa9",
          .link = "https://example.org/1?a=b&c",
          .until = "2027-01-31",
          .up_to = 0.1,
          .per_million = {{"boxes", 12}, {"sliver", 0}}};
}

}  // namespace

TEST_CASE("a day is one of the calendar, written in ten characters") {
  for (const char* day : {"2027-01-31", "2028-02-29", "0001-01-01", "9999-12-31"}) {
    CHECK(is_day(day));
  }
  for (const char* text : {"", "2027-02-29", "2027-13-01", "2027-00-10", "2027-01-00", "2027-04-31",
                           "2027-1-31", "27-01-31", "2027/01/31", "2027-01-31 ", "2027-01-3x",
                           "-027-01-31", "0000-01-01", "2027-01--1", "20270131"}) {
    CAPTURE(text);
    CHECK_FALSE(is_day(text));
  }
  CHECK(is_day(today()));
}

TEST_CASE("the accepted rate leaves room for chance, is whole and at most every case") {
  CHECK(accepted_per_million(0, 1'000'000) == 5);
  CHECK(accepted_per_million(100, 1'000'000) == 135);  // and three standard deviations, and five
  CHECK(accepted_per_million(1, 1000) == 9000);
  CHECK(accepted_per_million(1, 700'000) == 13);  // rounded up
  CHECK(accepted_per_million(3, 3) == 1e6);
  CHECK(accepted_per_million(0, 0) == 1e6);
}

TEST_CASE("an acceptance is written and read back, every part of it") {
  CorpusCase known = read("\"note\": \"n\"");
  known.accepted = whole_acceptance();
  const CorpusCase again = parse_case(format_case(known), FormatKey::required);
  REQUIRE(again.accepted);
  CHECK(again.accepted->because == known.accepted->because);
  CHECK(again.accepted->link == known.accepted->link);
  CHECK(again.accepted->until == known.accepted->until);
  CHECK(again.accepted->up_to == known.accepted->up_to);
  CHECK(again.accepted->per_million == known.accepted->per_million);
  CHECK(again.note == "n");
}

TEST_CASE("an acceptance of nothing but a reason has no end and no bound") {
  const CorpusCase known = read(R"("accepted": {"because": "so"})");
  REQUIRE(known.accepted);
  CHECK(known.accepted->because == "so");
  CHECK(known.accepted->until.empty());
  CHECK_FALSE(known.accepted->up_to);
  CHECK(known.accepted->per_million.empty());
  CHECK_FALSE(read("\"note\": \"n\"").accepted);
}

TEST_CASE("what was seen is written and read back, infinite magnitudes and unshrunk cases too") {
  CorpusCase known = read(found_with("\"unshrunk\": true"));
  known.found->seen = Seen{3000, kInfinity, {{"boxes", 12}, {"sliver", 0}}};
  const CorpusCase again = parse_case(format_case(known), FormatKey::required);
  REQUIRE(again.found->seen);
  CHECK(again.found->seen->cases == 3000);
  CHECK(again.found->seen->magnitude == kInfinity);
  CHECK(again.found->seen->regimes == known.found->seen->regimes);
  CHECK(again.found->is_unshrunk);
  CHECK_FALSE(read(found_with("\"unshrunk\": false")).found->is_unshrunk);
}

TEST_CASE("bad acceptances are refused, by the place and what would be right", "[bad-input]") {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"3", "$.accepted: is a number; an object is expected"},
      {"{}", "the key \"because\" is missing"},
      {R"({"because": 1})", "$.accepted.because"},
      {R"({"because": "x", "why": ""})", "unknown key \"why\""},
      {R"({"because": "x", "because": "y"})", "repeated"},
      {R"({"because": "x", "link": 1})", "$.accepted.link"},
      {R"({"because": "x", "until": "2027-02-30"})",
       "$.accepted.until: is not a date; a date such as 2027-01-31 is expected"},
      {R"({"because": "x", "until": 2027})", "$.accepted.until"},
      {R"({"because": "x", "up_to": -0.5})", "$.accepted.up_to: -0.5 is no magnitude"},
      {R"({"because": "x", "up_to": "1"})", "$.accepted.up_to"},
      {R"({"because": "x", "per_million": 3})", "$.accepted.per_million"},
      {R"({"because": "x", "per_million": {"boxes": -1}})", "$.accepted.per_million.boxes"}};
  for (const auto& [value, complaint] : bad) {
    CAPTURE(value);
    CHECK_THAT(refusal("\"accepted\": " + value), Contains(complaint));
  }
}

TEST_CASE("bad counts of what was seen are refused, by the place", "[bad-input]") {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"\"seen\": 3", "$.found.seen"},
      {"\"seen\": {}", "the key \"cases\" is missing"},
      {R"("seen": {"cases": -1, "magnitude": 0, "regimes": {}})", "$.found.seen.cases"},
      {R"("seen": {"cases": 1, "magnitude": -1, "regimes": {}})", "$.found.seen.magnitude"},
      {R"("seen": {"cases": 1, "magnitude": 0, "regimes": []})", "$.found.seen.regimes"},
      {R"("seen": {"cases": 1, "magnitude": 0, "regimes": {"boxes": 0.5}})",
       "$.found.seen.regimes.boxes"},
      {R"("seen": {"cases": 1, "magnitude": 0, "regimes": {}, "x": 1})", "unknown key \"x\""},
      {"\"unshrunk\": 1", "$.found.unshrunk"}};
  for (const auto& [members, complaint] : bad) {
    CAPTURE(members);
    CHECK_THAT(refusal(found_with(members)), Contains(complaint));
  }
}

TEST_CASE("an acceptance goes into a file and out again, and no other byte changes") {
  const test::TemporaryFolder folder;
  for (const std::string& text :
       {case_with("\"note\": \"a \\\"}\""), case_with("\"note\": \"a\"") + "\n\n",
        "{\n" + case_with("\"note\": \"}\"").substr(1) + " \t\n"}) {
    const std::string file = folder.write("case.json", text);
    write_acceptance(file, whole_acceptance());
    const std::string accepted = test::text_of(file);
    CHECK_THAT(accepted, Contains("\"accepted\": {\"because\": \"known"));
    CHECK(read_case_file(file).accepted->up_to == 0.1);
    write_acceptance(file, Acceptance{.because = "another reason"});
    CHECK(read_case_file(file).accepted->because == "another reason");
    CHECK_THAT(test::text_of(file), !Contains("example.org"));
    write_acceptance(file, {});
    CHECK(test::text_of(file) == text);
  }
}

TEST_CASE("an acceptance that somebody wrote otherwise can be replaced and dropped too") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write(
      "case.json", case_with(R"("accepted" : { "because":"by hand" }, "note": "stays")"));
  write_acceptance(file, Acceptance{.because = "by command"});
  CHECK(read_case_file(file).accepted->because == "by command");
  write_acceptance(file, {});
  CHECK_FALSE(read_case_file(file).accepted);
  CHECK(read_case_file(file).note == "stays");
}

TEST_CASE("an acceptance is not written among lines, which it would break") {
  const test::TemporaryFolder folder;
  const std::string line = test::good_case() + "\n";
  const std::string file = folder.write("case.jsonl", line);
  CHECK_THROWS_WITH(write_acceptance(file, whole_acceptance()),
                    Contains("holds lines; a file of one case, *.json, is expected"));
  CHECK(test::text_of(file) == line);
}

TEST_CASE("a campaign mutates no accepted case, nor the worst beside it") {
  CorpusCase known;
  known.any = generate(1, *find_regime("boxes"), 0);
  known.path = "corpus/regressions/x.json";
  CorpusCase worst = known;
  worst.path = "corpus/regressions/x.worst.json";
  Corpus corpus{{known, worst}, {}};
  CHECK(pairs_of(corpus, 1).size() == 2);
  corpus.cases[0].accepted = Acceptance{.because = "known"};
  CHECK(pairs_of(corpus, 1).empty());
}

TEST_CASE("no campaign mutates a case that a hunt bred") {
  CorpusCase known;
  known.any = generate(1, *find_regime("boxes"), 0);
  Corpus corpus{{known}, {}};
  CHECK(pairs_of(corpus, 1).size() == 1);
  corpus.cases[0].found = Found{.seed = 9, .regime = std::string(kRegimeOfHunts), .versions = {}};
  CHECK(pairs_of(corpus, 1).empty());
}
