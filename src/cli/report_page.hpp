#pragma once

#include <string>

#include "campaign/result_files.hpp"
#include "cli/page_cases.hpp"

namespace manifuzz {

/// Of so many buckets the neighbourhood is drawn where nobody says how many: a few seconds.
inline constexpr std::size_t kMapsUsual = 12;

/// The page of these files; `command` makes it again, or is empty. Throws UserError when
/// interrupted.
std::string report_page(const RunFiles& files, NamedColliders& colliders, std::size_t maps_max,
                        const std::string& command);

}  // namespace manifuzz
