#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace manifuzz::test {

/// The figures of a report's "Got" that a program did not print: numbers, and places as pairs of
/// numbers that follow one another, each rounded to the digits that the report gives. Floats may be
/// printed in as few digits as tell them apart. Figures may be off by so many roundings of the
/// largest number that was printed.
std::vector<std::string> figures_not_printed(const std::string& got, const std::string& printed,
                                             bool is_float, int roundings = 0);

}  // namespace manifuzz::test
