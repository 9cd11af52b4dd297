#include "cli/fuzz_result_json.hpp"

#include <string>

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;
using Count = std::uint64_t;

Json or_null(const std::optional<Count>& seed) {
  return seed ? Json(*seed) : Json();
}

Json json_of(const ErrorShare& error) {
  return {{"depth", error.depth}, {"position", error.position}};
}

Json json_of(const RegimeResult& regime) {
  return {{"name", regime.name},
          {"cases", regime.cases},
          {"touching", regime.touching},
          {"near", regime.near},
          {"unexplained", regime.unexplained}};
}

Json json_of(const LedgerResult& entry) {
  return {{"id", entry.id},
          {"hits", entry.hits},
          {"regimes", entry.regimes},
          {"over_budget", entry.over_budget}};
}

Json json_of(const BucketResult& found) {
  return {{"bucket", found.bucket}, {"verdict", found.verdict},
          {"count", found.count},   {"first_index", found.first_index},
          {"regime", found.regime}, {"magnitude", found.magnitude},
          {"file", found.file},     {"command", found.command},
          {"new", found.is_new}};
}

Json json_of(const CasesRun& part) {
  return {{"seed", or_null(part.seed)}, {"first", part.first}, {"cases", part.cases}};
}

template <class T>
Json list_of(const std::vector<T>& all) {
  Json list = Json::array();
  for (const T& one : all) list.push_back(json_of(one));
  return list;
}

// Keys that the formats of manifuzz fix are required; the others came later, or may go.

std::string string_or(const JsonView& object, std::string_view key, std::string_view otherwise) {
  const auto member = object.find(key);
  return std::string(member ? member->string() : otherwise);
}

Count count_in(const JsonView& object, std::string_view key) {
  return object.at(key).whole_number();
}

Count count_or_0(const JsonView& object, std::string_view key) {
  const auto member = object.find(key);
  return member ? member->whole_number() : 0;
}

bool flag_in(const JsonView& object, std::string_view key) {
  const auto member = object.find(key);
  return member && member->boolean();
}

std::optional<Count> read_seed(const JsonView& object) {
  const JsonView seed = object.at("seed");
  return seed.is_null() ? std::nullopt : std::optional(seed.whole_number());
}

std::map<std::string, Count> read_counts(const JsonView& object) {
  std::map<std::string, Count> counts;
  for (const std::string_view name : object.keys()) {
    counts.emplace(name, count_in(object, name));
  }
  return counts;
}

ErrorShare read_error(const JsonView& object) {
  return {object.at("depth").magnitude(), object.at("position").magnitude()};
}

RegimeResult read_regime(const JsonView& row) {
  return {std::string(row.at("name").string()), count_in(row, "cases"), count_in(row, "touching"),
          count_in(row, "near"), count_in(row, "unexplained")};
}

LedgerResult read_entry(const JsonView& row) {
  LedgerResult entry{std::string(row.at("id").string()),
                     count_in(row, "hits"),
                     read_counts(row.at("regimes")),
                     {}};
  for (const JsonView& regime : row.at("over_budget").elements()) {
    entry.over_budget.emplace_back(regime.string());
  }
  return entry;
}

BucketResult read_bucket(const JsonView& row) {
  return {std::string(row.at("bucket").string()),
          std::string(row.at("verdict").string()),
          count_in(row, "count"),
          count_in(row, "first_index"),
          std::string(row.at("regime").string()),
          row.at("magnitude").magnitude(),
          std::string(row.at("file").string()),
          std::string(row.at("command").string()),
          flag_in(row, "new")};
}

CasesRun read_part(const JsonView& part) {
  return {read_seed(part), count_in(part, "first"), read_counts(part.at("cases"))};
}

template <class Read>
auto read_list(const std::optional<JsonView>& list, const Read& read) {
  std::vector<decltype(read(*list))> all;
  if (!list) return all;
  for (const JsonView& element : list->elements()) all.push_back(read(element));
  return all;
}

Json read_machine(const JsonView& machine) {
  return {{"processor", string_or(machine, "processor", "unknown")},
          {"cores", count_or_0(machine, "cores")},
          {"instruction_set", string_or(machine, "instruction_set", "unknown")}};
}

void read_provenance(const JsonView& root, FuzzResult& result) {
  result.machine = read_machine(root.at("machine"));
  result.compiler = root.at("compiler").string();
  result.seed = read_seed(root);
  const JsonView versions = root.at("versions");
  for (const std::string_view name : versions.keys()) {
    result.versions.emplace_back(name, versions.at(name).string());
  }
}

}  // namespace

Json json_of(const FuzzResult& result) {
  const auto cases = static_cast<double>(result.cases());
  Json json{{"machine", result.machine},
            {"compiler", result.compiler},
            {"seed", or_null(result.seed)},
            {"versions", Json::object()},
            {"subject", result.subject},
            {"oracle", result.oracle},
            {"cases", result.cases()},
            {"seconds", result.seconds},
            {"cases_per_second", result.seconds > 0 ? cases / result.seconds : 0},
            {"jobs", result.jobs},
            {"touching", result.touching()},
            {"near", result.near()}};
  for (const auto& [name, version] : result.versions) json["versions"][name] = version;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    json["verdicts"][std::string(kVerdictNames[i])] = result.verdicts[i];
  }
  json["unexplained"] = result.unexplained();
  json["worst_error"] = {{"subject", json_of(result.of_subject)},
                         {"oracle", json_of(result.of_oracle)}};
  json["vacuous"] = is_vacuous(result);
  json["interrupted"] = result.interrupted;
  json["stopped_early"] = result.stopped_early;
  json["failed"] = has_failed(result);
  json["first"] = result.first;
  json["budgets_hold"] = result.budgets_hold;
  json["regimes"] = list_of(result.regimes);
  json["ledger"] = list_of(result.ledger);
  json["buckets"] = list_of(result.buckets);
  if (!result.parts.empty()) json["parts"] = list_of(result.parts);
  return json;
}

FuzzResult read_fuzz_result(const JsonView& root) {
  FuzzResult result;
  read_provenance(root, result);
  result.subject = string_or(root, "subject", "");
  result.oracle = string_or(root, "oracle", "");
  result.seconds = root.at("seconds").magnitude();
  result.jobs = count_in(root, "jobs");
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    result.verdicts[i] = count_in(root.at("verdicts"), kVerdictNames[i]);
  }
  if (const auto worst = root.find("worst_error")) {
    result.of_subject = read_error(worst->at("subject"));
    result.of_oracle = read_error(worst->at("oracle"));
  }
  result.interrupted = flag_in(root, "interrupted");
  result.stopped_early = flag_in(root, "stopped_early");
  result.first = count_or_0(root, "first");
  result.budgets_hold = flag_in(root, "budgets_hold");
  result.regimes = read_list(root.at("regimes"), read_regime);
  result.ledger = read_list(root.find("ledger"), read_entry);
  result.buckets = read_list(root.at("buckets"), read_bucket);
  result.parts = read_list(root.find("parts"), read_part);
  return result;
}

}  // namespace manifuzz
