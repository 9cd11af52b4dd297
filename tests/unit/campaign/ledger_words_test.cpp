#include <algorithm>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "engines/engine.hpp"
#include "engines/engine_texts.hpp"

// Rows that look for what an entry is about, words, and budgets come from three files of an
// engine's folder: none is without the others.

using namespace manifuzz;

namespace {

nlohmann::json parsed(std::string_view text) {
  return text.empty() ? nlohmann::json::object() : nlohmann::json::parse(text);
}

/// The entries of a built engine: pairs of a collider and a cause.
std::set<std::pair<std::string, std::string>> rows_of(const Engine& engine) {
  std::set<std::pair<std::string, std::string>> rows;
  for (const auto& [collider, of_collider] : engine.ledger) {
    for (const LedgerRow& row : of_collider) rows.emplace(collider, row.cause);
  }
  for (const auto& [collider, of_collider] : engine.sequence_ledger) {
    for (const SequenceRow& row : of_collider) rows.emplace(collider, row.cause);
  }
  return rows;
}

}  // namespace

TEST_CASE("every entry of the ledger has words and a predicate, and its id is its own") {
  std::set<std::string> ids;
  for (const LedgerEntry& entry : ledger()) {
    CAPTURE(entry.id);
    CHECK(ids.insert(entry.id).second);
    CHECK_FALSE(entry.description.empty());
    CHECK_FALSE(entry.source.empty());
    CHECK((entry.explains != nullptr || entry.explains_lost != nullptr));
  }
  for (const SequenceEntry& known : built_sequence_ledger()) {
    CAPTURE(known.entry.id);
    CHECK(ids.insert(known.entry.id).second);
    CHECK_FALSE(known.entry.description.empty());
    CHECK(known.explains != nullptr);
  }
}

TEST_CASE("a source begins with the engine and its version, as they are cited") {
  const auto is_of_box2d = [](const LedgerEntry& entry) { return entry.collider == "box2d"; };
  const auto found = std::ranges::find_if(ledger(), is_of_box2d);
  REQUIRE(found != ledger().end());
  CHECK(found->source.starts_with("Box2D 2.4.1, include/box2d/b2_math.h"));
}

TEST_CASE("all words and budgets in an engine's folder are those of a row") {
  for (const Engine& engine : built_engines()) {
    const EngineText& text = *find_by_name(engine_texts(), engine.name);
    const auto rows = rows_of(engine);
    const auto is_of_row = [&](const std::string& key, bool may_be_cause) {
      return std::ranges::any_of(rows, [&](const auto& row) {
        return key == row.first + "-" + row.second || (may_be_cause && key == row.second);
      });
    };
    const auto causes = parsed(text.ledger).value("causes", nlohmann::json::object());
    for (const auto& cause : causes.items()) {
      CAPTURE(engine.name, cause.key());
      CHECK(is_of_row(cause.key(), true));
      for (const auto& field : cause.value().items()) {
        CHECK(std::set<std::string>{"description", "source", "cited_as", "no_bug"}.contains(
            field.key()));
      }
    }
    const nlohmann::json budgets = parsed(text.budgets);
    for (const auto& budget : budgets.items()) {
      CAPTURE(engine.name, budget.key());
      CHECK(is_of_row(budget.key(), false));
    }
  }
}
