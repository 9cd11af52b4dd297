#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cases/corpus.hpp"
#include "cli/fuzz_result.hpp"

namespace manifuzz {

/// What a measuring command wrote with --json.
struct Result {
  std::string path;
  std::string_view kind;  ///< the command: fuzz, replay, bench, stress or scene
  nlohmann::ordered_json json;
  std::optional<FuzzResult> fuzz{};  ///< the same, of fuzz
};

/// The result in a file. Throws UserError that begins with the file's name.
Result read_result(const std::string& path);

/// What runs left behind: cases and results, told apart by what is in them.
struct RunFiles {
  Corpus corpus;  ///< its errors name what is neither
  std::vector<Result> results;
  std::vector<std::filesystem::path> paths{};  ///< of all files, broken ones too
};

/// Everything in these files and folders, sorted by path. What is broken gives an error line, the
/// rest is read all the same.
RunFiles read_run_files(std::span<const std::filesystem::path> paths);

/// Throws UserError where `output`, of that option, is one of the files that were read: what was
/// there before is not lost.
void expect_no_input(std::string_view option, const std::string& output, const RunFiles& files);

}  // namespace manifuzz
