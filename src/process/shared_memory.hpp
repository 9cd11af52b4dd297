#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace manifuzz {

/// Zeroed memory that children share with their parent. Throws std::bad_alloc.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  void* data() const { return data_; }

 private:
  void* data_;
  std::size_t bytes_;
};

/// A value in shared memory, or several. T must hold no pointers and need no destructor.
template <class T>
class Shared {
 public:
  explicit Shared(std::size_t count = 1)
      : memory_(count * sizeof(T)), values_(static_cast<T*>(memory_.data()), count) {
    std::uninitialized_value_construct(values_.begin(), values_.end());
  }
  T& operator*() const { return values_[0]; }
  T* operator->() const { return values_.data(); }
  T& operator[](std::size_t i) const { return values_[i]; }
  std::span<T> all() const { return values_; }

 private:
  SharedMemory memory_;
  std::span<T> values_;
};

/// Text for shared memory; what is too long is cut off.
template <std::size_t Size>
class SharedText {
 public:
  void set(std::string_view text) { characters_[text.copy(characters_.data(), Size - 1)] = 0; }
  void set(const char* text) { set(std::string_view(text == nullptr ? "" : text)); }
  const char* c_str() const { return characters_.data(); }
  std::string str() const { return c_str(); }

 private:
  std::array<char, Size> characters_{};
};

}  // namespace manifuzz
