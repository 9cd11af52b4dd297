#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "measure/stress/stress.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "manifuzz/breaking_points/1";

/// Wrong frames, and changes that the truth does not ask for and rounding does not excuse.
std::uint64_t faults_of(const StepStatistics& tally) {
  const WalkChanges& walk = tally.walk;
  return tally.wrong() + walk.flickers.with_margin + walk.jumps.with_margin +
         walk.features.with_margin;
}

std::string in_words(const Sweep& sweep, std::size_t place) {
  return place < sweep.values.size() ? fmt::format("at {:g}", sweep.values[place]) : "never";
}

/// What has to be the same: of sweeps and of walks alone, what they depend on.
Json terms_of(const StressPlan& plan, bool of_sweeps, bool of_walks) {
  Json terms{{"seed", plan.seed}, {"flush_to_zero", plan.flush_to_zero}};
  if (of_sweeps) terms["cases"] = plan.cases;
  if (of_walks) terms["frames"] = plan.frames;
  return terms;
}

/// `where`: the option and its file.
[[noreturn]] void refuse(std::string_view where, std::string_view what) {
  throw UserError(fmt::format("{}: {}", where, what));
}

std::string where_of(std::string_view option, const std::string& path) {
  return fmt::format("{}: {}", option, printable(path, 200));
}

/// A file as --store writes it, as far as its sections.
Json parsed(const std::string& path, std::string_view where) {
  InputFile file(path);
  const Json stored = Json::parse(file.read_all(), nullptr, false);
  if (!stored.is_object() || stored.value("format", Json()) != kFormat) {
    refuse(where, "what --store writes is expected");
  }
  for (const char* const group : {"sweeps", "walks"}) {
    const Json rows = stored.value(group, Json());
    if (!rows.is_object()) refuse(where, fmt::format("\"{}\" is no object", group));
    for (const auto& [name, row] : rows.items()) {
      if (!row.is_object()) {
        refuse(where, fmt::format("\"{}\", \"{}\" is no object", group, printable(name)));
      }
    }
  }
  return stored;
}

void expect_terms(const Json& stored, const Json& terms, std::string_view where) {
  for (const auto& [key, value] : terms.items()) {
    const Json before = stored.value(key, Json());
    if (before == value) continue;
    refuse(where, fmt::format("was stored with {} {}, not {}", key, printable(before.dump()),
                              value.dump()));
  }
}

std::size_t stored_step(const Sweep& sweep, const Json& cell, const auto& refuse_cell) {
  if (cell.is_null()) return sweep.values.size();
  if (!cell.is_number()) refuse_cell("a value of the sweep or null");
  const auto at = std::ranges::find(sweep.values, cell.get<double>());
  if (at == sweep.values.end()) refuse_cell("a value of the sweep or null");
  return at - sweep.values.begin();
}

/// What a row, one of a sweep or a walk, stores of the plan's subjects.
void read_row(const StressPlan& plan, const Json& rows, const Unit& of, std::string_view where,
              std::vector<StoredPoint>& points) {
  const std::string name(of.name());
  const Json row = rows.value(name, Json::object());
  for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
    const auto cell = row.find(plan.subjects[i].name);
    if (cell == row.end()) continue;
    const auto refuse_cell = [&](std::string_view expected) {
      refuse(where, fmt::format("{}, {}: {} is expected, not {}", name, printable(cell.key()),
                                expected, printable(cell->dump())));
    };
    StoredPoint point{of, i};
    if (of.sweep != nullptr) {
      point.unit.step = stored_step(*of.sweep, *cell, refuse_cell);
    } else {
      if (!cell->is_number_unsigned()) refuse_cell("a number of faults");
      point.faults = cell->get<std::uint64_t>();
    }
    points.push_back(point);
  }
}

}  // namespace

std::vector<StoredPoint> read_breaking_points(const std::string& path, const StressPlan& plan) {
  const std::string where = where_of("--baseline", path);
  const Json stored = parsed(path, where);
  std::vector<StoredPoint> points;
  for (const Sweep* const sweep : plan.sweeps) {
    read_row(plan, stored["sweeps"], {.sweep = sweep}, where, points);
  }
  const std::size_t of_sweeps = points.size();
  for (const Walk* const walk : plan.walks) {
    read_row(plan, stored["walks"], {.walk = walk}, where, points);
  }
  if (points.empty()) refuse(where, "nothing is stored of what is to be run");
  expect_terms(stored, terms_of(plan, of_sweeps > 0, points.size() > of_sweeps), where);
  return points;
}

Comparison compare(const StressPlan& plan, const StressResult& result,
                   const std::vector<StoredPoint>& stored) {
  Comparison comparison;
  for (const StoredPoint& before : stored) {
    const std::string& who = plan.subjects[before.subject].name;
    const std::string_view name = before.unit.name();
    if (before.unit.sweep != nullptr) {
      const Sweep& sweep = *before.unit.sweep;
      const std::size_t step = before.unit.step;
      const auto steps = result.steps(sweep, before.subject);
      const std::size_t now = breaking_step(steps).value_or(sweep.values.size());
      if (now < step) {
        comparison.worse.push_back(fmt::format("{}: {} breaks {}, stored: {}", name, who,
                                               in_words(sweep, now), in_words(sweep, step)));
      } else if (steps.size() < step) {
        comparison.not_compared.push_back(
            fmt::format("{}: {}: {} of {} steps", name, who, steps.size(), sweep.values.size()));
      }
      continue;
    }
    const StepStatistics* const tally = result.walk(*before.unit.walk, before.subject);
    if (tally == nullptr) {
      comparison.not_compared.push_back(fmt::format("{}: {}", name, who));
    } else if (faults_of(*tally) > before.faults) {
      comparison.worse.push_back(fmt::format("{}: {} has {} faults, stored: {}", name, who,
                                             faults_of(*tally), before.faults));
    }
  }
  return comparison;
}

Json stored_before(const std::string& path, const StressPlan& plan) {
  if (!std::filesystem::is_regular_file(path)) return {};
  const std::string where = where_of("--store", path);
  Json stored = parsed(path, where);
  const auto has_both = [&stored](const char* group, bool has_now) {
    return has_now && !stored[group].empty();
  };
  expect_terms(stored,
               terms_of(plan, has_both("sweeps", !plan.sweeps.empty()),
                        has_both("walks", !plan.walks.empty())),
               where);
  return stored;
}

Json breaking_points_json(const StressPlan& plan, const StressResult& result, Json before) {
  Json json = std::move(before);
  json["format"] = kFormat;
  json.update(terms_of(plan, !plan.sweeps.empty(), !plan.walks.empty()));
  for (const char* const group : {"sweeps", "walks"}) json.emplace(group, Json::object());
  for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
    const std::string& name = plan.subjects[i].name;
    if (name == kIdealName) continue;
    for (const Sweep* const sweep : plan.sweeps) {
      if (plan.subjects[i].walks_only) break;
      const auto step = breaking_step(result.steps(*sweep, i));
      json["sweeps"][std::string(sweep->name)][name] = step ? Json(sweep->values[*step]) : Json();
    }
    for (const Walk* const walk : plan.walks) {
      const StepStatistics* const tally = result.walk(*walk, i);
      if (tally != nullptr) json["walks"][std::string(walk->name)][name] = faults_of(*tally);
    }
  }
  return json;
}

}  // namespace manifuzz
