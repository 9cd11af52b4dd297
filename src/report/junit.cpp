#include "report/junit.hpp"

#include <fmt/format.h>

#include "report/xml.hpp"

namespace manifuzz {
namespace {

/// The counts of a suite, or of all of them, as attributes.
std::string counts(std::size_t tests, std::size_t failures, double seconds) {
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" time=\"{:.3f}\"", tests, failures,
                     seconds);
}

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
  std::string xml = fmt::format("<testsuite name=\"{}\" {}>\n", name,
                                counts(suite.tests.size(), suite.failures(), suite.seconds()));
  for (const TestResult& test : suite.tests) {
    xml += fmt::format("<testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"", name,
                       escape_xml(test.name), test.seconds);
    xml += test.failure ? fmt::format(">{}</testcase>\n", failure_xml(*test.failure)) : "/>\n";
  }
  return xml + "</testsuite>\n";
}

}  // namespace

std::string junit_xml(std::span<const TestSuite> suites) {
  std::string all;
  std::size_t tests = 0;
  std::size_t failures = 0;
  double seconds = 0;
  for (const TestSuite& suite : suites) {
    all += suite_xml(suite);
    tests += suite.tests.size();
    failures += suite.failures();
    seconds += suite.seconds();
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n{}</testsuites>\n",
      counts(tests, failures, seconds), all);
}

}  // namespace manifuzz
