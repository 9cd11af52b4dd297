#pragma once

#include <iostream>
#include <string_view>

namespace manifuzz::test {

/// Reports this test as skipped: ctest takes it from this line (tests/CMakeLists.txt). To be
/// followed by a return, before anything is checked.
inline void skip(std::string_view reason) {
  std::cout << "this test is skipped: " << reason << std::endl;
}

}  // namespace manifuzz::test
