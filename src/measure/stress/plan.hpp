#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "measure/stress/stress.hpp"

namespace manifuzz {

/// Adds the sweeps and walks of these names to a plan, each once; all for no name. Throws UserError
/// that names `option` and what there is.
void choose_sweeps(const std::vector<std::string>& names, std::string_view option,
                   StressPlan& plan);

/// The ideal, then each of these; of each that takes a tie bias, a variant for the walks as well.
/// Throws UserError where two have one name, or where there are more than kSubjectsMax.
std::vector<StressSubject> with_variants(const std::vector<StressSubject>& chosen);

}  // namespace manifuzz
