#pragma once

#include <nlohmann/json.hpp>

#include "report/page/page.hpp"

namespace manifuzz {

/// A case as the page's script reads it: everything in world directions and lengths, seen from A's
/// position; null where a number is not finite.
nlohmann::ordered_json page_case_json(const PageCase& page_case);

}  // namespace manifuzz
