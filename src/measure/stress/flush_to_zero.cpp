#include "measure/stress/flush_to_zero.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace manifuzz {

#if defined(__SSE2__)

namespace {

constexpr unsigned kFlushResults = 0x8000;
constexpr unsigned kFlushInputs = 0x0040;

}  // namespace

bool can_flush_to_zero() {
  return true;
}

FlushToZero::FlushToZero(bool wanted) : wanted_(wanted) {
  if (!wanted_) return;
  before_ = _mm_getcsr();
  _mm_setcsr(before_ | kFlushResults | kFlushInputs);
}

FlushToZero::~FlushToZero() {
  if (wanted_) _mm_setcsr(before_);
}

#else

bool can_flush_to_zero() {
  return false;
}

FlushToZero::FlushToZero(bool wanted) : wanted_(wanted) {}

FlushToZero::~FlushToZero() = default;

#endif

}  // namespace manifuzz
