#pragma once

#include <cstddef>
#include <cstdint>

namespace manifuzz::scene {

/// No body, and no place.
inline constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Room for so many, in steps that leave little memory unused.
template <class Vector>
void make_room(Vector& vector, std::size_t size) {
  if (size > vector.capacity()) vector.reserve(size + size / 8 + 16);
}

/// Makes a list this long, in steps that leave little memory unused.
template <class Vector>
void resize(Vector& vector, std::size_t size) {
  make_room(vector, size);
  vector.resize(size);
}

/// Adds others to a list, in steps that leave little memory unused.
template <class Vector, class Others>
void append(Vector& vector, const Others& others) {
  make_room(vector, vector.size() + others.size());
  vector.insert(vector.end(), others.begin(), others.end());
}

/// The memory that a list takes.
template <class Vector>
std::size_t bytes_of(const Vector& list) {
  return list.capacity() * sizeof(list[0]);
}

/// Asks for an element ahead of its use; there need be none.
template <class Vector>
void ask_for(const Vector& vector, std::size_t place) {
  const auto first = reinterpret_cast<std::uintptr_t>(vector.data());
  __builtin_prefetch(reinterpret_cast<const void*>(first + place * sizeof(vector[0])));
}

/// Asks for a whole list: faster than element by element, where most are to be read in an order
/// that is not theirs.
template <class Vector>
void ask_for_all(const Vector& vector) {
  constexpr std::size_t kLine = 64;
  constexpr int kToSecondCache = 2;
  const auto* const bytes = reinterpret_cast<const char*>(vector.data());
  const std::size_t size = vector.size() * sizeof(vector[0]);
  for (std::size_t at = 0; at < size; at += kLine) {
    __builtin_prefetch(bytes + at, 0, kToSecondCache);
  }
}

/// Empties a list of what happened to so many bodies; where it once held most of them, and does no
/// more, its memory goes.
template <class Vector>
void clear_for(Vector& list, std::size_t bodies) {
  const bool is_large = list.capacity() > bodies / 8 + 64;
  if (is_large && list.size() < list.capacity() / 4) list = Vector();
  list.clear();
}

}  // namespace manifuzz::scene
