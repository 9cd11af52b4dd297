#include "cli/breaking_points.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cases/file.hpp"
#include "cases/user_error.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "manifuzz/breaking_points/1";

/// What has to be the same.
Json terms_of(const StressPlan& plan) {
  return {{"seed", plan.seed}, {"cases", plan.cases}, {"frames", plan.frames}};
}

/// Wrong frames, and changes that the truth does not ask for and rounding does not excuse.
std::uint64_t faults_of(const StepTally& tally) {
  const WalkTally& walk = tally.walk;
  return tally.wrong() + walk.flickers.with_margin + walk.jumps.with_margin +
         walk.features.with_margin;
}

Json breaking_point(const StressResult& result, const Sweep& sweep, std::size_t contestant) {
  const auto step = breaking_step(result.steps(sweep, contestant));
  return step ? Json(sweep.values[*step]) : Json();
}

std::string in_words(const Json& point) {
  return point.is_null() ? "never" : fmt::format("at {:g}", point.get<double>());
}

/// How far into a sweep its value lies; a point that is null lies beyond all.
std::size_t place_of(const Sweep& sweep, const Json& point) {
  if (point.is_null()) return sweep.values.size();
  return std::ranges::find(sweep.values, point.get<double>()) - sweep.values.begin();
}

/// `visit(group, name of the sweep or walk, contestant)` for all that is stored and was run.
template <class Visit>
void for_each_stored(const StressPlan& plan, const Json& stored, const Visit& visit) {
  const auto with = [&](const char* group, std::string_view name) {
    const auto row = stored.at(group).find(std::string(name));
    if (row == stored.at(group).end()) return;
    for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
      const auto cell = row->find(plan.contestants[i].name);
      if (cell != row->end()) visit(name, i, *cell);
    }
  };
  for (const Sweep* const sweep : plan.sweeps) with("sweeps", sweep->name);
  for (const Walk* const walk : plan.walks) with("walks", walk->name);
}

}  // namespace

Json breaking_points_json(const StressPlan& plan, const StressResult& result) {
  Json json{{"format", kFormat}};
  json.update(terms_of(plan));
  json["sweeps"] = Json::object();
  json["walks"] = Json::object();
  for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
    const std::string& name = plan.contestants[i].name;
    if (name == kIdealName) continue;
    for (const Sweep* const sweep : plan.sweeps) {
      if (plan.contestants[i].walks_only) break;
      json["sweeps"][std::string(sweep->name)][name] = breaking_point(result, *sweep, i);
    }
    for (const Walk* const walk : plan.walks) {
      const StepTally* const tally = result.walk(*walk, i);
      if (tally != nullptr) json["walks"][std::string(walk->name)][name] = faults_of(*tally);
    }
  }
  return json;
}

Json read_breaking_points(const std::string& path, const StressPlan& plan) {
  InputFile file(path);
  Json stored;
  try {
    stored = Json::parse(file.read_all());
    if (stored.at("format") != kFormat) throw UserError("");
    for_each_stored(plan, stored, [](std::string_view, std::size_t, const Json& cell) {
      if (!cell.is_null() && !cell.is_number()) throw UserError("");
    });
  } catch (const nlohmann::json::exception&) {
    throw UserError(fmt::format("--baseline: {}: what --store writes is expected", file.name()));
  } catch (const UserError&) {
    throw UserError(fmt::format("--baseline: {}: what --store writes is expected", file.name()));
  }
  const Json terms = terms_of(plan);
  for (const auto& [key, value] : terms.items()) {
    if (stored.value(key, Json()) == value) continue;
    throw UserError(fmt::format("--baseline: {}: was stored with --{} {}, not {}", file.name(), key,
                                stored.value(key, Json()).dump(), value.dump()));
  }
  return stored;
}

std::vector<std::string> moved_down(const StressPlan& plan, const StressResult& result,
                                    const Json& stored) {
  std::vector<std::string> lines;
  for_each_stored(plan, stored, [&](std::string_view name, std::size_t i, const Json& before) {
    const std::string& who = plan.contestants[i].name;
    if (const Sweep* const sweep = find_sweep(name)) {
      const Json now = breaking_point(result, *sweep, i);
      if (place_of(*sweep, now) >= place_of(*sweep, before)) return;
      lines.push_back(
          fmt::format("{}: {} breaks {}, stored: {}", name, who, in_words(now), in_words(before)));
    } else if (const StepTally* const tally = result.walk(*find_walk(name), i)) {
      if (faults_of(*tally) <= before.get<std::uint64_t>()) return;
      lines.push_back(fmt::format("{}: {} has {} faults, stored: {}", name, who, faults_of(*tally),
                                  before.dump()));
    }
  });
  return lines;
}

}  // namespace manifuzz
