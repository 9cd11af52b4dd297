#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// A case's neighbourhood, drawn.
struct PageMap {
  std::string png;                 ///< the file's bytes
  std::vector<std::string> words;  ///< what it is a map of, and its severity
};

/// A case on the page: what `show` shows, and what its file and the runs add.
struct PageCase {
  JudgedCase judged;  ///< its judgement is of these answers, where `is_judged`
  bool is_judged =
      false;  ///< false: a collider that is not there, of which the file tells all there is
  std::vector<Manifold<double>> right;  ///< every right one, the one to show first
  std::string smallest;                 ///< of a worst witness: the file of what it was shrunk to
  std::optional<std::uint64_t> count;   ///< how often the runs met its bucket
  std::vector<std::string> commands;    ///< that show or repeat it
  std::optional<PageMap> map;
};

/// What a measuring command wrote: `fuzz`, `replay`, `bench`, `stress` or `scene`.
struct PageResult {
  std::string path;
  std::string kind;
  nlohmann::ordered_json json;
};

struct Page {
  std::string command;  ///< that makes it again
  std::vector<std::string> errors;
  std::vector<PageResult> results;
  std::vector<PageCase> cases;
};

/// The page: one HTML file that needs nothing else. Its data is a JSON object in the element
/// `data`, whose keys src/report/page/common/data.js reads.
std::string page_html(const Page& page);

}  // namespace manifuzz
