#include "cli/output.hpp"

#include <algorithm>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/user_error.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

bool quiet = false;

}  // namespace

void write_complaint(std::string_view what) {
  write_error(fmt::format("{} {}\n", bad_on_stderr("manifuzz:"), what));
}

void write_complaints(const std::vector<std::string>& all) {
  for (const std::string& what : all) write_complaint(what);
}

std::filesystem::path kept_path(const std::filesystem::path& path) {
  std::error_code unknown;
  const std::filesystem::path kept = std::filesystem::proximate(path, unknown);
  return unknown || kept.empty() ? path : kept;
}

void be_quiet() {
  quiet = true;
}

bool is_quiet() {
  return quiet;
}

bool leaves_out_tables(std::initializer_list<std::string_view> files) {
  const auto takes_data = [](std::string_view file) { return !file.empty() && file != "-"; };
  return quiet && std::ranges::any_of(files, takes_data);
}

void write_remark(std::string_view line) {
  if (!quiet) write_error(fmt::format("{}\n", line));
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void Outputs::write(bool is_asked, const std::function<void()>& write_it) {
  if (!is_asked) return;
  try {
    write_it();
  } catch (const UserError& error) {
    add_error(error.what());
  }
}

void Outputs::add_error(const std::string& what) {
  if (what.empty() || std::ranges::find(errors_, what) != errors_.end()) return;
  write_complaint(what);
  errors_.push_back(what);
}

ProgressLine::ProgressLine() : is_shown_(!quiet && is_able_terminal(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  show("");
}

void ProgressLine::show(std::string_view text) const {
  if (is_shown_) write_error("\r" + std::string(text) + "\x1b[K");
}

}  // namespace manifuzz
