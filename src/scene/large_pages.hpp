#pragma once

#include <cstddef>
#include <vector>

namespace manifuzz::scene {

/// Memory of so many bytes. What fills pages of 2 MB is in such ones, if the system grants them: an
/// entry of the processor's page tables then stands for 512.
void* allocate_in_large_pages(std::size_t bytes);
/// Gives it back; `bytes` as it was asked for.
void free_in_large_pages(void* memory, std::size_t bytes);

/// An allocator of such memory.
template <class T>
struct LargePages {
  using value_type = T;  ///< as every allocator has it
  LargePages() = default;
  /// From that of another type.
  template <class U>
  explicit LargePages(const LargePages<U>&) {}

  /// Memory for so many.
  T* allocate(std::size_t count) {
    static_assert(alignof(T) <= 64);
    return static_cast<T*>(allocate_in_large_pages(count * sizeof(T)));
  }
  /// Gives it back; `count` as it was asked for.
  void deallocate(T* memory, std::size_t count) { free_in_large_pages(memory, count * sizeof(T)); }

  /// Any gives back what another gave.
  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

/// A vector whose elements are reached in no order of theirs, and that grows beyond the caches.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace manifuzz::scene
