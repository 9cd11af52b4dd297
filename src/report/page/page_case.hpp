#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/judged_case.hpp"
#include "report/picture/pictures.hpp"

namespace manifuzz {

/// A case on the page: what `show` shows, and what its file and the runs add.
struct PageCase {
  JudgedCase judged;       ///< its judgement is of these answers, where `is_judged`
  bool is_judged = false;  ///< false: a collider is missing, of which the file tells all there is
  std::vector<Manifold<double>> right;  ///< every right one, the one to show first
  std::string smallest;                 ///< of a worst witness: the file of what it was shrunk to
  std::optional<std::uint64_t> count;   ///< how often the runs met its bucket
  std::vector<std::string> commands;    ///< that show or repeat it
  std::optional<CaseMap> map;
};

/// A case as the page's script reads it, with what is drawn of it: everything in world directions
/// and lengths, seen from A's position; null where a number is not finite.
nlohmann::ordered_json page_case_json(const PageCase& page_case);

}  // namespace manifuzz
