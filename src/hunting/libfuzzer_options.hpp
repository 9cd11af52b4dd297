#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace manifuzz {

/// What of a fuzzer's command line is ours; the rest is libFuzzer's.
struct LibFuzzerOptions {
  std::vector<std::filesystem::path> from;        ///< JSON cases for its corpus
  std::optional<std::filesystem::path> to_json;   ///< where its corpus goes as JSON
  std::optional<std::filesystem::path> findings;  ///< where wrong answers go; else one ends the run
  bool stops = false;                             ///< at the first wrong answer, all the same
  std::vector<std::string> rest;                  ///< libFuzzer's, the program's name first
  std::vector<std::filesystem::path> inputs;      ///< among the rest: its files and folders
};

/// Takes apart a command line, `arguments[0]` the program. Throws UserError.
LibFuzzerOptions libfuzzer_options(const std::vector<std::string>& arguments);

}  // namespace manifuzz
