#pragma once

#include <functional>
#include <span>
#include <string>

#include "collider/collider.hpp"

namespace manifuzz {

/// Something that is timed: one way to ask one collider.
struct BenchSubject {
  std::string name;
  std::string query = "manifold";  ///< or touches, separation
  std::string input = "pair";      ///< or packed, indices
  std::string target{};  ///< the instruction set that the kernels are to use; empty: it asks none
  /// Lays pairs out as the collider's users hold them, and gives what goes through all of them
  /// once. What it needs lives in the function.
  std::function<std::function<void()>(std::span<const PairCase>)> prepare{};
  /// For the errors; empty where it gives no manifolds.
  std::function<Collider()> collider{};
};

/// The subject to whose time every other's is a ratio.
inline constexpr std::string_view kRatioBase = "box2d";

}  // namespace manifuzz
