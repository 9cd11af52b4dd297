#pragma once

#include <catch2/catch.hpp>

#include "kernel/target.hpp"

namespace manifuzz::test {

/// Asks the kernels as each instruction set of this machine in turn.
template <class Check>
void on_every_target(const Check& check) {
  const std::vector<std::string> targets = kernel::targets();
  for (const std::string& target : targets) {
    kernel::use_target(target);
    INFO(target);
    check();
  }
  kernel::use_target(targets.front());
}

}  // namespace manifuzz::test
