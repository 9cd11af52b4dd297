#include "corpus/acceptance.hpp"

#include <chrono>
#include <cmath>
#include <iterator>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "base/text.hpp"
#include "exchange/json.hpp"

namespace manifuzz {
namespace {

/// The digits of a text as a number; anything else is 0.
unsigned number_in(std::string_view text) {
  unsigned number = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return 0;
    number = 10 * number + static_cast<unsigned>(c - '0');
  }
  return number;
}

/// Appends {"name": value, ...}.
template <class Values, class Append>
void append_object(std::string& out, const Values& values, const Append& append) {
  out += '{';
  std::string_view separator;
  for (const auto& [name, value] : values) {
    out += separator;
    append_string(out, name);
    out += ": ";
    append(value);
    separator = ", ";
  }
  out += '}';
}

}  // namespace

double accepted_per_million(std::uint64_t hits, std::uint64_t cases) {
  constexpr double kDeviations = 3;
  constexpr double kFew = 5;
  if (cases == 0) return 1e6;
  const auto seen = static_cast<double>(hits);
  const double most = seen + kDeviations * std::sqrt(seen) + kFew;
  return std::min(1e6, std::ceil(1e6 * most / static_cast<double>(cases)));
}

bool is_day(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  using namespace std::chrono;
  const unsigned of_year = number_in(text.substr(0, 4));
  const year_month_day day{year(static_cast<int>(of_year)), month(number_in(text.substr(5, 2))),
                           std::chrono::day(number_in(text.substr(8, 2)))};
  return of_year > 0 && day.ok();
}

std::string today() {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now()));
}

Acceptance read_acceptance(const JsonView& object) {
  object.expect_keys({"because", "link", "until", "up_to", "per_million", "whole_kind"});
  Acceptance acceptance{.because = std::string(object.at("because").string()),
                        .link = object.string_or("link", ""),
                        .until = object.string_or("until", "")};
  if (acceptance.because.empty()) {
    object.at("because").fail("is empty; the reason why the finding is accepted is expected");
  }
  if (!acceptance.until.empty() && !is_day(acceptance.until)) {
    object.at("until").fail("is not a date; a date such as 2027-01-31 is expected");
  }
  if (const auto up_to = object.find("up_to")) {
    if (up_to->is_object()) {
      acceptance.errors_up_to = read_errors(*up_to);
    } else {
      acceptance.up_to = up_to->magnitude();
    }
  }
  if (const auto whole_kind = object.find("whole_kind")) {
    acceptance.is_of_kind = whole_kind->boolean();
  }
  if (const auto rates = object.find("per_million")) {
    for (const std::string_view regime : rates->keys()) {
      acceptance.per_million[std::string(regime)] = rates->at(regime).magnitude();
    }
  }
  return acceptance;
}

std::vector<Excess> beyond_accepted(const Acceptance& acceptance, const WorstError& error) {
  std::vector<Excess> found;
  const auto hold = [&](std::optional<Component> component, double got, double accepted) {
    if (!(got <= accepted)) found.push_back({component, got, accepted});
  };
  if (acceptance.up_to) hold({}, error.magnitude, *acceptance.up_to);
  for (std::size_t i = 0; acceptance.errors_up_to && i < kComponentNames.size(); ++i) {
    hold(static_cast<Component>(i), error.errors.all()[i], acceptance.errors_up_to->all()[i]);
  }
  return found;
}

std::string in_words(const Excess& excess) {
  const std::string name =
      excess.component
          ? fmt::format("{} ", kComponentNames[static_cast<std::size_t>(*excess.component)])
          : "";
  const std::string_view unit = excess.component ? unit_of(*excess.component) : " of the size";
  return fmt::format("{}{:.3g}{}, above {:.3g}", name, excess.got, unit, excess.accepted);
}

Errors read_errors(const JsonView& object) {
  object.expect_keys(kComponentNames);
  Errors errors;
  for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
    if (const auto error = object.find(kComponentNames[i])) errors.all()[i] = error->magnitude();
  }
  return errors;
}

void append_errors(std::string& out, const Errors& errors) {
  std::map<std::string_view, double> beyond;
  for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
    if (errors.all()[i] > 0) beyond.emplace(kComponentNames[i], errors.all()[i]);
  }
  append_object(out, beyond, [&](double error) { append_number(out, error); });
}

Seen read_seen(const JsonView& object) {
  object.expect_keys({"cases", "magnitude", "errors", "regimes"});
  Seen seen{object.at("cases").whole_number(), object.at("magnitude").magnitude(), {}};
  if (const auto errors = object.find("errors")) seen.errors = read_errors(*errors);
  const JsonView regimes = object.at("regimes");
  for (const std::string_view regime : regimes.keys()) {
    seen.regimes[std::string(regime)] = regimes.at(regime).whole_number();
  }
  return seen;
}

std::string acceptance_member(const Acceptance& acceptance) {
  std::string out = ",\n  \"accepted\": {\"because\": ";
  append_string(out, acceptance.because);
  if (!acceptance.link.empty()) {
    out += ", \"link\": ";
    append_string(out, acceptance.link);
  }
  if (!acceptance.until.empty()) {
    out += ", \"until\": ";
    append_string(out, acceptance.until);
  }
  if (acceptance.up_to) {
    out += ", \"up_to\": ";
    append_number(out, *acceptance.up_to);
  }
  if (acceptance.errors_up_to) append_errors(out += ", \"up_to\": ", *acceptance.errors_up_to);
  if (acceptance.is_of_kind) out += ", \"whole_kind\": true";
  if (!acceptance.per_million.empty()) {
    out += ",\n    \"per_million\": ";
    append_object(out, acceptance.per_million, [&](double rate) { append_number(out, rate); });
  }
  return out += '}';
}

void append_seen(std::string& out, const Seen& seen) {
  out += fmt::format("{{\"cases\": {}, \"magnitude\": ", seen.cases);
  append_number(out, seen.magnitude);
  if (seen.errors) append_errors(out += ", \"errors\": ", *seen.errors);
  out += ", \"regimes\": ";
  append_object(out, seen.regimes, [&](std::uint64_t count) { out += std::to_string(count); });
  out += '}';
}

}  // namespace manifuzz
