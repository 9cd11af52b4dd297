#pragma once

namespace manifuzz {

/// Whether this processor can be told to, as far as is known here.
bool can_flush_to_zero();

/// As long as it lives, and where it is wanted, this thread takes subnormal numbers for zero, and
/// makes none: what many an engine asks of the processor.
class FlushToZero {
 public:
  explicit FlushToZero(bool wanted);
  ~FlushToZero();
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  bool wanted_;
  unsigned before_ = 0;
};

}  // namespace manifuzz
