#include "external/printed_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <regex>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace manifuzz::test {
namespace {

const std::string kNumber = R"(-?(?:\d+\.?\d*(?:[eE][-+]?\d+)?|nan|NaN|inf))";

/// Numbers that stand alone: not the digits of a name.
std::vector<double> numbers_in(const std::string& text) {
  static const std::regex alone("(^|[^A-Za-z_0-9.])(" + kNumber + ")(?![A-Za-z_0-9])");
  std::vector<double> numbers;
  for (std::sregex_iterator at(text.begin(), text.end(), alone), end; at != end; ++at) {
    numbers.push_back(std::strtod((*at)[2].str().c_str(), nullptr));
  }
  return numbers;
}

/// A place, or one number.
using Figure = std::vector<std::string>;

std::vector<Figure> figures_in(std::string got) {
  // Such words say how a figure is read, and are no figures of the program's.
  got = std::regex_replace(
      got, std::regex(R"( of length (1 [-+] )?[-\d.e+]+| of 0 or (above|less))"), "");
  static const std::regex figure("(?:^|[^A-Za-z_0-9.])(?:\\((" + kNumber + "), (" + kNumber +
                                 ")\\)|(" + kNumber + "))(?![A-Za-z_0-9])");
  std::vector<Figure> figures;
  for (std::sregex_iterator at(got.begin(), got.end(), figure), end; at != end; ++at) {
    const std::smatch& found = *at;
    figures.push_back(found[3].matched ? Figure{found[3]} : Figure{found[1], found[2]});
  }
  return figures;
}

std::string in_digits(double number, int digits) {
  if (std::isnan(number)) return "nan";
  return fmt::format("{:.{}g}", number + 0.0, digits);
}

/// How a figure was rounded: to so many digits, of a float or a double, after it was off by this.
struct Rounding {
  int digits = 0;
  bool is_float = false;
  double off = 0;
};

bool is_rounded(const std::string& figure, double number, const Rounding& by) {
  if (in_digits(number, by.digits) == figure) return true;
  if (by.off > 0 && std::abs(std::strtod(figure.c_str(), nullptr) - number) <= by.off) return true;
  return by.is_float &&
         in_digits(static_cast<double>(static_cast<float>(number)), by.digits) == figure;
}

bool stands_at(const Figure& figure, const std::vector<double>& numbers, std::size_t at,
               const Rounding& by) {
  for (std::size_t i = 0; i < figure.size(); ++i) {
    if (!is_rounded(figure[i], numbers[at + i], by)) return false;
  }
  return true;
}

bool is_printed(const Figure& figure, const std::vector<double>& numbers, const Rounding& by) {
  for (std::size_t at = 0; at + figure.size() <= numbers.size(); ++at) {
    if (stands_at(figure, numbers, at, by)) return true;
  }
  return false;
}

/// So many roundings of the largest.
double roundings_of(const std::vector<double>& numbers, int count, bool is_float) {
  double most = 0;
  for (const double number : numbers) {
    if (std::isfinite(number)) most = std::max(most, std::abs(number));
  }
  const double one = is_float ? static_cast<double>(std::numeric_limits<float>::epsilon())
                              : std::numeric_limits<double>::epsilon();
  return count * one * most;
}

}  // namespace

std::vector<std::string> figures_not_printed(const std::string& got, const std::string& printed,
                                             bool is_float, int roundings) {
  const std::vector<Figure> figures = figures_in(got);
  const std::vector<double> numbers = numbers_in(printed);
  Rounding by{.is_float = is_float, .off = roundings_of(numbers, roundings, is_float)};
  std::vector<std::string> fewest;
  // A report gives all its figures in the same number of digits, from 7 of a float, 9 of a double.
  for (by.digits = is_float ? 7 : 9; by.digits <= std::numeric_limits<double>::max_digits10;
       ++by.digits) {
    std::vector<std::string> missing;
    for (const Figure& figure : figures) {
      if (!is_printed(figure, numbers, by)) {
        missing.push_back(fmt::format("{}", fmt::join(figure, ", ")));
      }
    }
    if (missing.empty()) return missing;
    if (fewest.empty() || missing.size() < fewest.size()) fewest = missing;
  }
  return fewest;
}

}  // namespace manifuzz::test
