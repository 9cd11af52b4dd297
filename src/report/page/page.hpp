#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/judged_case.hpp"
#include "campaign/result_files.hpp"
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

struct Page {
  std::string command;  ///< that makes it again
  std::vector<std::string> errors;
  std::vector<ResultFile> results;
  std::vector<PageCase> cases;
};

/// The page: one HTML file that needs nothing else. Its data is a JSON object in the element
/// `data`, whose keys src/report/page/common/data.js reads.
std::string page_html(const Page& page);

}  // namespace manifuzz
