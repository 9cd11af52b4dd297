#pragma once

#include <functional>
#include <map>

#include "hunting/archive.hpp"

namespace manifuzz {

/// The cases of the greatest values of each gauge, which an archive holds: of each value the first.
class Elite {
 public:
  explicit Elite(Aim aim) : aim_(std::move(aim)) {}

  /// Takes in a case that the archive was given, where it may have taken an entry; `pair_of` makes
  /// the case if it is kept and has none. Its entry now, if any.
  template <class PairOf>
  std::optional<EntryId> add(const Observation& observed, std::optional<EntryId> entry,
                             Archive& archive, const PairOf& pair_of) {
    for (std::size_t gauge = 0; gauge < aim_.gauges; ++gauge) {
      if (!takes(gauge, observed)) continue;
      if (!entry) entry = archive.put(pair_of(), observed, aim_.value(observed));
      keep(gauge, observed, *entry, archive);
    }
    return entry;
  }

  /// The cases of each gauge that has any, the greatest first. A collider that is right has no
  /// errors, so the gauge of errors has no cases.
  std::vector<std::vector<EntryId>> by_gauge() const;
  bool is_empty() const;

 private:
  bool takes(std::size_t gauge, const Observation& observed) const;
  void keep(std::size_t gauge, const Observation& observed, EntryId entry, Archive& archive);

  Aim aim_;
  std::array<std::multimap<double, EntryId, std::greater<>>, kGaugesMost> of_gauges_;
};

}  // namespace manifuzz
