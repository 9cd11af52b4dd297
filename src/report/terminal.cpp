#include "report/terminal.hpp"

#include <cstdlib>
#include <unistd.h>

#include <fmt/format.h>

#include "base/streams.hpp"

namespace manifuzz {
namespace {

bool quiet = false;

/// Terminals' own names for colours, so that every theme is legible.
constexpr std::string_view kRed = "\x1b[31m";
constexpr std::string_view kGreen = "\x1b[32m";
constexpr std::string_view kYellow = "\x1b[33m";
constexpr std::string_view kPlain = "\x1b[0m";

bool stdout_is_coloured = false;
bool stderr_is_coloured = false;

std::string_view in_environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

std::string coloured(bool is_coloured, std::string_view colour, std::string_view word) {
  return is_coloured ? fmt::format("{}{}{}", colour, word, kPlain) : std::string(word);
}

}  // namespace

bool is_able_terminal(int stream) {
  const std::string_view name = in_environment("TERM");
  return isatty(stream) == 1 && !name.empty() && name != "dumb";
}

void allow_colours() {
  if (!in_environment("NO_COLOR").empty()) return;
  stdout_is_coloured = is_able_terminal(STDOUT_FILENO);
  stderr_is_coloured = is_able_terminal(STDERR_FILENO);
}

std::string good(std::string_view word) {
  return coloured(stdout_is_coloured, kGreen, word);
}

std::string bad(std::string_view word) {
  return coloured(stdout_is_coloured, kRed, word);
}

std::string fresh(std::string_view word) {
  return coloured(stdout_is_coloured, kYellow, word);
}

std::string bad_on_stderr(std::string_view word) {
  return coloured(stderr_is_coloured, kRed, word);
}

void write_complaint(std::string_view what) {
  write_error(fmt::format("{} {}\n", bad_on_stderr("manifuzz:"), what));
}

void write_complaints(const std::vector<std::string>& all) {
  for (const std::string& what : all) write_complaint(what);
}

void be_quiet() {
  quiet = true;
}

bool is_quiet() {
  return quiet;
}

void write_remark(std::string_view line) {
  if (!quiet) write_error(fmt::format("{}\n", line));
}

ProgressLine::ProgressLine() : is_shown_(!quiet && is_able_terminal(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  show("");
}

void ProgressLine::show(std::string_view text) const {
  if (is_shown_) write_error("\r" + std::string(text) + "\x1b[K");
}

}  // namespace manifuzz
