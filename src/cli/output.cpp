#include "cli/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/file.hpp"
#include "cases/user_error.hpp"
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
  std::string_view taker;
  for (const DataFile& data : files) {
    if (data.file != "-") continue;
    if (!taker.empty()) {
      throw UserError(fmt::format("{}: {} writes to the standard output already; name a file",
                                  data.option, taker));
    }
    taker = data.option;
  }
  return !taker.empty();
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
    write_complaint(error.what());
    are_written_ = false;
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
