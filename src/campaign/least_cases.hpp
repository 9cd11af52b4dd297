#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace manifuzz {

/// The least numbers of all that were added, each once: plain data that no order of adding changes.
class LeastCases {
 public:
  static constexpr std::size_t kRoom = 64;

  void add(std::uint64_t number);
  void add(const LeastCases& others);
  /// Sorted.
  std::span<const std::uint64_t> all() const { return {numbers_.data(), count_}; }

 private:
  std::array<std::uint64_t, kRoom> numbers_{};
  std::size_t count_ = 0;
};

}  // namespace manifuzz
