#pragma once

#include <vector>

#include "campaign/hints/hint.hpp"
#include "campaign/plan.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// A hint needs so many wrong answers that are right with one mistake undone.
inline constexpr std::size_t kHintedMin = 20;
/// The share of the wrong answers of a kind that must be right then: ties, and what lies nearly
/// on a bound, may be read another way than the mistake was made.
inline constexpr double kHintedShare = 0.9;

/// The known mistakes of an adapter that make the wrong answers of a campaign. The first of each
/// kind are asked again, and judged with each mistake undone; of several the one counts that
/// explains most, and none that makes an answer wrong that was right. Nothing is asked where too
/// few are wrong.
std::vector<Hint> hints_of(const Tally& tally, const Plan& plan, Interruption& interruption);

}  // namespace manifuzz
