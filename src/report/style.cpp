#include "report/style.hpp"

#include <cstdlib>
#include <unistd.h>

#include <fmt/format.h>

namespace manifuzz {
namespace {

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

}  // namespace manifuzz
