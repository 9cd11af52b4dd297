#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace manifuzz {

/// The cases of what a hunt has found wrong until now, a line each, in the findings' folder while
/// it runs: whatever ends it, they are there to be asked again.
class Journal {
 public:
  /// In NAME-SEED.jsonl of the folder; with no folder nothing is written.
  Journal(const std::string& folder, std::string_view name, std::uint64_t seed);
  /// Adds what `line` gives, a case, where nothing was added by that key yet. A file that cannot be
  /// written is let be: saving says so at the end.
  void add(std::size_t key, const std::function<std::string()>& line);
  /// Takes the file away: what was found is saved by itself now.
  void end() const;

 private:
  std::filesystem::path file_;
  std::set<std::size_t> known_;
};

}  // namespace manifuzz
