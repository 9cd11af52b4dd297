#pragma once

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// The right manifold that a picture or a text shows: the subject's own choice where that is right,
/// else the first whose incident edge meets the slab, else the first; nullptr where the polygons
/// are apart.
const exact::Clip* candidate_to_show(const Admissible& right, const DeclaredAnswer& subject);

}  // namespace manifuzz
