#include "cli/options.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/output.hpp"

namespace manifuzz {
namespace {

/// The whole of `text` as a number, in the C locale.
template <class Number>
std::optional<Number> parse_number(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

}  // namespace

CLI::Option* add_whole_number(CLI::App& app, const std::string& name,
                              std::optional<std::uint64_t>& to, const std::string& description,
                              std::uint64_t least) {
  const auto read = [name, &to, least](const std::string& text) {
    to = parse_number<std::uint64_t>(text);
    if (!to || *to < least) {
      throw CLI::ValidationError(
          name, fmt::format("'{}' is not a whole number from {} to {}", printable(text), least,
                            std::numeric_limits<std::uint64_t>::max()));
    }
  };
  return app.add_option_function<std::string>(name, read, description)->type_name("N");
}

CLI::Option* add_length(CLI::App& app, const std::string& name, std::optional<double>& to,
                        const std::string& description) {
  const auto read = [name, &to](const std::string& text) {
    to = parse_number<double>(text);
    if (!to || !std::isfinite(*to) || *to < 0) {
      throw CLI::ValidationError(
          name, fmt::format("'{}' is not a finite number, 0 or more", printable(text)));
    }
  };
  return app.add_option_function<std::string>(name, read, description)->type_name("X");
}

std::string not_blank(const std::string& text) {
  return text.find_first_not_of(" \t\n") == std::string::npos ? "is empty" : "";
}

std::uint64_t seed_or_draw(const std::optional<std::uint64_t>& seed) {
  if (seed) return *seed;
  std::random_device device;
  const std::uint64_t drawn = (static_cast<std::uint64_t>(device()) << 32) | device();
  write_error(fmt::format("seed {}\n", drawn));
  return drawn;
}

}  // namespace manifuzz
