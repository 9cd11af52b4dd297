#pragma once

#include <string_view>

#include "collider/collider.hpp"

namespace manifuzz::test {

/// The place of a bug in the list of rare bugs.
std::size_t index_of_bug(std::string_view name);

/// The clip, its depths greater by a quarter of the size where the bug is met.
Collider with_rare_bug(std::string_view name);

}  // namespace manifuzz::test
