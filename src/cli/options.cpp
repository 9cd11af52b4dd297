#include "cli/options.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "report/outputs.hpp"

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
                              std::uint64_t least, std::uint64_t most) {
  const auto read = [name, &to, least, most](const std::string& text) {
    to = parse_number<std::uint64_t>(text);
    if (!to || *to < least) {
      throw CLI::ValidationError(
          name, fmt::format("'{}' is not a whole number from {} to {}", printable(text), least,
                            std::numeric_limits<std::uint64_t>::max()));
    }
    if (*to > most) {
      throw UserError(fmt::format("{}: {} are too many; take {} to {}", name, *to, least, most));
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

void add_seed(CLI::App& app, std::optional<std::uint64_t>& seed) {
  add_whole_number(app, "--seed", seed, "what the cases depend on; drawn and printed if not given");
}

void add_regimes(CLI::App& app, std::vector<std::string>& names) {
  app.add_option("--regime", names,
                 "a regime to draw from, again for more; all by turns if not given")
      ->type_name("R")
      ->allow_extra_args(false);
}

void add_corpus(CLI::App& app, std::string& folder, const std::string& description) {
  app.add_option("--corpus", folder, description)->type_name("DIR")->capture_default_str();
}

void add_no_save(CLI::App& app, bool& no_save) {
  app.add_flag("--no-save", no_save, "shrink and save nothing");
}

void add_junit(CLI::App& app, std::string& file) {
  app.add_option("--junit", file, "a JUnit XML report, - for stdout")->type_name("FILE");
}

void add_json(CLI::App& app, std::string& file, const std::string& what) {
  app.add_option("--json", file, what + ", to a file or - for stdout")->type_name("FILE");
}

std::uint64_t seed_or_draw(const std::optional<std::uint64_t>& seed) {
  if (seed) return *seed;
  std::random_device device;
  const std::uint64_t drawn = (static_cast<std::uint64_t>(device()) << 32) | device();
  write_error(fmt::format("seed {}\n", drawn));
  return drawn;
}

void expect_indices(std::uint64_t first, std::uint64_t cases, std::size_t regimes) {
  if ((cases - 1) / regimes <= std::numeric_limits<std::uint64_t>::max() - first) return;
  throw UserError("--first: the last index passes 18446744073709551615; take fewer --cases");
}

}  // namespace manifuzz
