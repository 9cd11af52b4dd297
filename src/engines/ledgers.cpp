#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "engines/asked_engines.hpp"
#include "engines/engine_texts.hpp"

// The ledgers of the engines that are built: the rows of their sources, with the words and budgets
// of their folders.

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(std::string_view engine, std::string_view file, std::string_view text) {
  try {
    return text.empty() ? Json::object() : Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw UserError(fmt::format("oracle/{}/{}: {}", engine, file, error.what()));
  }
}

/// Fails where an object of an engine's ledger.json is none, or has other members than these.
void expect_members(std::string_view engine, const std::string& path, const Json& object,
                    const std::set<std::string_view>& allowed) {
  const auto fail = [&](std::string_view what) {
    throw UserError(fmt::format("oracle/{}/ledger.json: {}: {}; {} are expected", engine, path,
                                what, fmt::join(allowed, ", ")));
  };
  if (!object.is_object()) fail("is no object");
  for (const auto& [key, value] : object.items()) {
    if (!allowed.contains(key)) fail(fmt::format("unknown member '{}'", key));
    const bool is_flag = key == "no_bug";
    if (path != "$" && !(is_flag ? value.is_boolean() : value.is_string())) {
      fail(fmt::format("'{}' is not a {}", key, is_flag ? "boolean" : "string"));
    }
  }
}

/// The words of causes in an engine's ledger.json.
Json causes_in(std::string_view engine, const Json& ledger) {
  Json causes = ledger.value("causes", Json::object());
  for (const auto& [cause, said] : causes.items()) {
    const std::string path = fmt::format("$.causes.{}", cause);
    expect_members(engine, path, said, {"description", "source", "cited_as", "no_bug"});
    for (const char* const needed : {"description", "source"}) {
      if (said.contains(needed)) continue;
      throw UserError(fmt::format("oracle/{}/ledger.json: {}: has no '{}'", engine, path, needed));
    }
  }
  return causes;
}

Json ledger_of(std::string_view engine) {
  Json ledger = parsed(engine, "ledger.json", find_by_name(engine_texts(), engine)->ledger);
  expect_members(engine, "$", ledger, {"causes", "causes_of"});
  return ledger;
}

/// An engine, its words of causes, and those of the engine whose causes it has too.
struct CausesInWords {
  const AskedEngine* engine;
  std::vector<Json> causes;
};

CausesInWords causes_in_words(std::string_view engine) {
  const Json ledger = ledger_of(engine);
  CausesInWords words{find_by_name(asked_engines(), engine), {}};
  words.causes.push_back(causes_in(engine, ledger));
  const std::string other = ledger.value("causes_of", std::string());
  if (other.empty()) return words;
  if (find_by_name(asked_engines(), other) == nullptr) {
    throw UserError(
        fmt::format("oracle/{}/ledger.json: $.causes_of: there is no engine '{}'", engine, other));
  }
  words.causes.push_back(causes_in(other, ledger_of(other)));
  return words;
}

/// With the engine and its version, as they are cited, before the place.
std::string source_of(const AskedEngine& engine, const Json& cause) {
  std::string cited = cause.value("cited_as", engine.cited_as);
  if (const auto at = cited.find("{}"); at != std::string::npos) {
    cited.replace(at, 2, engine.version);
  }
  return fmt::format("{}, {}", cited, cause.at("source").get<std::string>());
}

/// The entry of a collider on a cause, which looks for nothing yet. Causes of another engine are
/// cited as the collider's own engine cites them: it may have them in another version.
LedgerEntry entry_in_words(const CausesInWords& words, std::string_view collider,
                           std::string_view cause) {
  LedgerEntry entry{.id = fmt::format("{}-{}", collider, cause), .collider = std::string(collider)};
  for (const Json& causes : words.causes) {
    auto found = causes.find(entry.id);
    if (found == causes.end()) found = causes.find(cause);
    if (found == causes.end()) continue;
    entry.description = found->at("description");
    entry.source = source_of(*words.engine, *found);
    entry.is_no_bug = found->value("no_bug", false);
    return entry;
  }
  throw UserError(
      fmt::format("oracle/{}/ledger.json: $.causes has no words for {}: '{}' or '{}' "
                  "is expected",
                  words.engine->name, entry.id, cause, entry.id));
}

std::vector<Budget> budgets_from(const Json& budgets, const std::string& id) {
  std::vector<Budget> of_entry;
  if (const auto found = budgets.find(id); found != budgets.end()) {
    for (const auto& [regime, per_million] : found->items())
      of_entry.push_back({regime, per_million});
  }
  return of_entry;
}

/// The ledgers are read before main begins: what is wrong with one ends the program, with status 2.
template <class Read>
auto read_or_end(const Read& read) {
  try {
    return read();
  } catch (const std::exception& error) {
    fmt::print(stderr, "manifuzz: {}\n", error.what());
    std::_Exit(2);
  }
}

std::vector<LedgerEntry> read_ledger() {
  std::vector<LedgerEntry> all;
  for (const Engine& engine : built_engines()) {
    const auto words = causes_in_words(engine.name);
    const Json budgets =
        parsed(engine.name, "budgets.json", find_by_name(engine_texts(), engine.name)->budgets);
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
  if (all.size() <= kLedgerMax) return all;
  throw UserError(fmt::format("the ledgers have {} entries; kLedgerMax is {}: raise it", all.size(),
                              kLedgerMax));
}

std::vector<SequenceEntry> read_sequence_ledger() {
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

}  // namespace

std::vector<LedgerEntry> built_ledger() {
  return read_or_end(read_ledger);
}

std::vector<SequenceEntry> built_sequence_ledger() {
  return read_or_end(read_sequence_ledger);
}

}  // namespace manifuzz
