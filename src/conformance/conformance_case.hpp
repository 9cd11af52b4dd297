#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A case of the conformance suite as one line, without the line's end: the pair, its name, and
/// every answer that is right for a collider that clips, in either scalar, as
/// corpus/conformance/README.md states it. None where the suite cannot say it: in float the case is
/// ill posed, or the second point of a round pair depends on which right normal an answer has.
std::optional<std::string> conformance_line(std::string_view name, const PairCase& pair);

}  // namespace manifuzz
