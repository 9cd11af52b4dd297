#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "corpus/corpus_folders.hpp"
#include "engines/colliders.hpp"
#include "engines/sequence_colliders.hpp"
#include "report/outputs.hpp"
#include "report/sequence/sequence_report.hpp"

namespace manifuzz {
namespace {

/// What `line_of` says of each that is there, a line each.
template <class Entry>
std::string lines_of_colliders(const std::vector<Entry>& entries, const auto& line_of) {
  std::string lines;
  for (const Entry& entry : entries) {
    try {
      lines += line_of(entry.make());
    } catch (const UserError& error) {
      lines += fmt::format("{:<17} not there: {}\n", entry.name, error.what());
    }
  }
  return lines;
}

std::string list_colliders() {
  return lines_of_colliders(
             colliders(),
             [](const Collider& collider) { return collider_line(collider.declaration); }) +
         lines_of_colliders(sequence_colliders(), keeper_line);
}

/// Writes the lines, then throws an error with the first message and the number of the others.
[[noreturn]] void end_with(const std::vector<std::string>& errors, const std::string& lines) {
  write_output(lines);
  if (errors.size() == 1) throw UserError(errors.front());
  throw UserError(fmt::format("{} (and {} more)", errors.front(), errors.size() - 1));
}

/// The worst known case of each collider by each measure: what the files of the corpus and of the
/// findings say.
std::string list_worst() {
  namespace fs = std::filesystem;
  Corpus known;
  for (const fs::path& folder : CorpusFolders{}.all()) {
    const fs::path worst = folder / "worst";
    std::error_code unknown;
    // A link to nothing is broken, and not missing.
    const bool is_there = fs::symlink_status(worst, unknown).type() != fs::file_type::not_found;
    if (is_there) known.add(read_corpus({&worst, 1}));
  }
  std::string lines;
  for (const CorpusCase& one : known.cases) {
    const fs::path file(one.path);
    lines +=
        fmt::format("{:<17} {:<21} {} [{}]\n", printable_path(file.parent_path().filename()),
                    printable_path(file.stem()), printable(one.note, 200), printable_path(file));
  }
  if (!known.errors.empty()) end_with(known.errors, lines);
  return lines.empty() ? "none is known: manifuzz hunt finds some\n" : lines;
}

struct Catalogue {
  std::string_view name;
  std::string_view description;
  std::string (*list)();
};

constexpr Catalogue kCatalogues[] = {
    {"colliders", "colliders that can be a subject or an oracle", list_colliders},
    {"regimes", "families of cases that fuzz and generate draw from", list_regimes},
    {"motions", "families of sequences, for colliders that keep points", list_motions},
    {"ledger", "known causes of wrong answers, with their places in the engines' sources",
     list_ledger},
    {"sweeps", "parameters that stress varies until a collider breaks", list_sweeps},
    {"scenes", "scenes that the command scene runs", list_scenes},
    {"worst", "the worst known case of each collider, by each measure of hunt", list_worst}};

std::string list_catalogues() {
  std::string lines;
  for (const Catalogue& one : kCatalogues) {
    lines += fmt::format("{:<13} {}\n", one.name, one.description);
  }
  return lines;
}

int list(const std::optional<std::string>& what) {
  write_output(what ? chosen_by_name(kCatalogues, {&*what, 1}, "list of", "list").front()->list()
                    : list_catalogues());
  return 0;
}

void add_list_arguments(CLI::App& app, std::optional<std::string>& what) {
  app.add_option(
      "WHAT", what,
      "colliders, regimes, motions, ledger, sweeps, scenes or worst; default: print these names");
}

}  // namespace

Run define_list(CLI::App& app) {
  return define<std::optional<std::string>, add_list_arguments, list>(app);
}

}  // namespace manifuzz
