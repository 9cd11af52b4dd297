#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "manifuzz_collider.h"

// MANIFUZZ_PLANTED names a file that counts, for whoever compares how soon bugs are met: whole
// numbers of 8 bytes, the evaluations and then, of each bug, the first one that met it, or 0.

#if defined(__clang__)
#define MANIFUZZ_NOT_COVERED __attribute__((no_sanitize("coverage"), noinline))
#else
#define MANIFUZZ_NOT_COVERED __attribute__((noinline))
#endif

namespace planted {

using Count = std::atomic<std::uint64_t>;
constexpr std::size_t kCounts = 64;

/// In memory that every process has, for a hunt has several.
MANIFUZZ_NOT_COVERED inline Count* make_counts() {
  const char* const path = std::getenv("MANIFUZZ_PLANTED");
  const int file = path == nullptr ? -1 : open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  constexpr std::size_t size = kCounts * sizeof(Count);
  if (file < 0 || ftruncate(file, size) != 0) return nullptr;
  void* const memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<Count*>(memory);
}

MANIFUZZ_NOT_COVERED inline Count* counts() {
  static Count* const all = make_counts();
  return all;
}

MANIFUZZ_NOT_COVERED inline void begin_evaluation() {
  if (counts() != nullptr) ++counts()[0];
}

/// Notes that the bug is met, and loses the contact.
MANIFUZZ_NOT_COVERED inline void meet(std::size_t bug, manifuzz_manifold& manifold) {
  manifold = {};
  if (counts() == nullptr) return;
  std::uint64_t none = 0;
  counts()[1 + bug].compare_exchange_strong(none, counts()[0]);
}

}  // namespace planted
