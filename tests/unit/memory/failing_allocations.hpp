#pragma once

#include <cstddef>

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

}  // namespace manifuzz::test
