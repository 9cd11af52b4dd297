#pragma once

#include <algorithm>
#include <hwy/base.h>

namespace manifuzz {

#if HWY_IS_MSAN

/// Numbers to be loaded into lanes, of which the first `used` are somebody's. Nobody takes what
/// comes of the others, which may be memory that nobody wrote: MemorySanitizer, which does not see
/// that they are not taken, meets a copy with numbers in their place that would show in any answer.
template <int size, class Scalar>
class LaneMemory {
 public:
  LaneMemory(const Scalar* from, int used) {
    std::copy_n(from, std::min(used, size), copy_);
    std::fill(copy_ + std::min(used, size), copy_ + size, Scalar{0x1p60});
  }
  operator const Scalar*() const { return copy_; }

 private:
  Scalar copy_[size];
};

template <int size, class Scalar>
LaneMemory<size, Scalar> lane_memory(const Scalar* from, int used) {
  return {from, used};
}

#else

/// Where `size` numbers are loaded from, of which the first `used` are somebody's.
template <int size, class Scalar>
HWY_INLINE const Scalar* lane_memory(const Scalar* from, int /*used*/) {
  return from;
}

#endif

}  // namespace manifuzz
