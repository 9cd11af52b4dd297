#include "measure/bench/bench.hpp"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "exact/curve.hpp"
#include "kernel/target.hpp"

namespace manifuzz {
namespace {

/// Cases drawn for each that is wanted, before the regime is given up.
constexpr std::size_t kDrawsMax = 400;

/// Pairs a workload: what each takes in all fits the first cache, the second, or neither.
constexpr std::size_t kPairsInL1 = 64;
constexpr std::size_t kPairsInL2 = 1024;
constexpr std::size_t kPairsInMemory = 65'536;

bool fits(const PairCase& pair, const std::optional<int>& vertices) {
  return !vertices || (pair.a.polygon.count == *vertices && pair.b.polygon.count == *vertices);
}

}  // namespace

WorkloadSpec usual_workload() {
  return {find_regime("generic"), {}, 0.5, kPairsInL2};
}

std::vector<WorkloadSpec> all_workloads(std::span<const Regime* const> regimes) {
  const WorkloadSpec usual = usual_workload();
  std::vector<WorkloadSpec> specs{usual};
  const auto add = [&](auto WorkloadSpec::*figure, const auto& value) {
    specs.push_back(usual);
    specs.back().*figure = value;
  };
  for (const int vertices : {3, 4, 6, 8}) add(&WorkloadSpec::vertices, vertices);
  for (const double touching : {0.0, 0.1, 1.0}) add(&WorkloadSpec::touching, touching);
  for (const std::size_t pairs : {kPairsInL1, kPairsInMemory}) add(&WorkloadSpec::pairs, pairs);
  for (const Regime* const regime : regimes) {
    if (regime != usual.regime) add(&WorkloadSpec::regime, regime);
    if (regime->name == "circles") {  // with circles alone, which the kernel takes in lanes
      add(&WorkloadSpec::regime, regime);
      specs.back().vertices = 1;
    }
  }
  return specs;
}

std::optional<std::vector<PairCase>> draw_workload(
    const WorkloadSpec& spec, std::uint64_t seed,
    const std::function<bool(const PairCase&)>& takes) {
  GenerationContext context;
  if (spec.regime->is_round) {
    context.takes = takes;
  } else {
    context.radius = 0.0F;
  }
  const auto is_taken = [&](const PairCase& pair) { return !context.takes || context.takes(pair); };
  // Many cases are drawn before one is given that is not taken.
  if (!is_taken(generate(seed, *spec.regime, 0, context))) return std::nullopt;
  std::vector<PairCase> pairs;
  const double touching = static_cast<double>(spec.pairs) * spec.touching;
  std::size_t touching_left = static_cast<std::size_t>(std::llround(touching));
  std::size_t apart_left = spec.pairs - touching_left;
  for (std::uint64_t i = 0; touching_left + apart_left > 0; ++i) {
    if (i >= kDrawsMax * spec.pairs) return std::nullopt;
    PairCase pair = generate(seed, *spec.regime, i, context);
    if (!fits(pair, spec.vertices) || !is_taken(pair)) continue;
    const double overlap = total_radius(pair) - exact::separation_of(exact::Truth(pair));
    const bool touches = overlap >= 0;
    const double share = overlap / size(pair);
    if (touches && (share < spec.overlap[0] || share >= spec.overlap[1])) continue;
    std::size_t& left = touches ? touching_left : apart_left;
    if (left == 0) continue;
    --left;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

namespace {

/// Keeps the time of every repetition and prints nothing.
class Collecting : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      seconds_[run.run_name.function_name].push_back(run.cpu_accumulated_time /
                                                     static_cast<double>(run.iterations));
    }
  }
  const std::vector<double>& seconds(const std::string& name) const { return seconds_.at(name); }

 private:
  std::map<std::string, std::vector<double>> seconds_;
};

void initialize(const TimingOptions& options) {
  // Each flag that the environment could set otherwise.
  std::array<std::string, 8> words{
      "manifuzz",
      "--benchmark_enable_random_interleaving=true",
      "--benchmark_filter=.",
      "--benchmark_report_aggregates_only=false",
      "--benchmark_list_tests=false",
      "--benchmark_out=",
      fmt::format("--benchmark_repetitions={}", options.repetitions),
      fmt::format("--benchmark_min_time={}", options.repetition_seconds)};
  std::array<char*, 8> arguments{};
  std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
}

/// The median of what `combined` makes of each repetition and of the other's of its number.
template <class Combine>
double median_of(const std::vector<double>& seconds, const std::vector<double>& of_other,
                 const Combine& combined) {
  std::vector<double> all(std::min(seconds.size(), of_other.size()));
  std::ranges::transform(seconds, of_other, all.begin(), combined);
  return median(all);
}

void register_subject(const std::string& name, const BenchSubject& subject,
                      std::span<const PairCase> pairs) {
  const auto pass = subject.prepare(pairs);
  const std::string target = subject.target;
  benchmark::RegisterBenchmark(name.c_str(), [pass, target](benchmark::State& state) {
    if (!target.empty()) kernel::use_target(target);
    for ([[maybe_unused]] const auto once : state) pass();
  });
}

}  // namespace

std::vector<Timing> time_subjects(const std::vector<BenchSubject>& subjects,
                                  std::span<const PairCase> pairs, const TimingOptions& options) {
  initialize(options);
  const auto name_of = [](std::size_t i) { return fmt::format("subject {}", i); };
  const auto index_of = [&](std::string_view name) {
    const auto found = std::ranges::find(subjects, name, &BenchSubject::name);
    return static_cast<std::size_t>(found - subjects.begin());
  };
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    register_subject(name_of(i), subjects[i], pairs);
  }
  assert(index_of(kRatioBase) < subjects.size());
  Collecting collected;
  benchmark::RunSpecifiedBenchmarks(&collected);
  benchmark::ClearRegisteredBenchmarks();
  kernel::use_target(kernel::targets().front());

  std::vector<Timing> timings;
  const std::vector<double>& of_base = collected.seconds(name_of(index_of(kRatioBase)));
  const double ns_per_second = 1e9 / static_cast<double>(pairs.size());
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const std::vector<double>& seconds = collected.seconds(name_of(i));
    Timing timing{ns_per_second * median(seconds), median_of(of_base, seconds, std::divides<>())};
    if (subjects[i].is_library) {
      const std::vector<double>& empty = collected.seconds(name_of(index_of(kInterface)));
      timing.ns_without_interface = ns_per_second * median_of(seconds, empty, std::minus<>());
    }
    timings.push_back(timing);
  }
  return timings;
}

namespace {

struct Measurement {
  Collider collider;
  ErrorCollector counts{ErrorCollector::Errors::counted};
  ErrorList of_extent{};
};

void measure(Measurement& subject, std::uint64_t index, Referee& referee) {
  const Declaration& declaration = subject.collider.declaration;
  const PairCase& pair = referee.truth().pair();
  const Answer answer = referee.whole(declaration, subject.collider.collide(pair));
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

namespace {

/// Whether it is timed over a workload: of polygons always, of round shapes where it takes all.
bool takes_all(const BenchSubject& subject, const WorkloadSpec& spec,
               std::span<const PairCase> pairs) {
  if (!spec.regime->is_round || subject.name == kInterface) return true;
  if (!subject.collider) return false;
  const Collider collider = subject.collider();
  return std::ranges::all_of(pairs, [&](const PairCase& pair) { return takes(collider, pair); });
}

}  // namespace

BenchOptions quick_bench() {
  return {.judged = 5'000, .timing = {.repetitions = 7, .repetition_seconds = 0.01}};
}

std::vector<BenchRow> run_bench(const std::vector<BenchSubject>& subjects,
                                const std::vector<WorkloadSpec>& workloads,
                                const BenchOptions& options,
                                const std::function<void(std::size_t)>& on_workload) {
  const auto base = std::ranges::find(subjects, kRatioBase, &BenchSubject::name);
  const Collider of_base = base->collider();
  const auto by_base = [&](const PairCase& pair) { return takes(of_base, pair); };
  std::vector<BenchRow> rows;
  for (std::size_t w = 0; w < workloads.size(); ++w) {
    on_workload(w);
    const auto timed = draw_workload(workloads[w], options.seed, by_base);
    WorkloadSpec judged_spec = workloads[w];
    judged_spec.pairs = options.judged;
    const auto judged = draw_workload(judged_spec, options.seed, by_base);
    if (!timed || !judged) continue;
    std::vector<BenchSubject> taking;
    std::ranges::copy_if(subjects, std::back_inserter(taking), [&](const BenchSubject& subject) {
      return takes_all(subject, workloads[w], *timed);
    });
    const std::vector<Timing> timings = time_subjects(taking, *timed, options.timing);
    const auto errors = measure_errors(taking, *judged);
    for (std::size_t i = 0; i < taking.size(); ++i) {
      BenchRow row{taking[i], w, workloads[w], timings[i], {}};
      if (taking[i].collider) row.errors = errors.at(taking[i].name);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace manifuzz
