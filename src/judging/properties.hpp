#pragma once

#include <span>
#include <string>
#include <string_view>

#include "collider/collider.hpp"

namespace manifuzz {

/// What became of a property on one case.
struct Outcome {
  enum class Kind {
    holds,
    not_applicable,  ///< a tie, no contact, or the collider does not offer what it takes
    known,           ///< it fails, and the ledger explains an answer that it asked for
    fails,
  };
  Kind kind = Kind::holds;
  std::string why;       ///< of a failure, for people
  double magnitude = 0;  ///< of a failure, as a share of the size
};

class AskedCollider;

/// A sentence that must be true of every collider, whatever an oracle says.
struct Property {
  std::string_view name;
  std::string_view sentence;
  Outcome (*holds)(AskedCollider& ask, const PairCase& pair);
};

/// Every property: property_list.hpp has them.
std::span<const Property> properties();

/// The property of that name, or nullptr.
const Property* find_property(std::string_view name);

/// The property on one case of one collider, through the ledger.
Outcome check(const Property& property, const Collider& collider, const PairCase& pair);

}  // namespace manifuzz
