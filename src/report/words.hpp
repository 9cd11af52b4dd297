#pragma once

#include <string>

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// Four significant digits or a few more, for labels.
std::string brief(double value);

/// "2 points", "1 point".
std::string counted(int count, std::string_view noun);

/// "A face 2", the face by its number and its owner's name.
std::string face_name(Side side, int face);

/// "overlap 0.31", or what else lies between the polygons: the depth of rounded ones, a gap.
std::string truth_in_words(const PairCase& pair);

/// What a collider answered: "no contact", "2 points, depths 0.3 and 0.25", "crashed".
std::string answer_in_words(const DeclaredAnswer& asked);

/// The verdict as a sentence: "oracle wrong (known): box2d reports no contact, true overlap 0.31".
std::string verdict_sentence(const JudgedCase& judged);

}  // namespace manifuzz
