#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace manifuzz {

/// What a hunt has found until now, wrong answers and the worst of each measure, a case a line, in
/// a file of its own in the findings' folder while it runs: whatever ends it, they are there to be
/// asked again.
class Journal {
 public:
  /// In NAME-SEED.jsonl of the folder, or NAME-SEED-2.jsonl and so on where that is there already;
  /// with no folder nothing is written.
  Journal(std::string folder, std::string_view name, std::uint64_t seed);
  /// Adds what `line` gives, a case of that value, where nothing as great was added by that key. A
  /// file that cannot be written is let be: saving says so at the end.
  void add(std::string_view key, double value, const std::function<std::string()>& line);
  /// Takes the file away, and the folder where that was made for it and is empty: all that was
  /// found is saved by itself now.
  void end() const;

 private:
  std::string folder_;
  std::string name_;
  std::filesystem::path file_;  ///< none before the first line
  bool has_made_folder_ = false;
  std::map<std::string, double> greatest_;
};

}  // namespace manifuzz
