#pragma once

#include <functional>
#include <string>
#include <vector>

#include "campaign/property_run.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// A property that was run over a collider.
struct CheckedProperty {
  const Property* property = nullptr;
  PropertyResult result;
  double seconds = 0;
  std::string saved{};        ///< the file its failing case was written to, or empty
  std::string why_unsaved{};  ///< why it could not be

  bool holds() const { return result.passed; }
  /// Whether there was no time for a single case.
  bool is_left_out() const { return result.passed && result.cases == 0; }
};

/// Every one of these properties, until somebody asks to stop or, each with its share of what time
/// is left, until the deadline; failing cases go to the folder `save_to`, unless it is empty.
/// `on_checked` runs after each.
std::vector<CheckedProperty> check_properties(
    const std::vector<const Property*>& chosen, const Collider& subject, const PropertyPlan& plan,
    const Deadline& deadline, const std::string& save_to,
    const std::function<void(const CheckedProperty&)>& on_checked);

}  // namespace manifuzz
