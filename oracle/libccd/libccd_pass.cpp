#include "oracle/libccd/libccd_pass.hpp"

#include <memory>
#include <vector>

#include "oracle/external/external_collider.hpp"
#include "oracle/libccd/prism.hpp"

namespace manifuzz {
namespace {

std::function<void()> pass_with(manifuzz_libccd::Penetration penetration,
                                std::span<const PairCase> pairs) {
  struct Prepared {
    manifuzz_libccd::PrismPair pair;
    manifuzz_libccd::Penetrated found{};
  };
  const auto all = std::make_shared<std::vector<Prepared>>();
  for (const PairCase& pair : pairs) all->push_back({{c_body(pair.a), c_body(pair.b)}});
  return [all, penetration] {
    for (Prepared& one : *all) one.found = manifuzz_libccd::ask(penetration, one.pair);
  };
}

}  // namespace

std::function<void()> libccd_gjk_pass(std::span<const PairCase> pairs) {
  return pass_with(ccdGJKPenetration, pairs);
}

std::function<void()> libccd_mpr_pass(std::span<const PairCase> pairs) {
  return pass_with(ccdMPRPenetration, pairs);
}

}  // namespace manifuzz
