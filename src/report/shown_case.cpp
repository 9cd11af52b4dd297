#include "report/shown_case.hpp"

namespace manifuzz {

GreatestFace greatest_face(const truth::World<truth::Real>& world, Side side) {
  const auto separations = truth::face_separations(world, side);
  const auto* const begin = separations.data();
  const auto* const greatest = std::max_element(begin, begin + world[side].count);
  return {static_cast<int>(greatest - begin), *greatest};
}

const Candidate* candidate_to_show(const Admissible& right, const Party& subject) {
  const auto find = [&](const auto& wanted) -> const Candidate* {
    const auto found = std::find_if(right.candidates.begin(), right.candidates.end(), wanted);
    return found == right.candidates.end() ? nullptr : &*found;
  };
  const Candidate* const own = find([&](const Candidate& candidate) {
    return subject.count() > 0 &&
           mismatch(*subject.manifold(), candidate, right).kind == Kind::none;
  });
  if (own != nullptr) return own;
  const Candidate* const met = find([](const Candidate& c) { return c.clip.gap <= 0; });
  if (met != nullptr || right.candidates.empty()) return met;
  return &right.candidates.front();
}

}  // namespace manifuzz
