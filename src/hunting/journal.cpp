#include "hunting/journal.hpp"

#include <cerrno>
#include <fstream>

#include <fmt/format.h>

#include "base/new_file.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

/// Makes a file that was not there: NAME.jsonl, or NAME-2.jsonl and so on where a hunt that was
/// killed, or that runs now, has left others. Nothing where none can be made.
fs::path make_own_file(const fs::path& folder, const std::string& name) {
  constexpr int kMost = 1000;
  for (int i = 1; i <= kMost; ++i) {
    const fs::path file = folder / (i == 1 ? name + ".jsonl" : fmt::format("{}-{}.jsonl", name, i));
    if (make_new_file(file)) return file;
    if (errno != EEXIST) break;
  }
  return {};
}

/// Appends the line whole, or nothing: half a line would be no case.
void append_line(const fs::path& file, const std::string& line) {
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(file, unknown);
  if (unknown) return;
  std::ofstream out(file, std::ios::app);
  out << line << '\n';
  out.close();
  if (!out) fs::resize_file(file, size, unknown);
}

}  // namespace

Journal::Journal(std::string folder, std::string_view name, std::uint64_t seed)
    : folder_(std::move(folder)), name_(fmt::format("{}-{}", name, seed)) {}

void Journal::add(std::string_view key, double value, const std::function<std::string()>& line) {
  if (folder_.empty()) return;
  const bool is_first_of_all = greatest_.empty();
  const auto [known, is_new] = greatest_.emplace(std::string(key), value);
  if (!is_new && value <= known->second) return;
  known->second = value;
  if (is_first_of_all) {
    std::error_code ignored;
    has_made_folder_ = fs::create_directories(folder_, ignored);
    file_ = make_own_file(folder_, name_);
  }
  if (!file_.empty()) append_line(file_, line());
}

void Journal::end() const {
  std::error_code ignored;
  if (!file_.empty()) fs::remove(file_, ignored);
  if (has_made_folder_) fs::remove(folder_, ignored);
}

}  // namespace manifuzz
