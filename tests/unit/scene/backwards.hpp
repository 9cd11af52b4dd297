#pragma once

#include <cstddef>
#include <functional>

namespace manifuzz::test {

/// An executor that runs tasks on the caller's thread, from the last to the first.
inline void backwards(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = count; i-- > 0;) task(i);
}

}  // namespace manifuzz::test
