#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace manifuzz {

/// The cases of what a hunt has found wrong until now, a line each, in a file of its own in the
/// findings' folder while it runs: whatever ends it, they are there to be asked again.
class Journal {
 public:
  /// In NAME-SEED.jsonl of the folder, or NAME-SEED-2.jsonl and so on where that is there already;
  /// with no folder nothing is written.
  Journal(std::string folder, std::string_view name, std::uint64_t seed);
  /// Adds what `line` gives, a case, where nothing was added by that key yet. A file that cannot be
  /// written is let be: saving says so at the end.
  void add(std::size_t key, const std::function<std::string()>& line);
  /// Takes the file away: all that was found is saved by itself now.
  void end() const;

 private:
  std::string folder_;
  std::string name_;
  std::filesystem::path file_;  ///< none before the first line
  std::set<std::size_t> known_;
};

}  // namespace manifuzz
