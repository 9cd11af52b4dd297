#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "campaign/plan.hpp"

namespace manifuzz {

/// The cases of what a hunt has found wrong until now, a line each, in the findings' folder while
/// it runs: whatever ends it, a hunt that begins `--from` that file has them again.
class Journal {
 public:
  /// In no folder nothing is written.
  Journal(const std::string& folder, const Plan& plan);
  /// Adds the first case of each bucket of somebody's mistakes that is new to it. A file that
  /// cannot be written is let be: saving says so at the end.
  void add(const Tally& tally);
  /// Takes the file away: what was found is saved by itself now.
  void end() const;

 private:
  const Plan& plan_;
  std::filesystem::path file_;
  std::set<std::size_t> known_;  ///< buckets by their index
};

}  // namespace manifuzz
