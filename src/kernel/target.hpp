#pragma once

#include <string>
#include <vector>

namespace manifuzz::kernel {

/// The instruction sets that the kernels were built for and this machine has, the widest first.
std::vector<std::string> targets();

/// Makes every kernel use one of them from here on, in this process.
void use_target(const std::string& name);

}  // namespace manifuzz::kernel
