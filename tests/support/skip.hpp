#pragma once

#include <atomic>
#include <iostream>
#include <string_view>

namespace manifuzz::test {

/// Whether any test of this run was skipped, in whole or in part.
inline std::atomic<bool> is_anything_skipped = false;

/// The status of a program whose tests passed, as far as they were not skipped (as in Automake).
inline constexpr int kSkippedStatus = 77;

/// Reports this test, or what is left of it, as skipped. What it checked before counts: where any
/// of it failed, the test fails.
inline void skip(std::string_view reason) {
  is_anything_skipped = true;
  std::cout << "this test is skipped: " << reason << std::endl;
}

}  // namespace manifuzz::test
