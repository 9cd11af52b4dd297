#pragma once

#include <span>
#include <string>

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// The case as a picture of characters, for terminals, logs and code blocks: outlines, overlap,
/// right contact points and those of the answers (the subject, then the oracle if there is one), a
/// closer view where these are too near each other, a legend. At most 76 characters wide but for
/// the legend, and 46 lines with it; UTF-8.
std::string text_picture(const PairCase& pair, std::span<const DeclaredAnswer> answers);

/// Of a case between two colliders.
std::string text_picture(const JudgedCase& judged);

}  // namespace manifuzz
