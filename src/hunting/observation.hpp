#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "campaign/pairs/pair_work.hpp"
#include "hunting/conditions.hpp"

namespace manifuzz {

/// What a hunt looks for the greatest of.
enum class Measure {
  error,        ///< of the subject's wrong answers, a share of the size
  bound_share,  ///< of right answers: the share of its bound that any of their errors takes
  missed,       ///< depth of contacts and points that it missed, a share of the size
};
inline constexpr std::array<std::string_view, 3> kMeasureNames{"error", "bound_share", "missed"};

/// A figure of a case of which the greatest are kept: the measures, the share of a bound once for
/// each bound.
enum class Gauge { error, missed, normal_share, position_share, depth_share };
inline constexpr std::array<std::string_view, 5> kGaugeNames{
    "error", "missed", "bound_share.normal", "bound_share.position", "bound_share.depth"};
inline constexpr std::size_t kGauges = kGaugeNames.size();

/// An observation has room for so many gauges, whatever they gauge.
inline constexpr std::size_t kGaugesMost = 24;

Measure measure_of(Gauge gauge);

/// What became of a case: plain data, for shared memory.
struct Observation {
  bool is_there = false;       ///< it was run
  bool is_well_posed = false;  ///< the separation bound is at most 5% of the size
  Conditions conditions{};
  std::array<double, kGaugesMost> gauges{};
  /// How near a missed contact is: as small as slab margin and lead are, between 0 and 1.
  double nearness = 0;

  double operator[](Gauge gauge) const { return gauges[static_cast<std::size_t>(gauge)]; }
  double& operator[](Gauge gauge) { return gauges[static_cast<std::size_t>(gauge)]; }

  friend bool operator==(const Observation&, const Observation&) = default;
};

/// What the truth alone says of a case, for a collider of that declaration.
Observation conditions_observed(const exact::Truth& truth, const Declaration& declaration);

Observation observation_of(const JudgedPair& judged);

/// The shares of its bounds that the error of an answer takes, if it is a right one; whether it is
/// must be asked besides, but that an answer held against clips takes none where it is wrong.
Observation shares_observed(const std::shared_ptr<const exact::Truth>& truth,
                            const ColliderAnswer& given);

/// What a hunt keeps the greatest of in each cell; without a measure the error of a wrong answer,
/// before that the share of a right one's bound, a normal's in answers held against clips alone.
double value_of(const Observation& observed, const std::optional<Measure>& measure);

/// What is kept of observed cases: the greatest of which gauges, and in each cell of what.
struct Aim {
  std::size_t gauges = kGauges;  ///< the first so many are gauged
  std::function<bool(std::size_t gauge)> seeks;
  std::function<double(const Observation&)> value;
  double bred_from_greatest = 0.2;  ///< the share of cases that have one of them as a parent
};

/// At a measure of what two colliders answer; none: at all of them.
Aim aim_at(const std::optional<Measure>& measure);

}  // namespace manifuzz
