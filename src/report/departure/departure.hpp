#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "judging/compare.hpp"

namespace manifuzz {

/// A step of the article at which one choice is replaced, so that all other steps give the answer.
struct Departure {
  std::string_view step;
  std::string words;          ///< what is replaced: "with B's edge 2 in place of edge 1"
  bool has_features = false;  ///< the points' features are the answer's too
};

/// What is known of how a wrong answer came about.
struct Departures {
  /// The first replacement of each step, in their order; where some give the features of the
  /// answer's points as well, only these.
  std::vector<Departure> found;
  std::string agreement;  ///< where none is found: how far the answer agrees, in sentences
};

/// The clips of which the right manifolds with points are, in the judge's order.
std::vector<const exact::Clip*> right_clips(const Admissible& right);

/// Where a wrong answer departs from the article's steps, found by repeating them with one choice
/// replaced at a time. None where the answer is right, or is of no collider or shapes that clip.
std::optional<Departures> departures_of(const PairCase& pair, const ColliderAnswer& given);

/// Where the answer departs, in sentences.
std::string departures_in_words(const Departures& departures);

}  // namespace manifuzz
