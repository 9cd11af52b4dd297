#include "measure/judged_errors.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "judging/completed.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {
namespace {

struct Measured {
  double value = 0;
  const PairCase* pair = nullptr;
};

ErrorSpread spread_of(std::vector<Measured> errors) {
  if (errors.empty()) return {};
  std::ranges::sort(errors, {}, &Measured::value);
  const auto at = [&](double share) {
    const double rank = std::ceil(share * static_cast<double>(errors.size()));
    return errors[static_cast<std::size_t>(std::max(rank, 1.0)) - 1].value;
  };
  return {at(0.5), at(0.999), errors.back().value, *errors.back().pair};
}

ManifoldError error_of(const Manifold<double>& manifold, const Admissible& right) {
  const auto measured = error_if_right(manifold, right);
  return measured ? measured->error : plain_error(manifold, right);
}

}  // namespace

JudgedErrors judged_errors(const Collider& collider, std::span<const PairCase> pairs) {
  JudgedErrors result;
  std::vector<Measured> depth;
  std::vector<Measured> position;
  std::vector<Measured> normal;
  for (const PairCase& pair : pairs) {
    const Answer answer = ask(collider, pair);
    const auto* const manifold = std::get_if<Manifold<double>>(&answer);
    if (manifold == nullptr) continue;
    ++result.cases;
    const Admissible right = admissible(pair, collider.declaration);
    if (manifold->count == 0) {
      const bool missed = right.may_touch && !right.may_be_apart;
      result.missed += missed && mismatch(*manifold, right).kind != Kind::none;
      continue;
    }
    result.phantom += !right.may_touch;
    const double unit = 0x1p-24 * extent(pair);
    const ManifoldError error = error_of(*manifold, right);
    depth.push_back({error.depth / unit, &pair});
    position.push_back({error.position / unit, &pair});
    normal.push_back({error.normal / 0x1p-24, &pair});
  }
  result.depth = spread_of(std::move(depth));
  result.position = spread_of(std::move(position));
  result.normal = spread_of(std::move(normal));
  return result;
}

}  // namespace manifuzz
