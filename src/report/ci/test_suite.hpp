#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace manifuzz {

/// Why a test failed, and what helps to look into it; what is not known is empty.
struct TestFailure {
  std::string expected;
  std::string got;
  std::string file{};     ///< of the case, with :line for a line
  std::string command{};  ///< repeats it, for a shell
  std::string picture{};  ///< of characters, in lines
};

struct TestResult {
  std::string name;
  double seconds = 0;
  std::optional<TestFailure> failure{};
};

/// The results of a run, for JUnit reports and for what CI shows.
struct TestSuite {
  std::string name;  ///< "manifuzz replay"
  std::string headline;
  std::vector<TestResult> tests;
  std::vector<std::vector<std::string>> table{};  ///< rows of equal length, the head first
  std::vector<std::string> errors{};              ///< why parts of the run did not take place

  std::size_t failures() const {
    std::size_t count = 0;
    for (const TestResult& test : tests) count += test.failure ? 1 : 0;
    return count;
  }
  double seconds() const {
    double sum = 0;
    for (const TestResult& test : tests) sum += test.seconds;
    return sum;
  }
};

/// "expected ..., got ...".
inline std::string in_words(const TestFailure& failure) {
  return "expected " + failure.expected + ", got " + failure.got;
}

/// A JUnit XML document, valid by the schema of Jenkins: a test case for each test, its class being
/// the suite; the command and the picture are the failure's text.
std::string junit_xml(std::span<const TestSuite> suites);

}  // namespace manifuzz
