#pragma once

#include <cstddef>
#include <new>

#include <catch2/catch.hpp>

// In a program that links this, memory runs out when a test says so.

namespace manifuzz::test {

/// While it lives, one allocation fails: the one after so many others, whatever asks for it.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::size_t after);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// Whether it has failed.
  bool has_failed() const;
};

/// Makes a call for which there is memory for so many allocations; whether that ran out. Fails the
/// test where the call does not tell so by std::bad_alloc, or tells so without cause.
template <class Call>
bool runs_out(std::size_t after, const Call& call) {
  bool has_thrown = false;
  bool has_failed = false;
  {
    const FailingAllocation failing(after);
    try {
      call();
    } catch (const std::bad_alloc&) {
      has_thrown = true;
    }
    has_failed = failing.has_failed();
  }
  REQUIRE(has_thrown == has_failed);
  return has_failed;
}

}  // namespace manifuzz::test
