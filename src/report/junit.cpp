#include "report/junit.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "report/xml.hpp"

namespace manifuzz {

std::string junit_xml(const std::string& suite, std::span<const JUnitTest> tests) {
  const auto failures = std::count_if(tests.begin(), tests.end(),
                                      [](const JUnitTest& test) { return !test.failure.empty(); });
  const double seconds =
      std::accumulate(tests.begin(), tests.end(), 0.0,
                      [](double sum, const JUnitTest& test) { return sum + test.seconds; });
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" time=\"{:.3f}\">\n",
      escape_xml(suite), tests.size(), failures, seconds);
  for (const JUnitTest& test : tests) {
    xml += fmt::format("<testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"", escape_xml(suite),
                       escape_xml(test.name), test.seconds);
    xml += test.failure.empty()
               ? "/>\n"
               : fmt::format("><failure message=\"{}\"/></testcase>\n", escape_xml(test.failure));
  }
  return xml + "</testsuite>\n</testsuites>\n";
}

}  // namespace manifuzz
