#include "external/side_effects.hpp"

#include <array>
#include <limits>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace manifuzz {
namespace {

/// With this status a forked process ends, so that it is known from other children.
constexpr int kForkedStatus = 86;

/// How many forks this process has seen, of itself and of those that it was forked from; and how
/// many of them made it.
std::size_t forks = 0;
std::size_t times_forked = 0;

void watch_forks() {
  static const int is_watching = pthread_atfork(
      nullptr, [] { ++forks; }, [] { ++forks, ++times_forked; });
  static_cast<void>(is_watching);
}

/// Takes the ended children out of the table of processes, which they would fill.
void bury_forked() {
  for (;;) {
    siginfo_t ended{};
    const int options = WEXITED | WNOHANG | WNOWAIT;
    const bool is_forked = waitid(P_ALL, 0, &ended, options) == 0 && ended.si_pid > 0 &&
                           ended.si_code == CLD_EXITED && ended.si_status == kForkedStatus;
    if (!is_forked) return;
    waitpid(ended.si_pid, nullptr, 0);
  }
}

#if defined(__x86_64__)

constexpr unsigned kSseFlags = 0x3F;
constexpr unsigned kSseRounding = 0x6000;
constexpr unsigned kSseSubnormals = 0x8040;  // flush to zero, denormals are zero
constexpr unsigned kX87Rounding = 0x0C00;
constexpr unsigned kX87Precision = 0x0300;

SideEffect difference(const FloatingPointControl& a, const FloatingPointControl& b) {
  const unsigned sse = a.sse ^ b.sse;
  const auto x87 = static_cast<unsigned>(a.x87 ^ b.x87);
  if ((sse & kSseRounding) != 0 || (x87 & kX87Rounding) != 0) return SideEffect::rounding;
  if ((sse & kSseSubnormals) != 0) return SideEffect::subnormals;
  if ((x87 & kX87Precision) != 0) return SideEffect::precision;
  return sse != 0 || x87 != 0 ? SideEffect::traps : SideEffect::none;
}

void restore(const FloatingPointControl& control) {
  _mm_setcsr(control.sse);
  asm volatile("fldcw %0" : : "m"(control.x87));
}

#else

/// Computed when asked: `volatile` keeps the compiler from knowing better.
bool loses_subnormals() {
  volatile double least = std::numeric_limits<double>::min();
  return least / 2 == 0;
}

SideEffect difference(const FloatingPointControl& a, const FloatingPointControl& b) {
  if (a.rounding != b.rounding) return SideEffect::rounding;
  return a.loses_subnormals != b.loses_subnormals ? SideEffect::subnormals : SideEffect::none;
}

void restore(const FloatingPointControl& control) {
  std::fesetenv(&control.all);
}

#endif

}  // namespace

std::string_view in_words(SideEffect effect) {
  constexpr std::array<std::string_view, 6> words{
      "",
      "forked this process",
      "changed the rounding mode",
      "changed what becomes of subnormal numbers (flush to zero)",
      "changed which floating point exceptions trap",
      "changed the precision of the x87 unit"};
  return words[static_cast<std::size_t>(effect)];
}

FloatingPointControl floating_point_control() {
#if defined(__x86_64__)
  FloatingPointControl control{.sse = _mm_getcsr() & ~kSseFlags};
  asm volatile("fnstcw %0" : "=m"(control.x87));
  return control;
#else
  FloatingPointControl control{.rounding = std::fegetround(),
                               .loses_subnormals = loses_subnormals()};
  std::fegetenv(&control.all);
  return control;
#endif
}

CallWatch::CallWatch() : control_(floating_point_control()) {
  watch_forks();
  forks_ = forks;
  times_forked_ = times_forked;
  if (forks > 0) bury_forked();
}

bool CallWatch::is_in_forked() const {
  return times_forked != times_forked_;
}

SideEffect CallWatch::end() const {
  if (is_in_forked()) _exit(kForkedStatus);
  const SideEffect effect = difference(control_, floating_point_control());
  if (effect != SideEffect::none) restore(control_);
  return forks == forks_ ? effect : SideEffect::forked;
}

}  // namespace manifuzz
