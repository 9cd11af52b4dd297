#pragma once

// What most sources include of other projects, parsed once a build. Each source still includes what
// it uses: builds without unity, as those for debugging and clang-tidy are, do without this.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
