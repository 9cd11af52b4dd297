#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// The result of comparing a subject with an oracle on one case.
enum class Verdict {
  agree,  ///< they match each other within bound
  tie,    ///< they differ, and each is right by its own declaration
  known,  ///< the oracle is wrong in a way the ledger names; the subject is right
  subject_wrong,
  oracle_wrong,
  both_wrong,
  ill_posed,    ///< the bound exceeds a set share of the size: float cannot say
  unsupported,  ///< a collider declared that it cannot take this input
  crashed,
  timed_out,
  malformed,  ///< a collider answered nonsense
};
inline constexpr std::array<std::string_view, 11> kVerdictNames{
    "agree",     "tie",         "known",   "subject_wrong", "oracle_wrong", "both_wrong",
    "ill_posed", "unsupported", "crashed", "timed_out",     "malformed"};

enum class Fault { none, subject, oracle, both };
inline constexpr std::array<std::string_view, 4> kFaultNames{"none", "subject", "oracle", "both"};

/// What is wrong with an answer, or how two differ. Of a clip, the later, the closer to being
/// right; from `reversed` on, what the penetration curve says.
enum class Kind {
  none,
  missed_contact,
  phantom_contact,
  normal,
  position,
  depth,
  count,
  features,
  reversed,
  inconsistent,
  not_minimal,
  witness,
  altered_shape,
  extent,     ///< points span less of the contact than the clip of two round shapes' edges
  lingering,  ///< a point is kept past what its collider declares
};
inline constexpr std::array<std::string_view, 15> kKindNames{
    "none",        "missed_contact", "phantom_contact", "normal",   "position",
    "depth",       "count",          "features",        "reversed", "inconsistent",
    "not_minimal", "witness",        "altered_shape",   "extent",   "lingering"};

/// Which decision of the case lies within bound, so that several manifolds are right.
enum class TieClass { none, reference, incident, contact_boundary, clip_boundary };
inline constexpr std::array<std::string_view, 5> kTieClassNames{
    "none", "reference", "incident", "contact_boundary", "clip_boundary"};

inline constexpr std::array<std::string_view, 2> kSideNames{"a", "b"};

/// How far off a wrong answer is: what rounds too much and what is plainly wrong are unlike bugs.
enum class ErrorClass {
  none,      ///< nobody is wrong, or there is no answer
  rounding,  ///< by at most a hundredth of the size, and at most a thousand bounds
  fine,      ///< by at most a hundredth of the size, and more bounds
  gross,     ///< by more than a hundredth of the size, whatever the bound
};
inline constexpr std::array<std::string_view, 4> kErrorClassNames{"none", "rounding", "fine",
                                                                  "gross"};

/// The class of an error, which would be right within `bound`; both as shares of the size.
ErrorClass class_of(Kind kind, double magnitude, double bound);

/// Whether two errors are of one order, of which each begins at a power of eight. What is about
/// another is about all that this is about: so shrinking again what was shrunk changes nothing.
bool is_about(double magnitude, double other);

/// One name for all findings with one look:
/// `<at fault>/<verdict>/<kind>/<tie class>/<reference>`, and `/<error class>` unless that is none.
struct Bucket {
  Fault fault = Fault::none;
  Verdict verdict = Verdict::agree;
  Kind kind = Kind::none;
  TieClass tie_class = TieClass::none;
  Side reference = Side::a;  ///< of the true greatest separation
  ErrorClass error_class = ErrorClass::none;

  friend bool operator==(const Bucket&, const Bucket&) = default;
};

/// The bucket of an answer that never came, or is nonsense: crashed, timed_out or malformed.
inline Bucket bucket_of_lost(Verdict verdict, Fault fault) {
  return {.fault = fault, .verdict = verdict};
}

/// Whether it is of such an answer, explained or not.
bool is_of_lost(const Bucket& bucket);

template <class Enum, std::size_t N>
std::string_view name_of(Enum value, const std::array<std::string_view, N>& names) {
  return names[static_cast<std::size_t>(value)];
}

inline std::string_view to_string(Verdict verdict) {
  return name_of(verdict, kVerdictNames);
}

std::string to_string(const Bucket& bucket);

/// Buckets as small integers, for tables: 0 <= index < kBucketCount.
inline constexpr std::size_t kBucketCount = kFaultNames.size() * kVerdictNames.size() *
                                            kKindNames.size() * kTieClassNames.size() *
                                            kSideNames.size() * kErrorClassNames.size();
std::size_t index_of(const Bucket& bucket);
Bucket bucket_at(std::size_t index);

/// The bucket of that name, as `to_string` writes it.
std::optional<Bucket> find_bucket(std::string_view name);

/// Where a finding stands among others: those against the subject first, then what nobody explains,
/// what the ledger does, and what is nobody's mistake; of each the most serious first.
std::array<std::uint64_t, 4> place_of(const Bucket& bucket, std::uint64_t count);

/// Counted as unexplained: somebody is wrong and no ledger entry says so.
bool is_unexplained(Verdict verdict);

/// A finding against the subject (or a broken run), seen before or not.
bool is_failure(const Bucket& bucket);

}  // namespace manifuzz
