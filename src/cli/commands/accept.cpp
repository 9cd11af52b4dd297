#include "campaign/accept.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "report/outputs.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

struct AcceptArguments {
  std::vector<std::string> files;
  std::string because;
  std::string link;
  std::string until;
  std::optional<double> up_to;
  CorpusFolders folders;
  std::string drop;
  std::string today;
  bool list = false;
};

/// The file that is meant, of the smallest case where the worst was named.
std::string file_of(const std::string& name, const AcceptArguments& options) {
  return shrunk_beside(case_file({name, options.folders}));
}

/// The case as `show` shows it, or as it is recorded where its colliders are not at hand.
std::string shown(const CorpusCase& known, NamedColliders& colliders, Interruption& interruption) {
  const Collider* const subject = colliders.subject_of(known);
  const Collider* const oracle = colliders.oracle_of(known);
  if (subject == nullptr || oracle == nullptr) return format_case(known);
  return case_text(judged_case(known, *subject, *oracle, interruption));
}

int drop(const AcceptArguments& options) {
  const std::string file = file_of(options.drop, options);
  drop_acceptance(file);
  write_output(fmt::format("dropped {}\n", printable(file, 200)));
  return 0;
}

/// A file that no campaign reads excuses nothing there.
void warn_of_elsewhere(const std::string& file, const CorpusFolders& folders) {
  const auto holds = [&](const std::filesystem::path& folder) {
    return Place(file).is_within(Place(folder));
  };
  if (std::ranges::any_of(folders.all(), holds)) return;
  write_remark(fmt::format("{} is outside of {}: it counts for runs whose --corpus holds it",
                           printable(file, 200), printable(folders.corpus(), 200)));
}

int accept_files(const AcceptArguments& options) {
  const Acceptance asked{.because = options.because,
                         .link = options.link,
                         .until = options.until,
                         .up_to = options.up_to};
  std::vector<CorpusCase> all;  // read before anything is written
  for (const std::string& name : options.files) {
    all.push_back(accepted_case(file_of(name, options), asked));
  }
  NamedColliders colliders(find_installed_or_named({options.folders.corpus()}), {}, {});
  Interruption interruption(kUntilSignal);
  for (CorpusCase& known : all) {
    write_output(shown(known, colliders, interruption) + '\n');
    accept_in(options.folders.corpus(), known);
    write_output(acceptance_in_words(known, options.today) + '\n');
    warn_of_elsewhere(known.path, options.folders);
  }
  return 0;
}

int accept(const AcceptArguments& options) {
  if (options.list) {
    write_output(list_accepted(read_whole(options.folders), options.today));
    return 0;
  }
  if (!options.drop.empty()) return drop(options);
  if (options.files.empty()) {
    throw UserError("accept: name the files of findings, or --list, or --drop FILE");
  }
  if (options.because.empty()) {
    throw UserError("--because: is missing; say why the finding may stay");
  }
  return accept_files(options);
}

void add_accept_arguments(CLI::App& app, AcceptArguments& options) {
  CLI::Option* const files =
      add_text(app, "files", options.files, "FILE", "the files of findings, or their buckets");
  CLI::Option* const because =
      add_text(app, "--because", options.because, "TEXT", "why they may stay");
  CLI::Option* const link =
      add_text(app, "--link", options.link, "URL", "where more is said of it, such as an issue");
  CLI::Option* const until =
      add_day(app, "--until", options.until, "the last day; without end if not given");
  CLI::Option* const up_to =
      add_length(app, "--up-to", options.up_to,
                 "the greatest magnitude, as a share of the size; 3 times the worst if not given");
  add_corpus(app, options.folders,
             "the folder of known cases; if not given, corpus and the folder of findings");
  CLI::Option* const list = app.add_flag("--list", options.list, "what is accepted, a line each");
  CLI::Option* const drop_file =
      add_text(app, "--drop", options.drop, "FILE", "accept it no more")->excludes(list);
  for (CLI::Option* const of_accepting : {files, because, link, until, up_to}) {
    of_accepting->excludes(list)->excludes(drop_file);
  }
  add_today(app, options.today);
}

}  // namespace

const Command kAccept{
    "accept", "Findings that may stay: from now on only what is worse or more frequent fails.",
    "manifuzz accept corpus/regressions/subject-*.json --because 'since 2.3' --up-to 0.5\n"
    "manifuzz accept --list",
    define<AcceptArguments, add_accept_arguments, accept>};

}  // namespace manifuzz
