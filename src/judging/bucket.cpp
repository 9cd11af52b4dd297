#include "judging/bucket.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace manifuzz {

ErrorClass class_of(Kind kind, double magnitude, double bound) {
  constexpr double kRounding = 1000;                    // bounds
  constexpr double kGross = 0.01;                       // of the size
  if (kind == Kind::features) return ErrorClass::fine;  // off by no length
  if (!(magnitude <= kGross)) return ErrorClass::gross;
  return magnitude <= kRounding * bound ? ErrorClass::rounding : ErrorClass::fine;
}

bool is_about(double magnitude, double other) {
  if (!(magnitude > 0 && other > 0) || std::isinf(magnitude) || std::isinf(other)) {
    return magnitude == other;
  }
  const auto order = [](double of) { return std::floor(std::ilogb(of) / 3.0); };
  return order(magnitude) == order(other);
}

bool is_of_lost(const Bucket& bucket) {
  if (bucket.verdict == Verdict::known) return bucket.kind == Kind::none;
  return bucket.verdict == Verdict::crashed || bucket.verdict == Verdict::timed_out ||
         bucket.verdict == Verdict::malformed;
}

std::string to_string(const Bucket& bucket) {
  std::string text;
  for (const std::string_view part :
       {name_of(bucket.fault, kFaultNames), name_of(bucket.verdict, kVerdictNames),
        name_of(bucket.kind, kKindNames), name_of(bucket.tie_class, kTieClassNames),
        name_of(bucket.reference, kSideNames)}) {
    if (!text.empty()) text += '/';
    text += part;
  }
  if (bucket.error_class == ErrorClass::none) return text;
  return text.append("/").append(name_of(bucket.error_class, kErrorClassNames));
}

std::size_t index_of(const Bucket& bucket) {
  std::size_t index = static_cast<std::size_t>(bucket.fault);
  index = index * kVerdictNames.size() + static_cast<std::size_t>(bucket.verdict);
  index = index * kKindNames.size() + static_cast<std::size_t>(bucket.kind);
  index = index * kTieClassNames.size() + static_cast<std::size_t>(bucket.tie_class);
  index = index * kSideNames.size() + static_cast<std::size_t>(bucket.reference);
  return index * kErrorClassNames.size() + static_cast<std::size_t>(bucket.error_class);
}

Bucket bucket_at(std::size_t index) {
  const auto take = [&index](std::size_t base) {
    const std::size_t digit = index % base;
    index /= base;
    return digit;
  };
  Bucket bucket;
  bucket.error_class = static_cast<ErrorClass>(take(kErrorClassNames.size()));
  bucket.reference = static_cast<Side>(take(kSideNames.size()));
  bucket.tie_class = static_cast<TieClass>(take(kTieClassNames.size()));
  bucket.kind = static_cast<Kind>(take(kKindNames.size()));
  bucket.verdict = static_cast<Verdict>(take(kVerdictNames.size()));
  bucket.fault = static_cast<Fault>(index);
  return bucket;
}

std::optional<Bucket> find_bucket(std::string_view name) {
  static const std::map<std::string, Bucket, std::less<>> all = [] {
    std::map<std::string, Bucket, std::less<>> by_name;
    for (std::size_t i = 0; i < kBucketCount; ++i) {
      by_name.emplace(to_string(bucket_at(i)), bucket_at(i));
    }
    return by_name;
  }();
  const auto found = all.find(name);
  return found == all.end() ? std::nullopt : std::optional(found->second);
}

std::array<std::uint64_t, 4> place_of(const Bucket& bucket, std::uint64_t count) {
  const std::uint64_t whose = is_failure(bucket)                 ? 0
                              : is_unexplained(bucket.verdict)   ? 1
                              : bucket.verdict == Verdict::known ? 2
                                                                 : 3;
  constexpr std::array gravities{0, 3, 2, 1};  // a lost answer is the most serious
  const auto gravity = gravities[static_cast<std::size_t>(bucket.error_class)];
  return {whose, static_cast<std::uint64_t>(gravity),
          std::numeric_limits<std::uint64_t>::max() - count, index_of(bucket)};
}

bool is_unexplained(Verdict verdict) {
  constexpr std::array unexplained{Verdict::subject_wrong, Verdict::oracle_wrong,
                                   Verdict::both_wrong,    Verdict::crashed,
                                   Verdict::timed_out,     Verdict::malformed};
  return std::ranges::find(unexplained, verdict) != unexplained.end();
}

bool is_failure(const Bucket& bucket) {
  return is_unexplained(bucket.verdict) && bucket.verdict != Verdict::oracle_wrong;
}

}  // namespace manifuzz
