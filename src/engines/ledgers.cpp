#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "engines/asked_engines.hpp"
#include "engines/engine_texts.hpp"

// The ledgers of the engines that are built: the rows of their sources, with the words and budgets
// of their folders.

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(std::string_view text) {
  return text.empty() ? Json::object() : Json::parse(text);
}

/// The words of causes in an engine's ledger.json.
struct CausesInWords {
  const AskedEngine* engine;
  Json causes;
};

/// An engine's own, and those of the engine whose causes it has too.
std::vector<CausesInWords> causes_in_words(std::string_view engine) {
  const Json ledger = parsed(find_by_name(engine_texts(), engine)->ledger);
  std::vector<CausesInWords> all;
  if (const auto causes = ledger.find("causes"); causes != ledger.end()) {
    all.push_back({find_by_name(asked_engines(), engine), *causes});
  }
  if (const auto of = ledger.find("causes_of"); of != ledger.end()) {
    for (CausesInWords& words : causes_in_words(of->get<std::string>())) {
      all.push_back(std::move(words));
    }
  }
  return all;
}

/// With the engine and its version, as they are cited, before the place.
std::string source_of(const AskedEngine& engine, const Json& cause) {
  std::string cited = cause.value("cited_as", engine.cited_as);
  if (const auto at = cited.find("{}"); at != std::string::npos) {
    cited.replace(at, 2, engine.version);
  }
  return fmt::format("{}, {}", cited, cause.at("source").get<std::string>());
}

/// The entry of a collider on a cause, which looks for nothing yet.
LedgerEntry entry_in_words(std::span<const CausesInWords> words, std::string_view collider,
                           std::string_view cause) {
  LedgerEntry entry{.id = fmt::format("{}-{}", collider, cause), .collider = std::string(collider)};
  for (const auto& [engine, causes] : words) {
    auto found = causes.find(entry.id);
    if (found == causes.end()) found = causes.find(cause);
    if (found == causes.end()) continue;
    entry.description = found->at("description");
    entry.source = source_of(*engine, *found);
    entry.is_no_bug = found->value("no_bug", false);
    return entry;
  }
  throw UserError(fmt::format("no ledger.json has words for {}", entry.id));
}

std::vector<Budget> budgets_from(const Json& budgets, const std::string& id) {
  std::vector<Budget> of_entry;
  if (const auto found = budgets.find(id); found != budgets.end()) {
    for (const auto& [regime, per_million] : found->items())
      of_entry.push_back({regime, per_million});
  }
  return of_entry;
}

}  // namespace

std::vector<LedgerEntry> built_ledger() {
  std::vector<LedgerEntry> all;
  for (const Engine& engine : built_engines()) {
    const auto words = causes_in_words(engine.name);
    const Json budgets = parsed(find_by_name(engine_texts(), engine.name)->budgets);
    for (const LedgerRows& of_collider : engine.ledger) {
      for (const LedgerRow& row : of_collider.rows) {
        LedgerEntry& entry =
            all.emplace_back(entry_in_words(words, of_collider.collider, row.cause));
        entry.explains = row.explains;
        entry.explains_lost = row.explains_lost;
        entry.budgets = budgets_from(budgets, entry.id);
      }
    }
  }
  return all;
}

std::vector<SequenceEntry> built_sequence_ledger() {
  std::vector<SequenceEntry> all;
  for (const Engine& engine : built_engines()) {
    const auto words = causes_in_words(engine.name);
    for (const SequenceRows& of_collider : engine.sequence_ledger) {
      for (const SequenceRow& row : of_collider.rows) {
        all.push_back({entry_in_words(words, of_collider.collider, row.cause), row.explains});
      }
    }
  }
  return all;
}

}  // namespace manifuzz
