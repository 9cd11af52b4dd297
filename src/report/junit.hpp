#pragma once

#include <span>
#include <string>

namespace manifuzz {

/// One test of a JUnit report; `failure` is empty where it passed.
struct JUnitTest {
  std::string name;
  std::string failure;
  double seconds = 0;
};

/// A JUnit XML document with one suite.
std::string junit_xml(const std::string& suite, std::span<const JUnitTest> tests);

}  // namespace manifuzz
