#include "measure/error_statistics.hpp"

namespace manifuzz {
namespace {

std::uint64_t* count_of(ErrorStatistics& counts, Assessment assessment) {
  switch (assessment) {
    case Assessment::unsupported:
      return &counts.unsupported;
    case Assessment::ill_posed:
      return &counts.ill_posed;
    case Assessment::missed:
      return &counts.missed;
    case Assessment::phantom:
      return &counts.phantom;
    case Assessment::wrong_count:
      return &counts.wrong_count;
    case Assessment::gross:
      return &counts.gross;
    case Assessment::lost:
      return &counts.lost;
    case Assessment::right:
      break;
  }
  return nullptr;
}

}  // namespace

void ErrorCollector::add(std::uint64_t index, const Measured& measured) {
  ++counts_.cases;
  if (std::uint64_t* const count = count_of(counts_, measured.assessment)) ++*count;
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
