#include "cli/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/text.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

bool quiet = false;

}  // namespace

void write_error(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

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

void Output::write(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  buffer_ += text;
  if (buffer_.size() >= enough) flush();
}

void Output::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) throw OutputClosed();
    if (written < 0)
      throw UserError(fmt::format("stdout: cannot write it: {}", std::strerror(errno)));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void write_to_reader(std::string_view text) {
  try {
    Output out;
    out.write(text);
    out.flush();
  } catch (const OutputClosed&) {
  }
}

bool takes_stdout(std::initializer_list<DataFile> files) {
  bool is_taken = false;
  for (auto data = files.begin(); data != files.end(); ++data) {
    if (data->file.empty()) continue;
    is_taken = is_taken || data->file == "-";
    const auto taker = std::ranges::find_if(files.begin(), data, [&](const DataFile& other) {
      return !other.file.empty() && resolved(other.file) == resolved(data->file);
    });
    if (taker == data) continue;
    throw BadOutput(fmt::format("{}: {} writes to {} already; name another file", data->option,
                                taker->option, printable(data->file, 200)));
  }
  return is_taken;
}

void expect_outside(std::initializer_list<DataFile> outputs, const std::filesystem::path& folder) {
  for (const DataFile& output : outputs) {
    const std::filesystem::path file(output.file);
    const bool is_case = file.extension() == ".json" || file.extension() == ".jsonl";
    if (!is_case || !is_within(file, folder)) continue;
    throw BadOutput(fmt::format("{}: {} would be taken for a case of {}; name another",
                                output.option, printable(output.file, 200),
                                printable(folder.string(), 200)));
  }
}

void expect_apart(std::initializer_list<DataFile> outputs,
                  std::span<const std::filesystem::path> inputs) {
  for (const DataFile& output : outputs) {
    if (output.file.empty() || output.file == "-") continue;
    const auto is_output = [&](const std::filesystem::path& input) {
      std::error_code unknown;
      return std::filesystem::equivalent(input, output.file, unknown) && !unknown;
    };
    if (std::ranges::none_of(inputs, is_output)) continue;
    throw BadOutput(fmt::format("{}: {} is one of the files that are read; name another",
                                output.option, printable(output.file, 200)));
  }
}

void write_data(const std::string& file, std::string_view text) {
  file == "-" ? write_to_reader(text) : write_file(file, text);
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void Outputs::write(bool is_asked, const std::function<void()>& write_it) {
  if (!is_asked) return;
  try {
    write_it();
  } catch (const UserError& error) {
    if (std::ranges::find(errors_, error.what()) != errors_.end()) return;
    write_complaint(error.what());
    errors_.emplace_back(error.what());
  }
}

ProgressLine::ProgressLine() : is_shown_(!quiet && is_able_terminal(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  show("");
}

void ProgressLine::show(std::string_view text) const {
  if (is_shown_) write_error("\r" + std::string(text) + "\x1b[K");
}

}  // namespace manifuzz
