#include <catch2/catch.hpp>

#include "report/ci/test_suite.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

std::vector<TestSuite> two_suites() {
  TestSuite replay{"manifuzz replay", "", {{"a.json", 0.5}, {"b<\"&\xff.json", 0.25}}};
  replay.tests[1].failure = TestFailure{"x", "y", "b.json", "command 'it' <b>", "a\nb\n"};
  return {replay, {"manifuzz property", "", {{"swapping-mirrors", 1}}}};
}

}  // namespace

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
                                                                     {"time", "0.750"}});
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

TEST_CASE("a report without suites is one still") {
  CHECK(read_svg(junit_xml({})).size() == 1);
}
