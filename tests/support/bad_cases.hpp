#pragma once

#include <string>
#include <vector>

namespace manifuzz::test {

/// A pair case that must be refused.
struct BadCase {
  std::string name;       ///< of the test
  std::string text;       ///< without a line's end, so that it serves as a line and as a file
  std::string complaint;  ///< what the error must contain
};

/// Every kind of bad case, at least one row for each. All but the rows on it name the format.
const std::vector<BadCase>& bad_cases();

/// A case that must be accepted, on one line, without the line's end.
std::string good_case();

}  // namespace manifuzz::test
