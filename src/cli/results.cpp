#include "cli/results.hpp"

#include <array>

#include <fmt/format.h>

#include "cases/file.hpp"
#include "cases/user_error.hpp"

namespace manifuzz {
namespace {

/// The largest result that is read.
constexpr std::size_t kLongestResult = std::size_t{1} << 28;

/// A key that the results of one command alone have, among those behind it in the list.
struct KindKey {
  std::string_view kind;
  const char* key;
};
constexpr std::array kKindKeys{KindKey{"fuzz", "buckets"}, KindKey{"replay", "failures"},
                               KindKey{"stress", "sweeps"}, KindKey{"scene", "exponents"},
                               KindKey{"bench", "rows"}};

/// The command that wrote it, or empty.
std::string_view kind_of(const nlohmann::ordered_json& json) {
  if (!json.is_object() || !json.contains("machine")) return {};
  for (const KindKey& known : kKindKeys) {
    if (json.contains(known.key)) return known.kind;
  }
  return {};
}

void read_run_file(const std::filesystem::path& path, RunFiles& files) {
  if (path.extension() == ".json") {
    InputFile file(path.string());
    auto json = nlohmann::ordered_json::parse(file.read_all(kLongestResult), nullptr, false);
    const std::string_view kind = kind_of(json);
    if (!kind.empty()) {
      files.results.push_back({path.string(), kind, std::move(json)});
      return;
    }
  }
  Corpus read = read_corpus({&path, 1});
  std::ranges::move(read.cases, std::back_inserter(files.corpus.cases));
  std::ranges::move(read.errors, std::back_inserter(files.corpus.errors));
}

}  // namespace

RunFiles read_run_files(std::span<const std::filesystem::path> paths) {
  RunFiles files;
  for (const auto& path : find_case_files(paths, files.corpus.errors)) {
    try {
      read_run_file(path, files);
    } catch (const UserError& error) {
      files.corpus.errors.emplace_back(error.what());
    }
  }
  return files;
}

}  // namespace manifuzz
