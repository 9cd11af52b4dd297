#pragma once

#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <string_view>
#include <unistd.h>

namespace manifuzz::test {

/// What a collider does on every 1,000th case, which one it is being told by the case.
inline bool is_unlucky(float x, float y) {
  unsigned bits[2] = {};
  std::memcpy(&bits[0], &x, sizeof x);
  std::memcpy(&bits[1], &y, sizeof y);
  return (bits[0] * 2654435761U ^ bits[1] * 40503U) % 1000 == 0;
}

/// As deep as the stack is, and then deeper: what it returns keeps each call.
inline int call_without_end(int depth) {
  std::array<volatile char, 4096> frame{};
  frame[0] = static_cast<char>(depth);
  return depth < std::numeric_limits<int>::max() ? call_without_end(depth + 1) + frame[0] : 0;
}

/// Where nobody may write.
inline void overwrite_constants() {
  static const std::array<char, 16> constants{};
  char* volatile to = const_cast<char*>(constants.data());
  std::memset(to, 0x5B, constants.size());
}

/// Ends its process, or never returns, where it is told to.
inline void end_process(std::string_view behaviour) {
  constexpr std::string_view raises = "raises-";
  if (behaviour.starts_with(raises)) {
    int signal = 0;
    std::from_chars(behaviour.data() + raises.size(), behaviour.data() + behaviour.size(), signal);
    std::raise(signal);
  }
  if (behaviour == "aborts") std::abort();
  if (behaviour == "terminates") std::terminate();
  if (behaviour == "throws") throw behaviour;
  if (behaviour == "allocates") static_cast<void>(::operator new (std::size_t{1} << 60));
  if (behaviour == "overflows") call_without_end(0);
  if (behaviour == "overwrites") overwrite_constants();
  if (behaviour == "quick-exits") std::quick_exit(0);
  if (behaviour == "becomes-another") execl("/bin/true", "true", static_cast<char*>(nullptr));
  if (behaviour == "closes-all") {
    for (int descriptor = 0; descriptor < 256; ++descriptor) close(descriptor);
    pause();
  }
  if (behaviour == "spins") {
    for (volatile bool is_on = true; is_on;) continue;
  }
  if (behaviour == "is-deaf") {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, nullptr);
    pause();
  }
}

/// Crashes or hangs where it is told to.
inline void misbehave(std::string_view behaviour, float x, float y) {
  if (behaviour == "dies") std::abort();
  if (behaviour == "hangs") pause();
  if (!is_unlucky(x, y)) return;
  end_process(behaviour);
  if (behaviour == "crashes") std::raise(SIGSEGV);
  if (behaviour == "exits") _exit(3);
  if (behaviour == "calls-exit") std::exit(0);
  if (behaviour == "sleeps") pause();
  if (behaviour == "stops") std::raise(SIGSTOP);
  if (behaviour == "leaves-its-group") {
    setpgid(0, getpgid(getppid()));
    pause();
  }
  if (behaviour == "leaves-a-child" && fork() > 0) _exit(3);
  if (behaviour == "leaves-a-child") {
    setsid();
    alarm(600);  // nobody else ends it
    pause();
  }
  if (behaviour == "closes-and-lives-on") {
    std::signal(SIGTERM, SIG_IGN);
    close(STDOUT_FILENO);
    pause();
  }
}

}  // namespace manifuzz::test
