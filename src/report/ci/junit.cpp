#include "report/ci/junit.hpp"

#include <fmt/format.h>

#include "report/xml.hpp"

namespace manifuzz {
namespace {

/// The counts of a suite, or of all of them; an error stands for a test that could not be.
struct Counts {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  double seconds = 0;

  explicit Counts(std::span<const TestSuite> suites) {
    for (const TestSuite& suite : suites) {
      tests += suite.tests.size() + suite.errors.size();
      failures += suite.failures();
      errors += suite.errors.size();
      seconds += suite.seconds();
    }
  }
  std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", tests,
                       failures, errors, seconds);
  }
};

/// Lines, fit for an element.
std::string escaped_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += escape_xml(text.substr(0, end)) + '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string failure_xml(const TestFailure& failure) {
  const std::string message = escape_xml(in_words(failure));
  std::string body = escaped_lines(failure.command);
  if (!body.empty() && !failure.picture.empty()) body += '\n';
  body += escaped_lines(failure.picture);
  if (body.empty()) return fmt::format("<failure message=\"{}\"/>", message);
  return fmt::format("<failure message=\"{}\">\n{}</failure>", message, body);
}

std::string suite_xml(const TestSuite& suite) {
  const std::string name = escape_xml(suite.name);
  std::string xml =
      fmt::format("<testsuite name=\"{}\" {}>\n", name, Counts({&suite, 1}).attributes());
  const auto begin_test = [&](std::string_view test, double seconds) {
    xml += fmt::format("<testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"", name,
                       escape_xml(test), seconds);
  };
  for (const std::string& error : suite.errors) {
    begin_test(error.substr(0, error.find(": ")), 0);
    xml += fmt::format("><error message=\"{}\"/></testcase>\n", escape_xml(error));
  }
  for (const TestResult& test : suite.tests) {
    begin_test(test.name, test.seconds);
    xml += test.failure ? fmt::format(">{}</testcase>\n", failure_xml(*test.failure)) : "/>\n";
  }
  return xml + "</testsuite>\n";
}

}  // namespace

std::string junit_xml(std::span<const TestSuite> suites) {
  std::string all;
  for (const TestSuite& suite : suites) all += suite_xml(suite);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n{}</testsuites>\n",
      Counts(suites).attributes(), all);
}

}  // namespace manifuzz
