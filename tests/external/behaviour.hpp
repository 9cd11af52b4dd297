#pragma once

#include <csignal>
#include <cstdlib>
#include <cstring>
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

/// Crashes or hangs where it is told to.
inline void misbehave(std::string_view behaviour, float x, float y) {
  if (behaviour == "dies") std::abort();
  if (behaviour == "hangs") pause();
  if (!is_unlucky(x, y)) return;
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
