#include "campaign/hunts/hunt_result.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <tuple>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "campaign/counts_json.hpp"
#include "campaign/result.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

template <class T>
Json known_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

template <class Read>
auto read_unless_null(const JsonView& object, std::string_view key, const Read& read) {
  const JsonView member = object.at(key);
  using Value = std::optional<decltype(read(member))>;
  return member.is_null() ? Value{} : Value{read(member)};
}

/// In "cells" and "pairs_of_conditions", or those keys with "_drawn" behind them.
constexpr std::array<std::string_view, 2> kHuntedKeys{"cells", "pairs_of_conditions"};
constexpr std::array<std::string_view, 2> kDrawnKeys{"cells_drawn", "pairs_of_conditions_drawn"};

void add_cells(Json& json, const std::array<std::string_view, 2>& keys,
               const std::optional<FilledCells>& cells) {
  json[keys[0]] = cells ? Json(cells->all) : Json();
  json[keys[1]] = cells ? Json(cells->of_pairs) : Json();
}

std::optional<FilledCells> read_cells(const JsonView& root,
                                      const std::array<std::string_view, 2>& keys) {
  return read_unless_null(root, keys[0], [&](const JsonView&) {
    return FilledCells{count_in(root, keys[0]), count_or(root, keys[1], 0)};
  });
}

Json json_of_row(const HuntRow& row) {
  return {{"measure", row.measure},
          {"worst", row.worst},
          {"worst_drawn", known_or_null(row.worst_drawn)},
          {"seed", row.seed},
          {"index", row.index},
          {"file", row.file}};
}

HuntRow read_row(const JsonView& row) {
  return {
      std::string(row.at("measure").string()),
      row.at("worst").magnitude(),
      read_unless_null(row, "worst_drawn", [](const JsonView& drawn) { return drawn.magnitude(); }),
      row.at("seed").whole_number(),
      row.at("index").whole_number(),
      std::string(row.at("file").string())};
}

/// The worse of both, of equals the first by index, then by seed.
const HuntRow& worse_of(const HuntRow& one, const HuntRow& other) {
  const auto place = [](const HuntRow& row) { return std::tuple(-row.worst, row.index, row.seed); };
  if (one.worst == 0 || other.worst == 0) return one.worst == 0 ? other : one;
  return place(other) < place(one) ? other : one;
}

void add_row(std::vector<HuntRow>& rows, const HuntRow& row) {
  const auto known = std::ranges::find(rows, row.measure, &HuntRow::measure);
  if (known == rows.end()) {
    rows.push_back(row);
    return;
  }
  HuntRow worse = worse_of(*known, row);
  worse.worst_drawn = std::max(known->worst_drawn, row.worst_drawn);
  *known = worse;
}

bool is_worst_of_hunt(const CorpusCase& known) {
  return known.found && known.found->regime == kRegimeOfHunts && !known.expect &&
         !collider_of_hunted(known.path).empty();
}

/// Where the folder of a corpus has that file.
fs::path place_in_corpus(const std::string& worst_file) {
  const fs::path path(worst_file);
  return fs::path("worst") / path.parent_path().filename() / path.filename();
}

}  // namespace

void add_hunt(const HuntResult& hunt, Json& json) {
  if (hunt.rounds > 0) {
    json["rounds"] = hunt.rounds;
    json["shares"] = hunt.shares;
    json["cases_dealt"] = hunt.cases_dealt;
  }
  json["generations"] = hunt.generations;
  add_cells(json, kHuntedKeys, hunt.cells);
  add_cells(json, kDrawnKeys, hunt.cells_drawn);
  json["rows"] = Json::array();
  for (const HuntRow& row : hunt.rows) json["rows"].push_back(json_of_row(row));
  json["buckets_drawn"] = hunt.buckets_drawn;
}

std::optional<HuntResult> read_hunt(const JsonView& root) {
  if (!root.find("hunt")) return std::nullopt;
  HuntResult hunt{.rounds = count_or(root, "rounds", 0),
                  .shares = count_or(root, "shares", 0),
                  .cases_dealt = count_or(root, "cases_dealt", 0),
                  .generations = count_in(root, "generations"),
                  .cells = read_cells(root, kHuntedKeys),
                  .cells_drawn = read_cells(root, kDrawnKeys)};
  if (hunt.rounds > 0 && hunt.shares == 0) {
    root.at("shares").fail("is 0; rounds are dealt in at least 1");
  }
  for (const JsonView& row : root.at("rows").elements()) hunt.rows.push_back(read_row(row));
  hunt.buckets_drawn = read_texts(root.at("buckets_drawn"));
  return hunt;
}

void add_hunt(CampaignResult& sum, const CampaignResult& run) {
  if (!run.hunt) return;
  const bool is_first = !sum.hunt;
  if (is_first) sum.hunt = HuntResult{run.hunt->rounds, run.hunt->shares, run.hunt->cases_dealt};
  HuntResult& hunt = *sum.hunt;
  hunt.cells = is_first ? run.hunt->cells : std::nullopt;
  hunt.cells_drawn = is_first ? run.hunt->cells_drawn : std::nullopt;
  hunt.generations += run.hunt->generations;
  for (const HuntRow& row : run.hunt->rows) add_row(hunt.rows, row);
  std::vector<std::string>& drawn = hunt.buckets_drawn;
  drawn.insert(drawn.end(), run.hunt->buckets_drawn.begin(), run.hunt->buckets_drawn.end());
  std::erase_if(drawn, [&](const std::string& bucket) {
    return std::ranges::find(sum.buckets, bucket, &BucketResult::bucket) != sum.buckets.end();
  });
  std::ranges::sort(drawn);
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
}

std::vector<CorpusCase> take_out_worst(std::vector<CorpusCase>& cases) {
  const auto worst = std::ranges::stable_partition(cases, std::not_fn(is_worst_of_hunt));
  std::vector<CorpusCase> taken(worst.begin(), worst.end());
  cases.erase(worst.begin(), worst.end());
  return taken;
}

void write_worst(HuntResult& hunt, const std::vector<CorpusCase>& worst,
                 const std::filesystem::path& corpus) {
  for (HuntRow& row : hunt.rows) {
    const std::filesystem::path place = place_in_corpus(row.file);
    const auto kept = std::ranges::find_if(worst, [&](const CorpusCase& known) {
      return known.found->seed == row.seed && known.found->index == row.index &&
             place_in_corpus(known.path) == place;
    });
    row.file.clear();
    if (kept == worst.end()) continue;
    row.file = (corpus / place).string();
    write_file(row.file, InputFile(kept->path).read_all());
  }
}

}  // namespace manifuzz
