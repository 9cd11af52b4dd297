#include "unit/memory/failing_allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kNever = ~std::size_t{0};
std::atomic<std::size_t> left = kNever;  // allocations before the one that fails

void* allocate(std::size_t bytes, std::size_t alignment) {
  if (left != kNever && left-- == 0) throw std::bad_alloc();
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  void* const memory = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

namespace manifuzz::test {

FailingAllocation::FailingAllocation(std::size_t after) {
  left = after;
}

FailingAllocation::~FailingAllocation() {
  left = kNever;
}

bool FailingAllocation::has_failed() const {
  return left == kNever;
}

}  // namespace manifuzz::test

void* operator new(std::size_t bytes) {
  return allocate(bytes, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
