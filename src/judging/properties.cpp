#include "judging/properties.hpp"

#include <algorithm>
#include <array>

#include "judging/asked_collider.hpp"
#include "judging/ledger.hpp"
#include "judging/property_list.hpp"

namespace manifuzz {
namespace {

#define MANIFUZZ_ENTRY(function, name, sentence) Property{name, sentence, function},
constexpr std::array kProperties{MANIFUZZ_PROPERTIES(MANIFUZZ_ENTRY)};
#undef MANIFUZZ_ENTRY

bool is_explained(const Collider& collider, const PairCase& pair) {
  const Answer answer = ask(collider, pair);
  const auto* got = std::get_if<Manifold<double>>(&answer);
  if (got == nullptr) return false;
  const Admissible right = admissible(pair, collider.declaration);
  const Kind kind = mismatch(*got, right).kind;
  return kind != Kind::none &&
         find_explanation(collider.declaration.name, {right, *got, kind}) != nullptr;
}

}  // namespace

std::span<const Property> properties() {
  return kProperties;
}

const Property* find_property(std::string_view name) {
  const auto found = std::find_if(kProperties.begin(), kProperties.end(),
                                  [name](const Property& p) { return p.name == name; });
  return found == kProperties.end() ? nullptr : &*found;
}

Outcome check(const Property& property, const Collider& collider, const PairCase& pair) {
  if (is_ill_posed(pair, bounds(pair, collider.declaration))) return not_applicable();
  AskedCollider ask(collider);
  Outcome outcome = property.holds(ask, pair);
  if (ask.lost()) return fails("no answer: " + ask.lost()->why, 1);
  if (outcome.kind == Outcome::Kind::fails &&
      std::any_of(ask.asked().begin(), ask.asked().end(),
                  [&](const PairCase& asked) { return is_explained(collider, asked); })) {
    outcome.kind = Outcome::Kind::known;
  }
  return outcome;
}

std::optional<Admissible> decided(const PairCase& pair, const Declaration& declaration) {
  Admissible right = admissible(pair, declaration);
  if (is_ill_posed(pair, right.bounds) || right.candidates.size() != 1) return std::nullopt;
  const exact::Clip& only = *right.candidates.front();
  const double undecided = declaration.tie_bias + right.bounds.separation;
  const bool leads = right.truth->compare_lead_of_b(undecided) > 0 ||
                     right.truth->compare_lead_of_b(-undecided) < 0;
  if (!leads || right.may_be_apart || only.count < 2 || may_miss(right, only)) return std::nullopt;
  for (const exact::ClipPoint& point : only.points) {
    const double depth = depth_bound(right, only, point);
    if (!features_decided(right, only, point) ||
        (compare_depth(only, point, depth) <= 0 && compare_depth(only, point, -depth) >= 0)) {
      return std::nullopt;
    }
  }
  return right;
}

Tolerance tolerance(const Admissible& right) {
  Tolerance within{.normal = 2 * right.bounds.normal, .position = 0, .depth = 0};
  const exact::Clip& clip = *right.candidates.front();
  for (int i = 0; i < clip.count; ++i) {
    within.position = std::max(within.position, 2 * position_bound(right, clip, clip.points[i]));
    within.depth = std::max(within.depth, 2 * depth_bound(right, clip, clip.points[i]));
  }
  return within;
}

Outcome same_manifold(const PairCase& pair, const Manifold<double>& expected,
                      const Manifold<double>& got, const Tolerance& within, Features features) {
  const double unit = size(pair);
  if (expected.count != got.count) return fails("another number of points", 1);
  if (expected.count == 0) return holds();
  if (expected.reference != got.reference) return fails("another reference polygon", 1);
  const double turn = (expected.normal - got.normal).norm();
  if (!(turn <= within.normal)) return fails("another normal", turn);
  for (int i = 0; i < expected.count; ++i) {
    const auto& p = expected.points[i];
    const auto& q = got.points[i];
    const double off = (p.position - q.position).norm();
    if (!(off <= within.position)) return fails("another position", off / unit);
    const double deeper = std::abs(p.depth - q.depth);
    if (!(deeper <= within.depth)) return fails("another depth", deeper / unit);
    if (features == Features::compared && p.features != q.features) {
      return fails("other features", 0);
    }
  }
  return holds();
}

}  // namespace manifuzz
