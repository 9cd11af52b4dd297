#include "cli/results.hpp"

#include <algorithm>
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

/// What wrote it, or nullptr.
const KindKey* kind_of(const nlohmann::ordered_json& json) {
  if (!json.is_object() || !json.contains("machine")) return nullptr;
  const auto known =
      std::ranges::find_if(kKindKeys, [&](const KindKey& kind) { return json.contains(kind.key); });
  return known == kKindKeys.end() ? nullptr : &*known;
}

/// Whether a row of `fuzz` says which bucket it is of, how often that was met, and how again.
bool is_bucket(const nlohmann::ordered_json& row) {
  return row.is_object() && row.contains("bucket") && row["bucket"].is_string() &&
         row.contains("count") && row["count"].is_number_unsigned() && row.contains("command") &&
         row["command"].is_string();
}

bool is_whole(const nlohmann::ordered_json& json, const KindKey& kind) {
  const auto& rows = json.at(kind.key);
  if (!rows.is_array()) return false;
  if (kind.kind != "fuzz") {
    return std::ranges::all_of(rows, [](const auto& row) { return row.is_object(); });
  }
  const auto names = [&](const char* key) { return json.contains(key) && json[key].is_string(); };
  return names("subject") && names("oracle") && std::ranges::all_of(rows, is_bucket);
}

void read_run_file(const std::filesystem::path& path, RunFiles& files) {
  if (path.extension() == ".json") {
    InputFile file(path.string());
    auto json = nlohmann::ordered_json::parse(file.read_all(kLongestResult), nullptr, false);
    if (const KindKey* const known = kind_of(json)) {
      if (!is_whole(json, *known)) {
        throw UserError(
            fmt::format("{}: what {} --json writes is expected", file.name(), known->kind));
      }
      files.results.push_back({path.string(), known->kind, std::move(json)});
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
