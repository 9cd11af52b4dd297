#pragma once

#include <vector>

#include "unit/layout.hpp"

namespace manifuzz::test {

/// Every committed file that is there, read once.
const std::vector<SourceFile>& tree();

}  // namespace manifuzz::test
