#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace manifuzz::scene {

/// No body, and no place.
inline constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Room for so many, in steps that leave little memory unused.
template <class T>
void make_room(std::vector<T>& vector, std::size_t size) {
  if (size > vector.capacity()) vector.reserve(size + size / 8 + 16);
}

/// The same, and that many there.
template <class T>
void resize(std::vector<T>& vector, std::size_t size) {
  make_room(vector, size);
  vector.resize(size);
}

/// Empties a list of what happened to so many bodies; where it once held most of them, and does no
/// more, its memory goes.
template <class T>
void clear_for(std::vector<T>& list, std::size_t bodies) {
  const bool is_large = list.capacity() > bodies / 8 + 64;
  if (is_large && list.size() < list.capacity() / 4) list = std::vector<T>();
  list.clear();
}

}  // namespace manifuzz::scene
