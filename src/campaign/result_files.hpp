#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/result.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {

/// What a measuring command wrote with --json.
struct ResultFile {
  std::string path;
  std::string_view kind;  ///< the command: fuzz, replay, bench, stress or scene
  nlohmann::ordered_json json;
  std::optional<CampaignResult> campaign{};  ///< the same, of fuzz
};

/// The result in a file. Throws UserError that begins with the file's name.
ResultFile read_result(const std::string& path);

/// What runs left behind: cases and results, told apart by what is in them.
struct RunFiles {
  Corpus corpus;  ///< its errors name what is neither, its files are all that were read
  std::vector<ResultFile> results;
};

/// Everything in these files and folders, sorted by path; "-" is the standard input. What is broken
/// gives an error line, the rest is read all the same.
RunFiles read_run_files(std::span<const std::filesystem::path> paths);

}  // namespace manifuzz
