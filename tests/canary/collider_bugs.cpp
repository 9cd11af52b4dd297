#include "campaign/in_child.hpp"
#include "canary/blame.hpp"
#include "canary/planted.hpp"
#include "canary/search.hpp"
#include "corpus/shrink.hpp"
#include "generating/regime.hpp"
#include "oracle/box2d/box2d.hpp"
#include "properties/properties.hpp"

// Bugs planted into the collider: a campaign against Box2D must blame it, or a property must fail.

namespace manifuzz::canary {
namespace {

/// One round of the regimes in so many goes to the collider in double, too, and to every property.
constexpr std::uint64_t kPropertyShare = 8;

std::string sentence(const Property& property) {
  return "property " + std::string(property.name);
}

bool fails(const Property& property, const Collider& collider, const PairCase& pair) {
  return check(property, collider, pair).kind == PropertyOutcome::Kind::fails;
}

/// The three that may notice, by name.
struct Watch {
  Collider in_float;
  Collider in_double;
  Collider oracle = make_box2d();

  std::optional<Noticed> notice(std::uint64_t number, const PairCase& pair) const {
    if (const auto blamed = blame(pair, in_float, oracle)) {
      return Noticed{"judge of clip", to_string(blamed->bucket)};
    }
    if (number / regimes().size() % kPropertyShare != kPropertyShare - 1) return std::nullopt;
    if (const auto blamed = blame(pair, in_double, oracle)) {
      return Noticed{"judge of clip64", to_string(blamed->bucket)};
    }
    for (const Property& property : properties()) {
      if (fails(property, in_float, pair)) return Noticed{sentence(property), sentence(property)};
    }
    return std::nullopt;
  }

  Shrunk shrunk(const PairCase& pair, const std::string& by) const {
    Interruption interruption;
    if (by == "judge of clip") return shrink_finding(pair, in_float, oracle, interruption);
    if (by == "judge of clip64") return shrink_finding(pair, in_double, oracle, interruption);
    for (const Property& property : properties()) {
      if (by != sentence(property)) continue;
      return shrink(pair,
                    [&](const PairCase& smaller) { return fails(property, in_float, smaller); });
    }
    return {pair};
  }
};

void add_collider(const Bug& bug, const MakeCollider& make) {
  planted_colliders().push_back([=](double tie_bias) { return with_bug(bug, make(tie_bias)); });
  const auto search_both = [make = planted_colliders().back()](const Haystack& haystack) {
    const Collider collider = make(0);
    const Watch watch{collider, collider.in_double()};
    return search(
        haystack,
        [&](std::uint64_t number, const PairCase& pair) { return watch.notice(number, pair); },
        [&](std::uint64_t, const PairCase& pair, const Noticed& noticed) {
          return watch.shrunk(pair, noticed.by);
        });
  };
  add_planted_bug({.name = bug.name,
                   .cases_max = 200'000,
                   .search = search_both,
                   .collider = [make = planted_colliders().back()] { return make(0); }});
}

}  // namespace

/// The collider with the bug acting whenever it is asked.
Collider with_bug(const Bug& bug, Collider collider) {
  const auto ask = [bug](const auto& function) {
    return [bug, function](const auto&... arguments) {
      const Acting acting(bug);
      return function(arguments...);
    };
  };
  const auto make = [bug](const auto& function) {
    return
        [bug, function](const auto&... arguments) { return with_bug(bug, function(arguments...)); };
  };
  collider.collide = ask(collider.collide);
  collider.from_normal = ask(collider.from_normal);
  collider.with_tie_bias = make(collider.with_tie_bias);
  collider.in_double = make(collider.in_double);
  return collider;
}

std::vector<MakeCollider>& planted_colliders() {
  static std::vector<MakeCollider> all;
  return all;
}

bool add_colliders(const std::vector<Bug>& bugs, const MakeCollider& make) {
  for (const Bug& bug : bugs) add_collider(bug, make);
  return true;
}
}  // namespace manifuzz::canary
