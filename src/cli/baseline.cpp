#include "cli/baseline.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "cases/file.hpp"
#include "cases/user_error.hpp"

namespace manifuzz {
namespace {

constexpr double kWorseFrom = 1.1;

struct Part {
  std::string_view name;
  std::vector<std::string> Comparison::*buckets;
};
constexpr std::array kParts{Part{"new", &Comparison::appeared}, Part{"worse", &Comparison::worse},
                            Part{"still", &Comparison::still}, Part{"gone", &Comparison::gone}};

/// JSON has no infinity: null stands for it.
double magnitude_of(const nlohmann::ordered_json& bucket) {
  const auto& magnitude = bucket.at("magnitude");
  return magnitude.is_null() ? std::numeric_limits<double>::infinity() : magnitude.get<double>();
}

}  // namespace

nlohmann::ordered_json terms_in(const nlohmann::ordered_json& report) {
  nlohmann::ordered_json terms;
  for (const char* const key : {"oracle", "seed", "first", "cases"}) {
    terms[key] = report.value(key, nlohmann::ordered_json());
  }
  terms["regimes"] = nlohmann::ordered_json();
  if (!report.contains("regimes")) return terms;
  for (const auto& regime : report.at("regimes")) terms["regimes"].push_back(regime.at("name"));
  return terms;
}

EarlierRun read_baseline(const std::string& path) {
  InputFile file(path);
  EarlierRun earlier;
  try {
    const auto report = nlohmann::ordered_json::parse(file.read_all());
    for (const auto& bucket :
         report.at("buckets").get_ref<const nlohmann::ordered_json::array_t&>()) {
      earlier.buckets.push_back({bucket.at("bucket").get<std::string>(), magnitude_of(bucket)});
    }
    earlier.terms = terms_in(report);
  } catch (const nlohmann::json::exception&) {
    throw UserError(
        fmt::format("--baseline: {}: what fuzz --json writes is expected", file.name()));
  }
  return earlier;
}

std::string differences_in_words(const nlohmann::ordered_json& earlier,
                                 const nlohmann::ordered_json& now) {
  std::string text;
  for (const auto& [key, value] : now.items()) {
    const auto& before = earlier.at(key);
    if (before == value) continue;
    const std::string pair =
        value.is_array() ? key : fmt::format("{} ({}, now {})", key, before.dump(), value.dump());
    text += text.empty() ? pair : ", " + pair;
  }
  if (text.empty()) return text;
  return fmt::format("the baseline differs in {}: what is new or gone may be due to that\n", text);
}

Comparison compared(const std::vector<EarlierBucket>& earlier, const std::vector<Finding>& now) {
  Comparison comparison;
  for (const Finding& finding : now) {
    const std::string name = to_string(finding.bucket);
    const auto before = std::ranges::find(earlier, name, &EarlierBucket::bucket);
    if (before == earlier.end()) {
      comparison.appeared.push_back(name);
    } else if (finding.tally.magnitude > kWorseFrom * before->magnitude) {
      comparison.worse.push_back(name);
    } else {
      comparison.still.push_back(name);
    }
  }
  for (const EarlierBucket& before : earlier) {
    const bool is_there = std::ranges::any_of(
        now, [&](const Finding& finding) { return to_string(finding.bucket) == before.bucket; });
    if (!is_there) comparison.gone.push_back(before.bucket);
  }
  return comparison;
}

std::string comparison_rows(const Comparison& comparison) {
  std::string text = "against the baseline\n";
  for (const Part& part : kParts) {
    const auto& buckets = comparison.*part.buckets;
    text += fmt::format("{:<18}{:>14}\n", part.name, buckets.size());
    if (part.name == "still") continue;
    for (const std::string& bucket : buckets) text += fmt::format("  {}\n", bucket);
  }
  return text;
}

nlohmann::ordered_json comparison_json(const Comparison& comparison) {
  nlohmann::ordered_json json;
  for (const Part& part : kParts) json[std::string(part.name)] = comparison.*part.buckets;
  return json;
}

}  // namespace manifuzz
