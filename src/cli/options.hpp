#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "corpus/corpus_folders.hpp"
#include "report/outputs.hpp"

namespace manifuzz {

/// What is wrong with a command line that could not be parsed, and what would be right: one line
/// that names the nearest command or option.
std::string complaint_about_usage(const CLI::App& app, const CLI::ParseError& error);

/// What every command takes, before its name or behind it: --quiet, --no-color.
void add_common_options(CLI::App& app);
/// Makes them hold, wherever they were given, and even where the rest could not be parsed.
void obey_common_options(const CLI::App& app);

/// Below a command's help: its example, indented, a command line each.
std::string help_on_example(std::string_view example);

/// An option that takes a whole number from `least` to `most`. CLI11's own reading takes -1 for
/// 2^64 - 1 and 010 for 8.
CLI::Option* add_whole_number(CLI::App& app, const std::string& name,
                              std::optional<std::uint64_t>& to, const std::string& description,
                              std::uint64_t least = 0,
                              std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// An option that takes a finite number, 0 or more.
CLI::Option* add_length(CLI::App& app, const std::string& name, std::optional<double>& to,
                        const std::string& description);

/// An option that takes a number above 0, up to 1.
CLI::Option* add_chance(CLI::App& app, const std::string& name, std::optional<double>& to,
                        const std::string& description);

/// A check that an option's text is not blank: what is wrong, or nothing.
std::string not_blank(const std::string& text);

/// An option that takes a text, or several, none of them blank; `type` stands for it in the help.
template <class To>
CLI::Option* add_text(CLI::App& app, const std::string& name, To& to, const std::string& type,
                      const std::string& description) {
  return app.add_option(name, to, description)->type_name(type)->check(not_blank);
}

/// Options that several commands have: --seed, --regime, --radius, --corpus, --no-save, --json.
void add_seed(CLI::App& app, std::optional<std::uint64_t>& seed);
void add_regimes(CLI::App& app, std::vector<std::string>& names);
void add_radius(CLI::App& app, std::optional<double>& radius);
/// Such a radius as a float. Throws UserError where it is too large for one.
float radius_of(double radius);
void add_corpus(CLI::App& app, CorpusFolders& folders, const std::string& description);
/// Adds --found.
void add_found(CLI::App& app, CorpusFolders& folders);
/// An option that takes a day, as 2027-01-31.
CLI::Option* add_day(CLI::App& app, const std::string& name, std::string& day,
                     const std::string& description);
/// Adds --today, which acceptances end by.
void add_today(CLI::App& app, std::string& day);
void add_no_save(CLI::App& app, CorpusFolders& folders);
/// Adds --junit.
void add_junit(CLI::App& app, std::string& file);

void add_json(CLI::App& app, std::string& file, const std::string& what);
/// Writes a table for people, or in its place the JSON where --json asks for it on the standard
/// output; and the JSON to the file that --json names otherwise.
void write_table(Outputs& outputs, const std::string& table, const std::string& json_file,
                 const std::string& json);

/// The seed that was given, or one that is drawn and printed on stderr first.
std::uint64_t seed_or_draw(const std::optional<std::uint64_t>& seed);

/// Throws UserError where the last of `cases` cases, dealt to the regimes by turns from index
/// `first` on, has an index beyond 64 bits.
void expect_indices(std::uint64_t first, std::uint64_t cases, std::size_t regimes);

/// How a case is named on the command line.
struct CaseArgument {
  std::string name;         ///< a file, "-" for stdin, or what is looked up in the corpus
  CorpusFolders folders{};  ///< the corpus that it is looked up in
};

/// Adds the argument of a command that reads many cases.
void add_file_of_cases(CLI::App& app, std::string& file);

/// Adds the argument, and --corpus.
void add_case_argument(CLI::App& app, CaseArgument& argument, const std::string& or_else = "");

/// The file that is meant; what was taken from the corpus is said on stderr. Throws UserError.
std::string case_file(const CaseArgument& argument);

}  // namespace manifuzz
