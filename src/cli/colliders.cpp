#include "cli/colliders.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "clipping/collider.hpp"
#include "oracle/box2d/box2d.hpp"

namespace manifuzz {

const std::vector<ColliderEntry>& colliders() {
  static const std::vector<ColliderEntry> all = {
      {"clip", [] { return make_clip(); }},
      {"clip64", [] { return make_clip64(); }},
      {"box2d", [] { return make_box2d(); }},
  };
  return all;
}

Collider find_collider(std::string_view name, std::optional<double> tie_bias) {
  const auto entry = std::find_if(colliders().begin(), colliders().end(),
                                  [name](const ColliderEntry& e) { return e.name == name; });
  if (entry == colliders().end()) {
    std::vector<std::string_view> names;
    std::transform(colliders().begin(), colliders().end(), std::back_inserter(names),
                   [](const ColliderEntry& e) { return e.name; });
    throw UserError(fmt::format("there is no collider '{}'; there are {}", printable(name),
                                fmt::join(names, ", ")));
  }
  Collider collider = entry->make();
  if (!tie_bias) return collider;
  if (!collider.with_tie_bias) {
    throw UserError(fmt::format("--tie-bias: that of {} is fixed at {:g}", name,
                                collider.declaration.tie_bias));
  }
  if (*tie_bias > static_cast<double>(std::numeric_limits<float>::max())) {
    throw UserError(fmt::format("--tie-bias: {:g} is beyond float; take 0 to {:g}", *tie_bias,
                                std::numeric_limits<float>::max()));
  }
  return collider.with_tie_bias(*tie_bias);
}

}  // namespace manifuzz
