#pragma once

#include <span>
#include <string>

#include "report/ci/test_suite.hpp"

namespace manifuzz {

/// A JUnit XML document, valid by the schema of Jenkins: a test case for each test, its class being
/// the suite; the command and the picture are the failure's text.
std::string junit_xml(std::span<const TestSuite> suites);

}  // namespace manifuzz
