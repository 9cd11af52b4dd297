#include "measure/spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

/// The value that so large a share of all values does not exceed; reorders them.
float quantile(std::vector<float>& values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

float to_float(double value) {
  constexpr float most = std::numeric_limits<float>::max();
  return value < static_cast<double>(most) ? static_cast<float>(value) : most;
}

Spread spread_of(std::vector<float> values, std::span<const std::uint64_t> cases) {
  if (values.empty()) return {};
  const auto largest = std::ranges::max_element(values);
  const std::uint64_t worst = cases[static_cast<std::size_t>(largest - values.begin())];
  const float max = *largest;
  return {
      .median = quantile(values, 0.5), .p999 = quantile(values, 0.999), .max = max, .worst = worst};
}

void ErrorList::add(std::uint64_t index, const ManifoldError& error) {
  cases_.push_back(index);
  depth_.push_back(to_float(error.depth));
  position_.push_back(to_float(error.position));
  normal_.push_back(to_float(error.normal));
}

ErrorSpreads ErrorList::spreads() const {
  return {spread_of(depth_, cases_), spread_of(position_, cases_), spread_of(normal_, cases_)};
}

std::string spread_csv(const Spread& spread) {
  return fmt::format(",{},{},{}", static_cast<float>(spread.median),
                     static_cast<float>(spread.p999), static_cast<float>(spread.max));
}

Json spread_json(const Spread& spread) {
  return {{"median", spread.median}, {"p999", spread.p999}, {"max", spread.max}};
}

Json spreads_json(const ErrorSpreads& spreads,
                  const std::function<void(Json& json, const Spread& spread)>& add_worst) {
  const auto json = [&add_worst](const Spread& spread) {
    Json figures = spread_json(spread);
    if (add_worst) add_worst(figures, spread);
    return figures;
  };
  return {{"depth", json(spreads.depth)},
          {"position", json(spreads.position)},
          {"normal", json(spreads.normal)}};
}

}  // namespace manifuzz
