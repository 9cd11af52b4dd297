#include <csignal>
#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"

namespace manifuzz {
namespace {

constexpr int kBadUsage = 2;

int complain(std::string_view what) {
  fmt::print(stderr, "manifuzz: {}\n", what);
  return kBadUsage;
}

/// Help goes to stdout; what cannot be parsed gives one line on stderr.
int answer_parse_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto used = app.get_subcommands();
  if (error.get_exit_code() == 0) {
    const bool is_version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
    Output out;
    out.write(is_version ? error.what() + std::string("\n")
                         : (used.empty() ? &app : used[0])->help());
    out.flush();
    return 0;
  }
  const std::string what = printable(error.what(), 300);
  if (used.empty()) return complain(what + "; try manifuzz --help");
  return complain(fmt::format("{0}: {1}; try manifuzz {0} --help", used[0]->get_name(), what));
}

int run(int argc, char** argv) {
  CLI::App app{"Contact points by clipping, and the harness that proves them.", "manifuzz"};
  app.set_version_flag("--version", "manifuzz " MANIFUZZ_VERSION);
  app.require_subcommand(1);
  std::map<const CLI::App*, Run> runs;
  for (const Command& command : commands()) {
    CLI::App* const sub =
        app.add_subcommand(std::string(command.name), std::string(command.summary));
    sub->footer(fmt::format("Example:\n{}\n", command.example));
    runs[sub] = command.define(*sub);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer_parse_error(app, error);
  }
  return runs.at(app.get_subcommands().front())();
}

}  // namespace
}  // namespace manifuzz

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that left is noticed where output is written
  try {
    return manifuzz::run(argc, argv);
  } catch (const manifuzz::OutputClosed&) {
    return 0;
  } catch (const std::exception& error) {
    return manifuzz::complain(error.what());
  }
}
