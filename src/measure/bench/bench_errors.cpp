#include "measure/bench/bench_errors.hpp"

#include "measure/error_statistics.hpp"

namespace manifuzz {
namespace {

struct Measurement {
  Collider collider;
  ErrorCollector counts{ErrorCollector::Errors::counted};
  ErrorList of_extent{};
};

void measure(Measurement& subject, std::uint64_t index, Referee& referee) {
  const Declaration& declaration = subject.collider.declaration;
  const PairCase& pair = referee.truth().pair();
  const Answer answer = referee.completed(declaration, subject.collider.collide(pair));
  const Measured measured = referee.measure(declaration, answer);
  subject.counts.add(index, measured);
  if (!measured.has_errors) return;
  constexpr double unit = 0x1p-24;
  const double length = unit * referee.truth().extent();
  const ManifoldError& error = measured.error;
  subject.of_extent.add(index,
                        {error.normal / unit, error.position / length, error.depth / length});
}

BenchErrors errors_of(const Measurement& subject, std::span<const PairCase> pairs) {
  const ErrorStatistics counts = subject.counts.statistics();
  BenchErrors errors{.of_extent = subject.of_extent.spreads(),
                     .worst = {},
                     .missed = counts.missed,
                     .phantom = counts.phantom,
                     .cases = counts.cases - counts.unsupported - counts.lost};
  const ErrorSpreads& spreads = errors.of_extent;
  if (counts.contacts == 0) return errors;
  for (const Spread* spread : {&spreads.depth, &spreads.position, &spreads.normal}) {
    errors.worst.emplace(spread->worst, pairs[spread->worst]);
  }
  return errors;
}

}  // namespace

std::map<std::string, BenchErrors> measure_errors(const std::vector<BenchSubject>& subjects,
                                                  std::span<const PairCase> pairs) {
  std::map<std::string, Measurement> measurements;
  for (const BenchSubject& subject : subjects) {
    if (subject.collider && !measurements.contains(subject.name)) {
      measurements.emplace(subject.name, Measurement{subject.collider()});
    }
  }
  for (std::uint64_t i = 0; i < pairs.size(); ++i) {
    Referee referee(pairs[i]);
    for (auto& [name, subject] : measurements) measure(subject, i, referee);
  }
  std::map<std::string, BenchErrors> errors;
  for (const auto& [name, subject] : measurements) errors[name] = errors_of(subject, pairs);
  return errors;
}

}  // namespace manifuzz
