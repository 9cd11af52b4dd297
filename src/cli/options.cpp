#include "cli/options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

bool is_option(const std::string& word) {
  return word.starts_with('-') && word != "-";
}

/// The first that looks like an option, which is the one to blame for the words behind it; else the
/// first, or nothing.
std::string one_to_blame(const std::vector<std::string>& words) {
  const auto option = std::ranges::find_if(words, is_option);
  if (option != words.end()) return option->substr(0, option->find('='));
  return words.empty() ? "" : words.front();
}

std::string no_such_option(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  return fmt::format("there is no option '{}'{}", printable(word), did_you_mean(word, known));
}

std::string no_such_command(const std::string& word) {
  std::vector<std::string_view> names;
  for (const Command& command : commands()) names.push_back(command.name);
  return no_such("command", word, names);
}

std::string with_help_of(std::string what, std::string_view command) {
  what += what.ends_with('?') ? " Try" : "; try";
  return fmt::format("{} manifuzz {}{}--help", what, command, command.empty() ? "" : " ");
}

std::string complaint_about_command(const CLI::App& app) {
  const std::string word = one_to_blame(app.remaining());
  if (word.empty()) return with_help_of("a command is missing", "");
  return with_help_of(is_option(word) ? no_such_option(app, word) : no_such_command(word), "");
}

}  // namespace

std::string complaint_about_usage(const CLI::App& app, const CLI::ParseError& error) {
  const auto used = app.get_subcommands();
  if (used.empty()) return complaint_about_command(app);
  const CLI::App& command = *used[0];
  const std::string word = one_to_blame(command.remaining());
  const bool is_word_too_many = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  // What an option is missing may be what a misspelt one has taken.
  const std::string what = is_option(word) ? no_such_option(command, word)
                           : is_word_too_many
                               ? fmt::format("unexpected argument '{}'", printable(word))
                               : printable(error.what(), 300);
  return fmt::format("{}: {}", command.get_name(), with_help_of(what, command.get_name()));
}

void add_common_options(CLI::App& app) {
  const std::string quiet =
      "show no progress and no remarks; print only errors, and results that no --json takes";
  const std::string plain =
      "print without colours; the environment variable NO_COLOR does that, too";
  app.add_flag("--quiet", quiet);
  app.add_flag("--no-color", plain);
}

void obey_common_options(const CLI::App& app) {
  const auto is_given = [&app](const char* name) {
    const auto commands_used = app.get_subcommands();
    return app.count(name) > 0 || std::ranges::any_of(commands_used, [name](const CLI::App* used) {
             return used->count(name) > 0;
           });
  };
  if (is_given("--quiet")) be_quiet();
  if (!is_given("--no-color")) allow_colours();
}

std::string help_on_example(std::string_view example) {
  std::string text = "Example:\n  ";
  for (const char c : example) {
    text += c;
    if (c == '\n') text += "  ";
  }
  return text + "\n";
}

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
      throw CLI::ValidationError(name, fmt::format("'{}' is not a whole number from {} to {}",
                                                   printable(text), least, most));
    }
    if (*to > most) {
      throw UserError(fmt::format("{}: {} is too large; use {} to {}", name, *to, least, most));
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

CLI::Option* add_chance(CLI::App& app, const std::string& name, std::optional<double>& to,
                        const std::string& description) {
  const auto read = [name, &to](const std::string& text) {
    to = parse_number<double>(text);
    if (to && *to > 0 && *to <= 1) return;
    throw CLI::ValidationError(
        name,
        fmt::format("'{}' is no chance; a number above 0, up to 1, is expected", printable(text)));
  };
  return app.add_option_function<std::string>(name, read, description)->type_name("P");
}

std::string not_blank(const std::string& text) {
  return text.find_first_not_of(" \t\n") == std::string::npos ? "is empty" : "";
}

void add_seed(CLI::App& app, std::optional<std::uint64_t>& seed) {
  add_whole_number(app, "--seed", seed, "random seed; chosen and printed if omitted");
}

void add_regimes(CLI::App& app, std::vector<std::string>& names) {
  app.add_option("--regime", names,
                 "regime (or motion, for sequences); repeatable; default: all in turn")
      ->type_name("R")
      ->allow_extra_args(false);
}

void add_radius(CLI::App& app, std::optional<double>& radius) {
  add_length(app, "--radius", radius, "radius of each polygon; default: the regime's own");
}

float radius_of(double radius) {
  constexpr float most = std::numeric_limits<float>::max() / 2;  // both together are a float still
  if (radius <= static_cast<double>(most)) return static_cast<float>(radius);
  throw UserError(fmt::format("--radius: {} is too large for a float; use 0 to {}", radius, most));
}

void add_corpus(CLI::App& app, CorpusFolders& folders, const std::string& description) {
  app.add_option("--corpus", folders.named, description)->type_name("DIR");
}

void add_found(CLI::App& app, CorpusFolders& folders) {
  app.add_option("--found", folders.findings,
                 "folder in which new cases are saved, whatever the corpus; known ones are read "
                 "from there too")
      ->type_name("DIR");
}

CLI::Option* add_day(CLI::App& app, const std::string& name, std::string& day,
                     const std::string& description) {
  return app.add_option(name, day, description)
      ->type_name("YYYY-MM-DD")
      ->check([](const std::string& text) {
        return is_day(text)
                   ? ""
                   : fmt::format("'{}' is not a date; a date such as 2027-01-31 is expected",
                                 printable(text));
      });
}

void add_today(CLI::App& app, std::string& day) {
  day = today();
  add_day(app, "--today", day,
          "date to use as today where acceptances end by date; meant for tests");
}

void add_no_save(CLI::App& app, CorpusFolders& folders) {
  app.add_flag("--no-save", folders.is_unsaved, "do not shrink or save findings");
}

void add_junit(CLI::App& app, std::string& file) {
  app.add_option("--junit", file, "write a JUnit XML report; - is stdout")->type_name("FILE");
}

void add_json(CLI::App& app, std::string& file, const std::string& what) {
  app.add_option("--json", file, "write " + what + " as JSON; - is stdout")->type_name("FILE");
}

void write_table(Outputs& outputs, const std::string& table, const std::string& json_file,
                 const std::string& json) {
  outputs.write(true, [&] { write_to_reader(json_file == "-" ? json : table); });
  outputs.write(!json_file.empty() && json_file != "-", [&] { write_file(json_file, json); });
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
  throw UserError("--first: the last index would exceed 18446744073709551615; use fewer --cases");
}

void add_file_of_cases(CLI::App& app, std::string& file) {
  add_text(app, "file", file, "FILE",
           "file of cases: one if it ends in .json, else one a line; default: - for stdin");
}

void add_case_argument(CLI::App& app, CaseArgument& argument, const std::string& or_else) {
  add_text(app, "file", argument.name, "FILE",
           "a case's file, or - for stdin; or a bucket, or the beginning of a file name, in the "
           "corpus" +
               or_else)
      ->required();
  add_corpus(app, argument.folders,
             "folder in which a bucket or a beginning of a name is looked up; default: corpus and "
             "the folder of findings");
}

std::string case_file(const CaseArgument& argument) {
  const FoundCase found = find_case(argument.name, argument.folders.all());
  if (!found.remark.empty()) write_remark(found.remark);
  return found.file;
}

}  // namespace manifuzz
