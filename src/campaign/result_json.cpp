#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "campaign/counts_json.hpp"
#include "campaign/hints/hint_json.hpp"
#include "campaign/result.hpp"
#include "campaign/risk/risk_json.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;
using Count = std::uint64_t;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const Errors& errors) {
  Json json;
  for (std::size_t i = 0; i < kComponentNames.size(); ++i)
    json[std::string(kComponentNames[i])] = errors.all()[i];
  return json;
}

Json json_of(const RegimeResult& regime) {
  Json json{{"name", regime.name},
            {"cases", regime.cases},
            {"touching", regime.touching},
            {"near", regime.near},
            {"unexplained", regime.unexplained}};
  if (regime.frames > 0) json["frames"] = regime.frames;
  if (regime.agreed > 0) {
    json["agreed_contacts"] = regime.agreed;
    json["agreed_contacts_judged"] = regime.agreed_judged;
  }
  return json;
}

Json json_of(const LedgerResult& entry) {
  return {{"id", entry.id},
          {"hits", entry.hits},
          {"regimes", entry.regimes},
          {"over_budget", entry.over_budget}};
}

Json json_of(const BucketResult& found) {
  Json json{{"bucket", found.bucket},
            {"verdict", found.verdict},
            {"count", found.count},
            {"regimes", found.regimes},
            {"seed", found.seed},
            {"first_index", found.first_index},
            {"regime", found.regime},
            {"magnitude", found.error.magnitude},
            {"errors", json_of(found.error.errors)},
            {"file", found.file},
            {"command", found.command},
            {"new", found.is_new},
            {"accepted", found.is_accepted},
            {"in_baseline", found.is_in_baseline}};
  if (!found.objection.empty()) json["objection"] = found.objection;
  if (!found.agreed.empty()) json["agreed_contacts"] = found.agreed;
  return json;
}

Json json_of(const CasesRun& of) {
  return {{"seed", of.seed}, {"first", of.first}, {"cases", of.cases}, {"seconds", of.seconds}};
}

template <class T>
Json list_of(const std::vector<T>& all) {
  Json list = Json::array();
  for (const T& one : all) list.push_back(json_of(one));
  return list;
}

// Keys that the formats of manifuzz fix are required; the others came later, or may go.

Count whole_in(const JsonView& object, std::string_view key) {
  return object.at(key).whole_number();
}

RegimeResult read_regime(const JsonView& row) {
  const std::string name(row.at("name").string());
  return {{count_in(row, "cases"), count_in(row, "touching"), count_in(row, "near"),
           count_in(row, "unexplained"), count_or(row, "frames", 0),
           count_or(row, "agreed_contacts", 0), count_or(row, "agreed_contacts_judged", 0)},
          name};
}

LedgerResult read_entry(const JsonView& row) {
  return {std::string(row.at("id").string()), count_in(row, "hits"), read_counts(row.at("regimes")),
          read_texts(row.at("over_budget"))};
}

BucketResult read_bucket(const JsonView& row, Count seed) {
  return {.bucket = std::string(row.at("bucket").string()),
          .verdict = std::string(row.at("verdict").string()),
          .count = count_in(row, "count"),
          .seed = row.find("seed") ? whole_in(row, "seed") : seed,
          .first_index = whole_in(row, "first_index"),
          .regime = std::string(row.at("regime").string()),
          .error = {row.at("magnitude").magnitude(),
                    row.find("errors") ? read_errors(row.at("errors")) : Errors{}},
          .file = std::string(row.at("file").string()),
          .command = std::string(row.at("command").string()),
          .is_new = flag_in(row, "new"),
          .is_accepted = flag_in(row, "accepted"),
          .objection = row.string_or("objection", ""),
          .is_in_baseline = flag_in(row, "in_baseline"),
          .regimes = counts_or_none(row, "regimes"),
          .agreed = counts_or_none(row, "agreed_contacts")};
}

CasesRun read_part(const JsonView& part) {
  return {whole_in(part, "seed"), whole_in(part, "first"), read_counts(part.at("cases")),
          part.at("seconds").magnitude()};
}

/// The one part of a result that tells of no parts.
CasesRun only_part(const JsonView& root, const std::vector<RegimeResult>& regimes) {
  CasesRun part{whole_in(root, "seed"),
                root.find("first") ? whole_in(root, "first") : 0,
                {},
                root.at("seconds").magnitude()};
  for (const RegimeResult& regime : regimes) part.cases[regime.name] += regime.cases;
  return part;
}

template <class Read>
auto read_list(const std::optional<JsonView>& list, const Read& read) {
  std::vector<decltype(read(*list))> all;
  if (!list) return all;
  for (const JsonView& element : list->elements()) all.push_back(read(element));
  return all;
}

/// Cases are counted once.
void expect_disjoint(const JsonView& root, const std::vector<CasesRun>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(parts[i], parts[j])) root.at("parts").fail("has cases twice");
    }
  }
}

Json read_machine(const JsonView& machine) {
  return {{"processor", machine.string_or("processor", "unknown")},
          {"cores", count_or(machine, "cores", 0)},
          {"instruction_set", machine.string_or("instruction_set", "unknown")}};
}

Json json_of(const TieBias& bias) {
  if (bias == TieBias{.absolute = bias.absolute}) return bias.absolute;
  return {{"absolute", bias.absolute},
          {"relative", bias.relative},
          {"towards", bias.towards == Side::a ? "a" : "b"}};
}

Settings read_settings(const JsonView& root) {
  Settings settings{root.string_or("subject", ""),
                    root.string_or("oracle", ""),
                    {},
                    {},
                    {},
                    count_or(root, "judge_every", 1),
                    {},
                    root.string_or("hunt", "")};
  const JsonView versions = root.at("versions");
  for (const std::string_view name : versions.keys()) {
    settings.versions.emplace_back(name, versions.at(name).string());
  }
  if (const auto tie_bias = root.find("tie_bias")) settings.tie_bias = read_tie_bias(*tie_bias);
  if (const auto allowances = root.find("allowances"))
    settings.allowances = read_texts(*allowances);
  const auto radius = root.find("radius");
  if (radius && !radius->is_null()) settings.radius = radius->magnitude();
  return settings;
}

}  // namespace

Json json_of(const CampaignResult& result) {
  const Settings& settings = result.settings;
  const double seconds = result.seconds();
  Json json{{"machine", result.machine},
            {"compiler", result.compiler},
            {"seed", or_null(result.seed())},
            {"versions", Json::object()},
            {"subject", settings.subject},
            {"oracle", settings.oracle},
            {"tie_bias", json_of(settings.tie_bias)},
            {"radius", or_null(settings.radius)},
            {"judge_every", settings.judge_every},
            {"cases", result.cases()},
            {"seconds", seconds},
            {"cases_per_second", seconds > 0 ? static_cast<double>(result.cases()) / seconds : 0},
            {"jobs", result.jobs},
            {"touching", result.touching()},
            {"near", result.near()}};
  if (result.has_frames()) {
    json["sequences"] = result.cases();
    json["frames"] = result.frames();
  }
  for (const auto& [name, version] : settings.versions) json["versions"][name] = version;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    json["verdicts"][std::string(kVerdictNames[i])] = result.verdicts[i];
  }
  json["agreeing"] = result.agreeing();
  json["agreeing_judged"] = result.agreeing_judged;
  json["unexplained"] = result.unexplained();
  json["accepted"] = result.accepted();
  json["stale"] = result.stale;
  json["unshrunk"] = result.unshrunk;
  if (!settings.allowances.empty()) {
    json["allowances"] = settings.allowances;
    json["by_tolerance"] = result.by_tolerance;
  }
  json["worst_error"] = {{"subject", json_of(result.of_subject)},
                         {"oracle", json_of(result.of_oracle)}};
  json["vacuous"] = is_vacuous(result);
  json["interrupted"] = result.interrupted;
  json["stopped_early"] = result.stopped_early;
  json["failed"] = has_failed(result);
  json["first"] = result.first();
  json["budgets_hold"] = result.budgets_hold;
  json["regimes"] = list_of(result.regimes);
  json["ledger"] = list_of(result.ledger);
  json["buckets"] = list_of(result.buckets);
  json["hints"] = list_of(result.hints);
  if (result.parts.size() > 1) json["parts"] = list_of(result.parts);
  add_risk(result, json);
  if (result.hunt) {
    json["hunt"] = settings.hunt;
    add_hunt(*result.hunt, json);
  }
  return json;
}

CampaignResult read_campaign_result(const JsonView& root) {
  CampaignResult result;
  result.machine = read_machine(root.at("machine"));
  result.compiler = root.at("compiler").string();
  result.settings = read_settings(root);
  result.jobs = count_in(root, "jobs");
  // Sums are those of the rows below.
  for (const char* const sum : {"cases", "touching", "near", "unexplained"}) count_in(root, sum);
  count_or(root, "accepted", 0);
  flag_in(root, "failed");
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    result.verdicts[i] = count_in(root.at("verdicts"), kVerdictNames[i]);
  }
  result.by_tolerance = count_or(root, "by_tolerance", 0);
  result.agreeing_judged = count_or(root, "agreeing_judged", 0);
  if (const auto worst = root.find("worst_error")) {
    result.of_subject = read_errors(worst->at("subject"));
    result.of_oracle = read_errors(worst->at("oracle"));
  }
  if (const auto stale = root.find("stale")) result.stale = read_texts(*stale);
  result.unshrunk = count_or(root, "unshrunk", 0);
  result.interrupted = flag_in(root, "interrupted");
  result.stopped_early = flag_in(root, "stopped_early");
  result.budgets_hold = flag_in(root, "budgets_hold");
  result.regimes = read_list(root.at("regimes"), read_regime);
  result.ledger = read_list(root.find("ledger"), read_entry);
  result.parts = read_list(root.find("parts"), read_part);
  if (result.parts.empty()) result.parts = {only_part(root, result.regimes)};
  std::ranges::sort(result.parts);
  const Count seed = result.parts.front().seed;
  result.buckets =
      read_list(root.at("buckets"), [&](const JsonView& row) { return read_bucket(row, seed); });
  result.hints = read_list(root.find("hints"), read_hint);
  expect_disjoint(root, result.parts);
  read_risk(root, result);
  result.hunt = read_hunt(root);
  return result;
}

}  // namespace manifuzz
