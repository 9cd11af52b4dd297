#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.hpp"
#include "judging/errors/answer_error.hpp"

namespace manifuzz {

/// How often a campaign met a finding.
struct Seen {
  std::uint64_t cases = 0;                       ///< of each regime, in the one with the fewest
  double magnitude = 0;                          ///< the worst, as a share of the size
  std::map<std::string, std::uint64_t> regimes;  ///< its count in each regime that ran
  std::optional<Errors> errors{};                ///< the worst; not recorded by older versions
};

/// That a finding is known to whoever writes its subject, and may stay as it is: `accept` says so.
struct Acceptance {
  std::string because;
  std::string link = {};
  std::string until = {};                   ///< the last day, as 2027-01-31; empty: no end
  std::optional<double> up_to = {};         ///< the greatest magnitude, as a share of the size
  std::optional<Errors> errors_up_to = {};  ///< in its place: the greatest error of each component
  std::map<std::string, double> per_million = {};  ///< at most, in each regime; in others any
  bool is_of_kind = false;  ///< other buckets of the same kind and collider may come too
};

/// An error that is worse than is accepted.
struct Excess {
  std::optional<Component> component;  ///< none: of the magnitude
  double got = 0;
  double accepted = 0;
};

/// Where an answer is worse than is accepted: the magnitude first, then the components in their
/// order. A component that is within its bound is never worse.
std::vector<Excess> beyond_accepted(const Acceptance& acceptance, const WorstError& error);

/// As "depth 0.5 of the size, above 0.3".
std::string in_words(const Excess& excess);

/// {"normal": 0.5, ...}, without those that are 0.
Errors read_errors(const JsonView& object);
void append_errors(std::string& out, const Errors& errors);

/// So many times what was seen is accepted where nobody says how much.
inline constexpr double kAcceptedTimesWorst = 3;

/// At most how often, in a million cases, what was met `hits` times in so many: beyond three
/// standard deviations of chance, and never so little that the first hit in more cases is too many.
double accepted_per_million(std::uint64_t hits, std::uint64_t cases);

/// Whether the text is a day of the calendar, as 2027-01-31. Such texts compare as days do.
bool is_day(std::string_view text);

/// Today, in UTC.
std::string today();

/// As a case file has them under "accepted" and, in "found", "seen". Errors begin with a path.
Acceptance read_acceptance(const JsonView& object);
Seen read_seen(const JsonView& object);
/// With the comma before it.
std::string acceptance_member(const Acceptance& acceptance);
void append_seen(std::string& out, const Seen& seen);

}  // namespace manifuzz
