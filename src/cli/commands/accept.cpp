#include "campaign/accept.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "report/outputs.hpp"

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
  bool is_by_kind = false;
};

/// The file that is meant, of the smallest case where the worst was named.
std::string file_of(const std::string& name, const AcceptArguments& options) {
  return shrunk_beside(case_file({name, options.folders}));
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
  write_remark(fmt::format("{} is not in {}: it is accepted only in runs whose --corpus holds it",
                           printable(file, 200), printable(folders.corpus(), 200)));
}

/// The files that are named and, if asked for, all of the corpus whose finding is of their kind.
std::vector<std::string> files_to_accept(const AcceptArguments& options) {
  std::vector<std::string> files;
  const auto add = [&](const std::string& file) {
    if (std::ranges::find(files, file) == files.end()) files.push_back(file);
  };
  for (const std::string& name : options.files) add(file_of(name, options));
  if (!options.is_by_kind) return files;
  const Corpus corpus = read_whole(options.folders);
  for (const std::string& named : std::vector(files)) {
    const CorpusCase wanted = read_case_file(named, CaseKind::either);
    for (const CorpusCase& known : corpus.all()) {
      if (is_of_same_kind(known, wanted)) add(shrunk_beside(known.path));
    }
  }
  return files;
}

int accept_files(const AcceptArguments& options) {
  const Acceptance asked{.because = options.because,
                         .link = options.link,
                         .until = options.until,
                         .up_to = options.up_to,
                         .is_of_kind = options.is_by_kind};
  std::vector<CorpusCase> all;  // read before anything is written
  for (const std::string& file : files_to_accept(options)) {
    all.push_back(accepted_case(file, asked));
  }
  for (CorpusCase& known : all) {
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
    throw UserError("accept: name files of findings, or use --list or --drop FILE");
  }
  if (options.because.empty()) {
    throw UserError("--because: is missing; say why the finding is accepted");
  }
  return accept_files(options);
}

void add_accept_arguments(CLI::App& app, AcceptArguments& options) {
  CLI::Option* const files =
      add_text(app, "files", options.files, "FILE", "files of findings, or their buckets");
  CLI::Option* const because =
      add_text(app, "--because", options.because, "TEXT", "why the findings are accepted");
  CLI::Option* const link =
      add_text(app, "--link", options.link, "URL", "link to more about it, such as an issue");
  CLI::Option* const until = add_day(app, "--until", options.until,
                                     "last day on which they are accepted; default: no end");
  CLI::Option* const up_to = add_length(
      app, "--up-to", options.up_to,
      "greatest error to accept, as a share of the size; default: 3 times the worst so far");
  add_corpus(app, options.folders,
             "folder of known cases; default: corpus and the folder of findings");
  CLI::Option* const list =
      app.add_flag("--list", options.list, "list accepted findings, one a line");
  CLI::Option* const drop_file =
      add_text(app, "--drop", options.drop, "FILE", "stop accepting this finding")->excludes(list);
  CLI::Option* const by_kind = app.add_flag("--kind", options.is_by_kind,
                                            "accept every bucket of this kind and collider in the "
                                            "corpus; later runs may show new ones, but "
                                            "none that is worse, and no more of them in all");
  for (CLI::Option* const of_accepting : {files, because, link, until, up_to, by_kind}) {
    of_accepting->excludes(list)->excludes(drop_file);
  }
  add_today(app, options.today);
}

}  // namespace

Run define_accept(CLI::App& app) {
  return define<AcceptArguments, add_accept_arguments, accept>(app);
}

}  // namespace manifuzz
