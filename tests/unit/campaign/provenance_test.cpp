#include "engines/provenance.hpp"

#include <catch2/catch.hpp>

#include "kernel/target.hpp"

namespace manifuzz {

TEST_CASE("the instruction set is the one that the kernels choose when they run") {
  const auto json = provenance(7, {});
  CHECK(json.at("seed") == 7);
  CHECK(json.at("machine").at("instruction_set") == kernel::targets().front());
}

}  // namespace manifuzz
