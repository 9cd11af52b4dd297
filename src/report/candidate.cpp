#include "report/candidate.hpp"

namespace manifuzz {

const exact::Clip* candidate_to_show(const Admissible& right, const DeclaredAnswer& subject) {
  const auto find = [&](const auto& wanted) -> const exact::Clip* {
    const auto found = std::ranges::find_if(right.candidates, wanted);
    return found == right.candidates.end() ? nullptr : *found;
  };
  const exact::Clip* const own = find([&](const exact::Clip* clip) {
    return subject.count() > 0 && mismatch(*subject.manifold(), *clip, right).kind == Kind::none;
  });
  if (own != nullptr) return own;
  const exact::Clip* const met =
      find([&](const exact::Clip* clip) { return compare_gap(*clip, 0) <= 0; });
  if (met != nullptr || right.candidates.empty()) return met;
  return right.candidates.front();
}

}  // namespace manifuzz
