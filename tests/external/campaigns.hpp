#pragma once

#include <cstdlib>
#include <string>

#include "campaign/run.hpp"
#include "external/external_collider.hpp"

// Short campaigns against the library and the program that behave as they are told.

namespace manifuzz::test {

inline constexpr double kSecondsMax = 1;  // enough on a busy machine
inline constexpr std::uint64_t kCases = 3000;

/// Tells libraries that are loaded while it lives what to do.
class Told {
 public:
  explicit Told(const char* behaviour) { setenv("MANIFUZZ_TEST_BEHAVIOUR", behaviour, 1); }
  ~Told() { unsetenv("MANIFUZZ_TEST_BEHAVIOUR"); }
  Told(const Told&) = delete;
  Told& operator=(const Told&) = delete;
};

Collider library();
Collider program(const std::string& behaviour);

/// Against clip64.
Plan plan_of(const Collider& subject);
JobsResult run(const Plan& plan);

/// How many of the plan's cases a collider that is told so fails at.
std::uint64_t unlucky(const Plan& plan);

/// That the campaign of such a subject loses those cases, and no other.
void check_loses(const Collider& subject, Verdict verdict);

/// How many findings have that kind.
std::uint64_t count_of(const JobsResult& result, Kind kind);

}  // namespace manifuzz::test
