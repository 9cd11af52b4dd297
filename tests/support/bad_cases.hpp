#pragma once

#include <string>
#include <vector>

namespace manifuzz::test {

/// A pair case that must be refused.
struct BadCase {
  std::string name;
  std::string text;       ///< without a line's end, so that it serves as a line and as a file
  std::string complaint;  ///< what the error must contain
};

/// Every bad case, for the reader. All but the rows on it name the format.
const std::vector<BadCase>& bad_cases();

/// One that is no JSON, too large, of a bad number, polygon, type, key or record each, for
/// commands.
std::vector<BadCase> bad_case_of_each_kind();

/// A case that must be accepted, on one line, without the line's end.
std::string good_case();

}  // namespace manifuzz::test
