#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "measure/referee.hpp"

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

namespace {

/// The count of each assessment, in their order; what is right is not counted.
constexpr std::array<std::uint64_t ErrorStatistics::*, 8> kCounts{
    &ErrorStatistics::unsupported, &ErrorStatistics::ill_posed, nullptr,
    &ErrorStatistics::missed,      &ErrorStatistics::phantom,   &ErrorStatistics::gross,
    &ErrorStatistics::wrong_count, &ErrorStatistics::lost};

}  // namespace

void ErrorCollector::add(std::uint64_t index, const Measured& measured) {
  ++counts_.cases;
  const auto count = kCounts[static_cast<std::size_t>(measured.assessment)];
  if (count != nullptr) ++(counts_.*count);
  const bool is_first = is_wrong(measured.assessment) && counts_.wrong() == 1;
  if (is_first || (is_wrong(measured.assessment) && measured.wrongness > counts_.wrongness)) {
    counts_.wrongness = measured.wrongness;
    counts_.worst_wrong = index;
  }
  if (!measured.has_errors) return;
  ++counts_.contacts;
  if (errors_ == Errors::counted) return;
  of_size_.add(index, measured.of_size);
  of_bound_.add(index, measured.of_bound);
  of_extent_.push_back(to_float(measured.of_extent));
}

ErrorStatistics ErrorCollector::statistics() const {
  ErrorStatistics statistics = counts_;
  statistics.of_size = of_size_.spreads();
  statistics.of_bound = of_bound_.spreads();
  statistics.of_extent = spread_of(of_extent_, of_size_.cases());
  return statistics;
}

}  // namespace manifuzz
