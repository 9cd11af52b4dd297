#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cases/corpus.hpp"

namespace manifuzz {

/// What a measuring command wrote with --json.
struct Result {
  std::string path;
  std::string_view kind;  ///< the command: fuzz, replay, bench, stress or scene
  nlohmann::ordered_json json;
};

/// What runs left behind: cases and results, told apart by what is in them.
struct RunFiles {
  Corpus corpus;  ///< its errors name what is neither
  std::vector<Result> results;
};

/// Everything in these files and folders, sorted by path. What is broken gives an error line, the
/// rest is read all the same.
RunFiles read_run_files(std::span<const std::filesystem::path> paths);

}  // namespace manifuzz
