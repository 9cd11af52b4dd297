#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hunting/hunted_pairs.hpp"
#include "properties/properties.hpp"

namespace manifuzz {

static_assert(kPropertyCount <= kGaugesMost);

/// What a hunt met of one property. The measure of a failure is 1 and its magnitude, that of a case
/// on which the property holds the share of its bound that it takes.
struct HuntedProperty {
  const Property* property = nullptr;
  std::uint64_t cases = 0;            ///< that it was asked of
  std::uint64_t applied = 0;          ///< of these, those to which it applies
  std::optional<CaseNumber> first{};  ///< on which it fails
  double worst = 0;                   ///< the greatest measure
  /// The case of the worst failure, the first of equals; none: it holds of all.
  std::optional<PairCase> failing{};
  CaseNumber failing_number = 0;
};

/// The measure of an outcome; 0 where it has none.
double measure_of(const PropertyOutcome& outcome);

/// The cases of a hunt, of which properties are asked: a gauge for each, by its place in the list.
class PropertyChecks : public HuntedPairs {
 public:
  /// The plan's subject is asked about cases of the plan's regimes, and of what is bred from them.
  PropertyChecks(const std::vector<const Property*>& properties, const Plan& plan);

  std::function<void()> block_runner(const Plan& plan, CampaignRun& run,
                                     CampaignJob& job) const override;

  /// Takes what became of the generation; `part` is the run of it.
  void end_checks(const Plan& plan, const JobsResult& part);

  const std::vector<HuntedProperty>& hunted() const { return hunted_; }

 private:
  struct OneCheck {
    PropertyOutcome::Kind kind = PropertyOutcome::Kind::not_applicable;
    double measure = 0;
  };
  /// How far the job came that was at a case; plain data, for shared memory.
  struct CheckedCase {
    bool is_begun = false;
    std::size_t done = 0;  ///< so many properties, in their order
    std::array<OneCheck, kPropertyCount> checks{};
  };

  void run_case(const Plan& plan, const Collider& subject, CampaignRun& run,
                CampaignJob& job) const;
  void add_check(const Plan& plan, CaseNumber number, std::size_t k, const OneCheck& check);

  std::vector<HuntedProperty> hunted_;
  Shared<CheckedCase> checked_;
};

}  // namespace manifuzz
