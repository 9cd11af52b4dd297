#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/starting/first_corpus.hpp"
#include "cli/starting/staging.hpp"
#include "cli/starting/starters.hpp"
#include "cli/starting/texts.hpp"
#include "cli/starting/workflow.hpp"
#include "process/child.hpp"
#include "process/interruption.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOracle = "clip64";
constexpr const char* kSubjects = "subjects.json";
constexpr const char* kWorkflowFile = ".github/workflows/manifuzz.yml";
constexpr const char* kCorpus = "corpus";
constexpr const char* kHeader = "manifuzz_collider.h";
/// Enough for somebody's collider: what CI meets later is of a kind that was met.
constexpr std::uint64_t kCasesOfOwn = 1'000'000;
/// Enough for a collider that is known to be right.
constexpr std::uint64_t kCasesOfStarter = 20'000;

struct InitArguments {
  std::string folder = ".";
  ColliderChoice subject{"subject", "", ""};
  std::optional<std::uint64_t> cases;
  std::string clone_from;
};

/// The collider that is asked, and what the workflow must do to have it.
struct Asked {
  ColliderChoice staged{};  ///< while its files are not at their places
  ColliderChoice placed{};
  std::string packages{};
  std::string build{};
  std::uint64_t cases = kCasesOfOwn;
  std::string file{};  ///< to be edited; empty: somebody's own
};

/// A folder that is being begun.
class Beginning {
 public:
  explicit Beginning(const InitArguments& options) : options_(options), staging_(options.folder) {}
  void run();

 private:
  bool is_there(const std::string& name) const;
  void write(const std::string& name, std::string_view text, const std::string& what);
  void keep(const std::string& name, const std::string& why);
  std::string place_of(const std::string& name) const;
  Asked asked();
  Asked begun(const Starter& starter);
  void make_library(const Starter& starter);
  void write_subjects(const Asked& asked, const std::string& name);
  void write_workflow(const Asked& asked);
  void write_corpus(const Asked& asked, const Collider& subject);
  void tell(const Asked& asked) const;

  const InitArguments& options_;
  Staging staging_;
  std::vector<std::string> written_;  ///< in the order in which they are placed
  std::vector<std::string> to_commit_;
  std::vector<std::string> lines_;
};

bool Beginning::is_there(const std::string& name) const {
  std::error_code unknown;
  return fs::exists(fs::symlink_status(name, unknown));
}

void Beginning::write(const std::string& name, std::string_view text, const std::string& what) {
  if (is_there(name)) return keep(name, "it is there");
  write_file(staging_.at(name), text);
  written_.push_back(name);
  to_commit_.push_back(name);
  lines_.push_back(fmt::format("wrote {}: {}", name, what));
}

void Beginning::keep(const std::string& name, const std::string& why) {
  lines_.push_back(fmt::format("kept {}: {}", name, why));
}

/// Where it is now.
std::string Beginning::place_of(const std::string& name) const {
  return is_there(name) ? "./" + name : staging_.at(name).string();
}

void Beginning::make_library(const Starter& starter) {
  const std::string library(starter.library);
  if (is_there(library)) return keep(library, "it is there");
  const std::string headers = fs::path(place_of(kHeader)).parent_path().string();
  const std::string command =
      making(place_of(std::string(starter.file)), staging_.at(library).string(), headers);
  const bool is_made = wait_for(spawn([&] {
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    throw UserError("there is no /bin/sh");
  }));
  if (!is_made) throw UserError("init: cannot make a shared library: this failed: " + command);
  written_.push_back(library);
  lines_.push_back(fmt::format("wrote {}: {} as a shared library; it need not be committed",
                               library, starter.file));
}

Asked Beginning::begun(const Starter& starter) {
  const std::string file(starter.file);
  const bool is_own = is_there(file);
  write(file, *starter.text, fmt::format("a collider in {}, to be edited", starter.language));
  Asked asked;
  asked.packages = starter.packages;
  asked.cases = is_own ? kCasesOfOwn : kCasesOfStarter;
  asked.file = file;
  if (!starter.library.empty()) {
    write(kHeader, kColliderHeader, "what that includes");
    make_library(starter);
    const std::string library(starter.library);
    asked.staged = {"subject", place_of(library), ""};
    asked.placed = {"subject", "./" + library, ""};
    asked.build = making(file, library, ".");
    return asked;
  }
  asked.staged = {"subject", "", fmt::format("{} {}", starter.program, place_of(file))};
  asked.placed = {"subject", "", fmt::format("{} {}", starter.program, file)};
  return asked;
}

/// The collider that was named, else the one of subjects.json, else one to begin with.
Asked Beginning::asked() {
  ColliderChoice choice = options_.subject;
  if (!choice.is_given() && is_there(kSubjects)) {
    const NamedSubjects named = read_subjects({kSubjects, {}});
    if (named.size() != 1) {
      throw UserError(
          fmt::format("{}: names {}; say which one by --subject-command COMMAND or --subject "
                      "./LIBRARY.so",
                      kSubjects, counted(named.size(), "collider")));
    }
    const NamedSubject& only = named.begin()->second;
    choice = {"subject", only.library, only.command};
  }
  if (!choice.is_given()) return begun(starter_for("."));
  return {choice, choice, packages_for(choice.command), ""};
}

void Beginning::write_subjects(const Asked& asked, const std::string& name) {
  const ColliderChoice& placed = asked.placed;
  const bool is_program = !placed.command.empty();
  nlohmann::ordered_json json;
  json[name][is_program ? "command" : "library"] = is_program ? placed.command : placed.name;
  if (is_there(kSubjects)) {
    const NamedSubjects named = read_subjects({kSubjects, {}});
    const bool is_known = std::ranges::any_of(named, [&](const auto& one) {
      return one.second.library == placed.name && one.second.command == placed.command;
    });
    if (!is_known) return keep(kSubjects, "it is there; add " + json.dump());
  }
  write(kSubjects, json_text(json), fmt::format("how to ask {}", printable(name)));
}

void Beginning::write_workflow(const Asked& asked) {
  CloneOf manifuzz = clone_of_this_program();
  if (!options_.clone_from.empty()) manifuzz.url = options_.clone_from;
  const bool is_new = !is_there(kWorkflowFile);
  write(kWorkflowFile,
        workflow_text({asked.placed, kOracle, manifuzz, asked.packages, asked.build}),
        fmt::format("builds manifuzz{}, and asks the collider",
                    manifuzz.commit.empty() ? "" : " at this commit"));
  if (!is_new) return;
  if (manifuzz.url.empty()) {
    lines_.emplace_back(
        "  it clones what the variable MANIFUZZ_URL of your repository's settings names; or give "
        "--clone-from URL");
  }
  if (asked.build.empty() && asked.packages.empty()) {
    lines_.emplace_back("  what your collider needs to be built and run is to be added there");
  }
}

void Beginning::write_corpus(const Asked& asked, const Collider& subject) {
  if (is_there(kCorpus)) return keep(kCorpus, "it is there; fuzz and accept add to it");
  Interruption all(kUntilSignal);
  const Collider oracle = find_collider({"oracle", kOracle, ""}, {});
  const FirstCorpus first = write_first_corpus(
      staging_.at(kCorpus), {subject, oracle, options_.cases.value_or(asked.cases)}, all);
  written_.emplace_back(kCorpus);
  to_commit_.emplace_back(kCorpus);
  lines_.push_back(fmt::format("wrote {}: {}, {} accepted", kCorpus, counted(first.seeds, "case"),
                               counted(first.accepted, "finding")));
  lines_.push_back(fmt::format("  of {} cases, {}", options_.cases.value_or(asked.cases),
                               printable(first.verdicts, 200)));
  for (const std::string& hint : first.hints) {
    lines_.push_back("  hint: " + hint + "; mend that first, and begin again");
  }
}

void Beginning::tell(const Asked& asked) const {
  std::string text;
  for (const std::string& line : lines_) text += line + '\n';
  const std::string begin = this_program();
  text += options_.folder == "." ? "next:\n"
                                 : fmt::format("next, in {}:\n", printable_path(options_.folder));
  text += fmt::format("  {} smoke {} --oracle {} --corpus {}    # what CI runs\n", begin,
                      options_again(asked.placed, {}), kOracle, kCorpus);
  if (to_commit_.empty()) {
    text += fmt::format("  {} accept --list --corpus {}\n", begin, kCorpus);
  } else {
    text += "  git add";
    for (const std::string& name : to_commit_) text += ' ' + name;
    text += " && git commit -m 'Run manifuzz in CI'\n";
  }
  if (!asked.file.empty()) {
    text += fmt::format("once {} asks your engine, remove {}{} and run init again\n", asked.file,
                        kCorpus, asked.build.empty() ? "" : ", make the library again");
  }
  write_to_reader(text);
}

void Beginning::run() {
  if (is_there(kCorpus) && !fs::is_directory(kCorpus)) {
    throw UserError(fmt::format("{}: is no folder, and cases are to go there; move it", kCorpus));
  }
  const Asked asked = this->asked();
  const Collider subject = find_collider(asked.staged, {});
  write_subjects(asked, subject.declaration.name);
  write_workflow(asked);
  write_corpus(asked, subject);
  staging_.place(written_);
  if (!is_quiet()) tell(asked);
}

int init(const InitArguments& options) {
  const std::string& library = options.subject.name;
  if (!library.empty() && library.find('/') == std::string::npos) {
    throw UserError(
        fmt::format("--subject: '{}' is no path of a shared library; ./LIBRARY.so is "
                    "expected, from the folder that is begun",
                    printable(library)));
  }
  Beginning(options).run();
  return 0;
}

void add_init_arguments(CLI::App& app, InitArguments& options) {
  add_text(app, "folder", options.folder, "DIR",
           "folder of your collider; default: the current one");
  CLI::Option* const library =
      add_text(app, "--subject", options.subject.name, "LIBRARY.so",
               "your collider, a shared library, from DIR; default: what subjects.json there "
               "names, else one that is written, in the language of DIR");
  add_text(app, "--subject-command", options.subject.command, "COMMAND",
           "or a program, as it is started in DIR")
      ->excludes(library);
  add_whole_number(app, "--cases", options.cases,
                   "number of cases of the first campaign; default: 1000000, or 20000 of a "
                   "collider that is written",
                   1);
  add_text(app, "--clone-from", options.clone_from, "URL",
           "where the workflow clones manifuzz from; default: where this one was cloned from");
}

}  // namespace

Run define_init(CLI::App& app) {
  return define<InitArguments, add_init_arguments, init>(app);
}

}  // namespace manifuzz
