#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// An option that takes a whole number from `least` to `most`. CLI11's own reading takes -1 for
/// 2^64 - 1 and 010 for 8.
CLI::Option* add_whole_number(CLI::App& app, const std::string& name,
                              std::optional<std::uint64_t>& to, const std::string& description,
                              std::uint64_t least = 0,
                              std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// An option that takes a finite number, 0 or more.
CLI::Option* add_length(CLI::App& app, const std::string& name, std::optional<double>& to,
                        const std::string& description);

/// A check that an option's text is not blank: what is wrong, or nothing.
std::string not_blank(const std::string& text);

/// Options that several commands have: --seed, --first, --regime, --corpus, --no-save, --json.
void add_seed(CLI::App& app, std::optional<std::uint64_t>& seed);
void add_regimes(CLI::App& app, std::vector<std::string>& names);
void add_corpus(CLI::App& app, std::string& folder, const std::string& description);
void add_no_save(CLI::App& app, bool& no_save);
/// Adds --junit.
void add_junit(CLI::App& app, std::string& file);

void add_json(CLI::App& app, std::string& file, const std::string& what);

/// The seed that was given, or one that is drawn and printed on stderr first.
std::uint64_t seed_or_draw(const std::optional<std::uint64_t>& seed);

/// Throws UserError where the last of `cases` cases, dealt to the regimes by turns from index
/// `first` on, has an index beyond 64 bits.
void expect_indices(std::uint64_t first, std::uint64_t cases, std::size_t regimes);

}  // namespace manifuzz
