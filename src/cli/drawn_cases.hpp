#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {

/// The seed, regimes and indices of the cases that `generate` draws.
struct DrawOptions {
  std::vector<std::string> regimes;
  std::optional<std::uint64_t> seed;
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// Prints cases of these regimes, or families of another kind, by turns, a line each, as `draw`
/// makes them of a family and an index under the seed.
template <class Family, class Draw>
void print_drawn(const std::vector<const Family*>& families, const DrawOptions& options,
                 std::uint64_t seed, const Draw& draw) {
  Output out;
  std::string line;
  for (std::uint64_t k = 0; k < options.count; ++k) {
    const Family& family = *families[k % families.size()];
    const std::uint64_t index = options.first + k / families.size();
    line.clear();
    append_found_case_line(line, draw(family, index), {seed, std::string(family.name), index, {}});
    out.write(line += '\n');
  }
  out.flush();
}

}  // namespace manifuzz
