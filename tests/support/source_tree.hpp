#pragma once

#include <filesystem>

namespace manifuzz::test {

/// The top of the source tree that these tests were built from.
inline std::filesystem::path source_dir() {
  return MANIFUZZ_SOURCE_DIR;
}

}  // namespace manifuzz::test
