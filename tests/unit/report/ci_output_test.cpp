#include "report/ci/ci_output.hpp"

#include <catch2/catch.hpp>

#include "report/words.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using Catch::Contains;
using namespace manifuzz::test;

namespace {

TestSuite suite_of(std::size_t failing) {
  TestSuite suite{"manifuzz replay", "clip against box2d", {{"good.json", 0.25}}};
  for (std::size_t i = 0; i < failing; ++i) {
    suite.tests.push_back({"bad" + std::to_string(i) + ".json", 0.5});
    suite.tests.back().failure = TestFailure{"clip to be right", "subject/subject_wrong",
                                             "corpus/bad.json", "manifuzz replay x", "picture\n"};
  }
  suite.table = {{"cases", "failed"}, {"1", "0"}};
  return suite;
}

std::string no_image(const std::string&) {
  return "";
}

std::string same(const std::string& file) {
  return file;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string summary_of(const TestSuite& suite, std::size_t room = kSummaryBytesMax) {
  return step_summary({&suite, 1}, room, no_image);
}

std::vector<TestSuite> two_suites() {
  TestSuite replay{"manifuzz replay", "", {{"a.json", 0.5}, {"b<\"&\xff.json", 0.25}}};
  replay.tests[1].failure = TestFailure{"x", "y", "b.json", "command 'it' <b>", "a\nb\n"};
  return {replay, {"manifuzz property", "", {{"swapping-mirrors", 1}}}};
}

}  // namespace

TEST_CASE("an annotation escapes what the runner would read as its own") {
  CHECK(error_annotation("a: b, 5%", "x,y.json", "100% of: a,\r\nb") ==
        "::error title=a%3A b%2C 5%25,file=x%2Cy.json::100%25 of: a,%0D%0Ab\n");
  CHECK(error_annotation("t", "", "m") == "::error title=t::m\n");
  CHECK(error_annotation("\x1b[31mt", "",
                         "a\xff\x7f\xc2\x9b"
                         "b") ==
        "::error title= [31mt::a\xef\xbf\xbd \xc2\xa0"
        "b\n");
  CHECK(error_annotation("t", "cases.jsonl:12", "m") ==
        "::error title=t,file=cases.jsonl,line=12::m\n");
}

TEST_CASE("each failure is annotated, and the last of too many counts the others") {
  const auto annotated = [](std::size_t failing) {
    const TestSuite suite = suite_of(failing);
    return annotations({&suite, 1}, same);
  };
  CHECK(annotated(0).empty());
  CHECK(annotated(1) ==
        "::error title=manifuzz replay%3A bad0.json,file=corpus/bad.json::expected clip to be "
        "right, got subject/subject_wrong%0Amanifuzz replay x\n");
  CHECK(count(annotated(10), "::error") == 10);
  CHECK_THAT(annotated(10), !Contains("more"));
  CHECK(count(annotated(12), "::error") == 10);
  CHECK_THAT(annotated(12), Contains("::and 3 more\n"));
}

TEST_CASE("what could not be run is told before what failed, as far as there is room for it") {
  TestSuite suite = suite_of(2);
  suite.errors = {"broken.json: $: is an array"};
  const std::string lines = annotations({&suite, 1}, same);
  CHECK_THAT(lines,
             Catch::StartsWith("::error title=manifuzz replay::broken.json: $: is an array\n"));
  CHECK(count(lines, "::error") == 3);
  CHECK_THAT(summary_of(suite), Contains("## manifuzz replay: 1 error, 2 of 3 failed\n") &&
                                    Contains("- **broken.json: \\$: is an array**\n"));
  suite.errors.assign(30, "broken.json: empty");
  CHECK(count(annotations({&suite, 1}, same), "::error") == 10);
  CHECK_THAT(annotations({&suite, 1}, same), Contains("::and 23 more\n"));
  CHECK_THAT(summary_of(suite),
             Contains("## manifuzz replay: 30 errors, ") && Contains("- and 20 more\n"));
}

TEST_CASE("Markdown shows text as it is") {
  CHECK(escape_markdown("a_b|<c>\n`d`") == "a\\_b\\|\\<c\\> \\`d\\`");
  CHECK(code_block("x", "text") == "```text\nx\n```\n");
  CHECK(code_block("```\nevil\n", "text") == "````text\n```\nevil\n````\n");
}

TEST_CASE("a summary has a table, and what helps with each failure") {
  CHECK(summary_of(suite_of(0)) ==
        "## manifuzz replay: passed\n\nclip against box2d\n\n"
        "| cases | failed |\n|---|---:|\n| 1 | 0 |\n\n");
  const TestSuite failing = suite_of(1);
  const std::string text =
      step_summary({&failing, 1}, kSummaryBytesMax,
                   [](const std::string& file) { return "https://example.org/" + file + ".svg"; });
  CHECK_THAT(text, Contains("## manifuzz replay: 1 of 2 failed"));
  CHECK_THAT(text, Contains("### manifuzz replay: bad0.json"));
  CHECK_THAT(text, Contains("Expected clip to be right, got **subject/subject\\_wrong**"));
  CHECK_THAT(text, Contains("![the case](https://example.org/corpus/bad.json.svg)"));
  CHECK_THAT(text, Contains("```text\npicture\n```"));
  CHECK_THAT(text, Contains("```sh\nmanifuzz replay x\n```"));
}

TEST_CASE("a summary describes ten failures and counts the rest") {
  const std::string text = summary_of(suite_of(13));
  CHECK(count(text, "###") == 10);
  CHECK_THAT(text, Contains("And 3 more"));
}

TEST_CASE("a summary never exceeds its room") {
  TestSuite suite = suite_of(10);
  for (TestResult& test : suite.tests) {
    if (test.failure) test.failure->picture.assign(1000, 'x');
  }
  for (const std::size_t room : {0U, 50U, 500U, 2500U, 5000U, 100'000U}) {
    CAPTURE(room);
    CHECK(summary_of(suite, room).size() <= room);
  }
  CHECK_THAT(summary_of(suite, 2500), Contains("And 8 more"));
}

TEST_CASE("a JUnit report counts its tests, failures and seconds") {
  const auto elements = read_svg(junit_xml(two_suites()));
  REQUIRE(elements.size() == 7);
  CHECK(elements[0].name == "testsuites");
  CHECK(elements[0].attributes ==
        std::map<std::string, std::string>{
            {"tests", "3"}, {"failures", "1"}, {"errors", "0"}, {"time", "1.750"}});
  CHECK(elements[1].attributes == std::map<std::string, std::string>{{"name", "manifuzz replay"},
                                                                     {"tests", "2"},
                                                                     {"failures", "1"},
                                                                     {"errors", "0"},
                                                                     {"time", "0.750"},
                                                                     {"skipped", "0"}});
  CHECK(elements[2].attributes ==
        std::map<std::string, std::string>{
            {"classname", "manifuzz replay"}, {"name", "a.json"}, {"time", "0.500000"}});
}

TEST_CASE("a failure says what was expected, what came, how to repeat it and how it looks") {
  const auto elements = read_svg(junit_xml(two_suites()));
  CHECK(elements[3].attributes.at("name") == "b<\"&\xef\xbf\xbd.json");
  CHECK(elements[4].name == "failure");
  CHECK(elements[4].attributes.at("message") == "expected x, got y");
  CHECK_THAT(elements[4].text, Contains("command 'it' <b>\n\na\nb\n"));
}

TEST_CASE("an error counts as a test that could not be, and says why") {
  TestSuite suite{"manifuzz replay", "", {{"a.json", 0.5}}};
  suite.errors = {"b/c.json: $: is <an array>"};
  const auto elements = read_svg(junit_xml({&suite, 1}));
  REQUIRE(elements.size() == 5);
  CHECK(elements[0].attributes.at("tests") == "2");
  CHECK(elements[0].attributes.at("errors") == "1");
  CHECK(elements[1].attributes.at("errors") == "1");
  CHECK(elements[2].attributes.at("name") == "b/c.json");
  CHECK(elements[3].name == "error");
  CHECK(elements[3].attributes.at("message") == suite.errors[0]);
}

TEST_CASE("a test that neither passed nor failed is skipped, and says why") {
  TestSuite suite{"manifuzz replay", "", {{"a.json", 0.5}, {"b.json", 0.25}}};
  suite.tests[1].why_skipped = "unsupported: pair cannot take it";
  const auto elements = read_svg(junit_xml({&suite, 1}));
  REQUIRE(elements.size() == 5);
  CHECK(elements[1].attributes.at("tests") == "2");
  CHECK(elements[1].attributes.at("failures") == "0");
  CHECK(elements[1].attributes.at("skipped") == "1");
  CHECK(elements[4].name == "skipped");
  CHECK(elements[4].attributes.at("message") == suite.tests[1].why_skipped);
  CHECK_THAT(summary_of(suite), Contains("## manifuzz replay: 1 of 2 skipped\n"));
  CHECK(annotations({&suite, 1}, same).empty());
}

TEST_CASE("a report without suites is one still") {
  CHECK(read_svg(junit_xml({})).size() == 1);
}
