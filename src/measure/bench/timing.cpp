#include "measure/bench/timing.hpp"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <cassert>
#include <map>

#include <fmt/format.h>

#include "kernel/target.hpp"
#include "measure/spread.hpp"

namespace manifuzz {
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

}  // namespace

std::vector<Timing> time_subjects(const std::vector<BenchSubject>& subjects,
                                  const Workload& workload, const TimingOptions& options) {
  initialize(options);
  const auto name_of = [](std::size_t i) { return fmt::format("subject {}", i); };
  std::size_t base = subjects.size();
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    if (subjects[i].name == kRatioBase) base = i;
    const auto pass = subjects[i].prepare(workload.pairs);
    const std::string target = subjects[i].target;
    benchmark::RegisterBenchmark(name_of(i).c_str(), [pass, target](benchmark::State& state) {
      if (!target.empty()) kernel::use_target(target);
      for ([[maybe_unused]] const auto once : state) pass();
    });
  }
  assert(base < subjects.size());
  Collecting collected;
  benchmark::RunSpecifiedBenchmarks(&collected);
  benchmark::ClearRegisteredBenchmarks();
  kernel::use_target(kernel::targets().front());

  std::vector<Timing> timings;
  const std::vector<double>& of_base = collected.seconds(name_of(base));
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const std::vector<double>& seconds = collected.seconds(name_of(i));
    std::vector<double> ratios(std::min(seconds.size(), of_base.size()));
    for (std::size_t k = 0; k < ratios.size(); ++k) ratios[k] = of_base[k] / seconds[k];
    timings.push_back(
        {1e9 * median(seconds) / static_cast<double>(workload.pairs.size()), median(ratios)});
  }
  return timings;
}

}  // namespace manifuzz
