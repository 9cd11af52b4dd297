#include "judging/properties.hpp"

#include <algorithm>
#include <array>

#include "judging/ledger.hpp"
#include "judging/properties_shared.hpp"
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

}  // namespace manifuzz
