#include "oracle/libccd/libccd_pass.hpp"

#include <memory>
#include <vector>

#include "external/external_collider.hpp"
#include "oracle/libccd/penetration.hpp"

namespace manifuzz {
namespace {

std::function<void()> pass_with(const manifuzz_libccd::Algorithm& algorithm,
                                std::span<const PairCase> pairs) {
  struct Prepared {
    manifuzz_libccd::PrismPair pair;
    manifuzz_libccd::Penetrated found{};
  };
  const auto all = std::make_shared<std::vector<Prepared>>();
  for (const PairCase& pair : pairs) {
    all->push_back({{c_body(pair.a), c_body(pair.b), algorithm.half_heights}});
  }
  return [all, algorithm] {
    for (Prepared& one : *all) one.found = manifuzz_libccd::ask(algorithm, one.pair);
  };
}

}  // namespace

std::function<void()> libccd_gjk_pass(std::span<const PairCase> pairs) {
  return pass_with(manifuzz_libccd::kGjk, pairs);
}

std::function<void()> libccd_mpr_pass(std::span<const PairCase> pairs) {
  return pass_with(manifuzz_libccd::kMpr, pairs);
}

}  // namespace manifuzz
