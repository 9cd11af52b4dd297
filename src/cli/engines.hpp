#pragma once

#include <span>
#include <string>
#include <string_view>

#include "collider/collider.hpp"

namespace manifuzz {

/// An engine in another language, asked by an adapter in scripts/colliders. In texts @ is that
/// folder.
struct Engine {
  std::string_view name;         ///< as the adapter declares it
  std::string_view description;  ///< one line for `list colliders`
  std::string_view adapter;      ///< the command of a program, or a shared library (*.so)
  std::string_view needs;        ///< a file without which it cannot be asked
  std::string_view tools;        ///< with what scripts/setup --engines can get that
  double seconds_max = 1;        ///< over a case
};

/// Every such engine, in the order of `list colliders`.
std::span<const Engine> engines();

/// Throws UserError that says what would make it so, where it cannot be asked here.
Collider collider_of(const Engine& engine);

/// The engine's shared library. Throws the same, and where it is asked as a program.
std::string library_of(const Engine& engine);

}  // namespace manifuzz
