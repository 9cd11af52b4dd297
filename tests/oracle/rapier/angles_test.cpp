#include "oracle/rapier/angles.hpp"

#include <catch2/catch.hpp>

using namespace manifuzz;

TEST_CASE("Rapier's sine and cosine are within a float's last bit in every quarter turn") {
  for (int i = -1700; i <= 1700; ++i) {
    const auto angle = static_cast<double>(static_cast<float>(i) / 256);
    CAPTURE(angle);
    CHECK(std::abs(static_cast<double>(parry::sine_of_wasm(angle)) - std::sin(angle)) <= 0x1p-24);
    CHECK(std::abs(static_cast<double>(parry::cosine_of_wasm(angle)) - std::cos(angle)) <= 0x1p-24);
  }
  CHECK(parry::sine_of_wasm(0x1p-13) == 0x1p-13F);
  CHECK(parry::cosine_of_wasm(0x1p-13) == 1);
}
