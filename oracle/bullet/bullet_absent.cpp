#include "oracle/bullet/bullet_cached.hpp"
#include "oracle/bullet/bullet_pass.hpp"

namespace manifuzz {

std::function<void()> bullet_epa_pass(std::span<const PairCase>) {
  return {};
}

std::function<void()> bullet_minkowski_pass(std::span<const PairCase>) {
  return {};
}

std::function<void()> bullet_perturbed_pass(std::span<const PairCase>) {
  return {};
}

std::optional<SequenceCollider> make_bullet_cached() {
  return std::nullopt;
}

}  // namespace manifuzz
