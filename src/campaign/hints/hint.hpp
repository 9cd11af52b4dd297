#pragma once

#include <cstdint>
#include <string>

namespace manifuzz {

/// That the wrong answers of a campaign are what a known mistake of an adapter makes.
struct Hint {
  std::string mistake;                  ///< its name
  std::uint64_t of_wrong = 0;           ///< of so many wrong answers that were asked again
  std::uint64_t right_when_undone = 0;  ///< so many are right once the mistake is undone
  std::string text;                     ///< the same in words, with what to do

  friend bool operator==(const Hint&, const Hint&) = default;
};

}  // namespace manifuzz
