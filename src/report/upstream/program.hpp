#pragma once

#include <string>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// What a snippet's template makes of one pair, and says of how its engine answers.
struct Program {
  std::string text;                          ///< the program
  std::string function;                      ///< that it asks; empty where it does not say
  std::string language;                      ///< of the fence around it
  std::string point = "point $p, depth $d";  ///< how the engine gives a point, see point_in_words
  std::string none = "no contact";           ///< how it says that there is none
  std::string figures{};                     ///< how its figures are read; empty: as they stand
  bool has_normal = true;                    ///< whether it gives a normal at all
  bool is_b_first = false;                   ///< it is asked with B before A
};

/// The template filled in: its conditional lines, its directives, its numbers.
Program program_for(const std::string& snippet, const PairCase& pair);

/// A snippet's template with the pair's numbers in it, and the lines that stand for its shapes;
/// src/external/README.md says how it is written.
std::string filled_in(const std::string& snippet, const PairCase& pair);

}  // namespace manifuzz
