#pragma once

#include <cfenv>
#include <cstddef>
#include <string_view>

namespace manifuzz {

/// What a call did to this process that does not show in what it returns.
enum class SideEffect : int { none, forked, rounding, subnormals, traps, precision };

/// "changed the rounding mode"; empty for none.
std::string_view in_words(SideEffect effect);

/// What of the floating point environment decides what others compute: all but the flags of what
/// has happened.
struct FloatingPointControl {
#if defined(__x86_64__)
  unsigned sse = 0;
  unsigned short x87 = 0;
#else
  std::fenv_t all{};
  int rounding = FE_TONEAREST;
  bool loses_subnormals = false;
#endif
};
FloatingPointControl floating_point_control();

/// Lives around a call into code that may do anything.
class CallWatch {
 public:
  CallWatch();
  CallWatch& operator=(CallWatch&&) = delete;  // neither moved nor copied

  /// Undoes what the call did, and says what that was. A process that was forked within the call
  /// does not return from here: it ends.
  SideEffect end() const;
  /// Whether this process was forked within the call.
  bool is_in_forked() const;

 private:
  FloatingPointControl control_;
  std::size_t forks_;
  std::size_t times_forked_;
};

}  // namespace manifuzz
