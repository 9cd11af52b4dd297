#include "hunting/journal.hpp"

#include <fstream>

#include <fmt/format.h>

namespace manifuzz {

Journal::Journal(const std::string& folder, std::string_view name, std::uint64_t seed) {
  if (!folder.empty())
    file_ = std::filesystem::path(folder) / fmt::format("{}-{}.jsonl", name, seed);
}

void Journal::add(std::size_t key, const std::function<std::string()>& line) {
  if (file_.empty() || !known_.insert(key).second) return;
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);
  std::ofstream(file_, std::ios::app) << line() << '\n' << std::flush;
}

void Journal::end() const {
  std::error_code ignored;
  if (!known_.empty()) std::filesystem::remove(file_, ignored);
}

}  // namespace manifuzz
