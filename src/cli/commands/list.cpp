#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/colliders.hpp"
#include "cli/options.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

std::string list_colliders() {
  std::string lines;
  for (const auto& entry : colliders()) {
    try {
      lines += collider_line(entry.make().declaration);
    } catch (const UserError& error) {
      lines += fmt::format("{:<17} not there: {}\n", entry.name, error.what());
    }
  }
  return lines;
}

struct Catalogue {
  std::string_view name;
  std::string_view description;
  std::string (*list)();
};

constexpr Catalogue kCatalogues[] = {
    {"colliders", "what can be a subject or an oracle", list_colliders},
    {"regimes", "the families of cases that fuzz and generate draw from", list_regimes},
    {"ledger", "the known deviations of oracles, with their sources", list_ledger},
    {"sweeps", "what stress turns until a collider breaks", list_sweeps},
    {"scenes", "the scenes that scene runs", list_scenes}};

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
  app.add_option("WHAT", what,
                 "colliders, regimes, ledger, sweeps or scenes; these lists themselves if not "
                 "given");
}

}  // namespace

const Command kList{
    "list", "What there is, a line each.",
    "manifuzz list\nmanifuzz list colliders\nmanifuzz list regimes\nmanifuzz list ledger\n"
    "manifuzz list sweeps\nmanifuzz list scenes",
    define<std::optional<std::string>, add_list_arguments, list>};

}  // namespace manifuzz
