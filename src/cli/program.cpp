#include "cli/program.hpp"

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/pages/pages.hpp"
#include "engines/colliders.hpp"
#include "process/child.hpp"
#include "process/signals.hpp"
#include "process/standard_streams.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr int kBadUsage = 2;

/// What a command may still ask anybody, once a signal came; it ends within 2 s.
constexpr double kSecondsAfterSignal = 1.2;

/// What stands behind --help, where it is a page.
std::optional<std::string_view> asked_page(std::span<char* const> arguments) {
  if (arguments.size() != 3 || arguments[1] != std::string_view("--help")) return std::nullopt;
  return is_page(arguments[2]) ? std::optional<std::string_view>(arguments[2]) : std::nullopt;
}

/// What stands behind --help and is neither a page nor a command or an option.
std::optional<std::string_view> missing_page(std::span<char* const> arguments) {
  if (arguments.size() != 3 || arguments[1] != std::string_view("--help")) return std::nullopt;
  const std::string_view name = arguments[2];
  const bool is_known = is_page(name) || name.starts_with('-') ||
                        std::ranges::find(commands(), name, &Command::name) != commands().end();
  return is_known ? std::nullopt : std::optional(name);
}

/// The command that the arguments name, where it is none of this program's: the first word, since
/// no option before it takes one. Pages of all options need all commands.
const Command* command_elsewhere(std::span<char* const> arguments) {
  if (const auto name = asked_page(arguments)) {
    const auto missing = std::ranges::find(commands(), nullptr, &Command::define);
    return has_all_options(*name) && missing != commands().end() ? &*missing : nullptr;
  }
  const auto is_word = [](std::string_view argument) { return !argument.starts_with('-'); };
  const auto word = std::ranges::find_if(arguments.subspan(1), is_word);
  if (word == arguments.end()) return nullptr;
  const auto named = std::ranges::find(commands(), std::string_view(*word), &Command::name);
  return named == commands().end() || named->define != nullptr ? nullptr : &*named;
}

/// The program that has it.
std::filesystem::path measuring_program() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown)
      .replace_filename(kMeasuringProgram);
}

int complain(std::string_view what) {
  write_complaint(what);
  return kBadUsage;
}

/// Help goes to stdout; what cannot be parsed gives one line on stderr.
int answer_parse_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    const bool is_version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
    Output out;
    out.write(is_version ? error.what() + std::string("\n") : app.help());
    out.flush();
    return 0;
  }
  return complain(complaint_about_usage(app, error));
}

/// A call without arguments is answered in full; but a script that has lost its command must not
/// pass, so its status is that of bad usage.
int answer_bare_call(const char* program) {
  write_to_reader(next_steps(program, "corpus", [](const std::string& name) {
    const ColliderEntry* const entry = find_entry(name);
    return entry != nullptr && (entry->is_ours || name == usual_oracle_name());
  }));
  return complain("a command is missing; some to begin with are listed above");
}

int run(int argc, char** argv) {
  CLI::App app{
      "A differential fuzzer for 2D colliders, with an exact judge of their contact manifolds.",
      "manifuzz"};
  app.footer(
      "manifuzz --help words explains the terms that commands use; manifuzz --help man prints the "
      "page for man, and --help bash, zsh or fish what shells complete by.");
  app.set_version_flag("--version", "manifuzz " MANIFUZZ_VERSION);
  app.require_subcommand(1);
  add_common_options(app);
  std::map<const CLI::App*, Run> runs;
  for (const Command& command : commands()) {
    CLI::App* const sub =
        app.add_subcommand(std::string(command.name), std::string(command.summary));
    sub->footer(help_on_example(command.example));
    if (command.define != nullptr) runs[sub] = command.define(*sub);
    add_common_options(*sub);
  }
  if (argc < 2) return answer_bare_call(argc > 0 ? argv[0] : "manifuzz");
  if (const Command* const command = command_elsewhere({argv, argv + argc})) {
    throw UserError(fmt::format("{}: {} is not there; scripts/build builds it", command->name,
                                printable(kept_path(measuring_program()).string(), 200)));
  }
  if (const auto name = asked_page({argv, argv + argc})) {
    write_output(page(app, *name));
    return 0;
  }
  if (const auto name = missing_page({argv, argv + argc})) {
    throw UserError(fmt::format("--help: there is no page {}; words, man, bash, zsh and fish are",
                                printable(*name, 100)));
  }
  try {
    app.parse(argc, argv);
    obey_common_options(app);
  } catch (const CLI::ParseError& error) {
    obey_common_options(app);
    return answer_parse_error(app, error);
  }
  return runs.at(app.get_subcommands().front())();
}

/// Whatever the command throws becomes a complaint and a status.
int run_to_the_end(int argc, char** argv) {
  try {
    return guarding_exit(
        [&] { return run(argc, argv); },
        [] { return complain("a library called exit in this process; omit --in-process"); });
  } catch (const OutputClosed&) {
    return 0;
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace

int run_program(int argc, char** argv) {
  if (argc > 1 && command_elsewhere({argv, argv + argc})) {
    ::execv(measuring_program().c_str(), argv);  // returns where it cannot be started
  }
  fill_in_standard_streams();
  const Descendants descendants;
  stop_children_on_signals();
  leave_after_signal(kSecondsAfterSignal);
  std::signal(SIGPIPE, SIG_IGN);  // a reader that left is noticed where output is written
  return status_after_signals(run_to_the_end(argc, argv));
}

}  // namespace manifuzz
