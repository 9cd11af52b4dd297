#include "measure/bench/bench.hpp"

namespace manifuzz {

BenchOptions quick_bench() {
  return {.judged = 5'000, .timing = {.repetitions = 7, .repetition_seconds = 0.01}};
}

std::vector<BenchRow> run_bench(const std::vector<BenchSubject>& subjects,
                                const std::vector<WorkloadSpec>& workloads,
                                const BenchOptions& options,
                                const std::function<void(std::size_t)>& on_workload) {
  std::vector<BenchRow> rows;
  for (std::size_t w = 0; w < workloads.size(); ++w) {
    on_workload(w);
    const std::optional<Workload> timed = draw_workload(workloads[w], options.seed);
    WorkloadSpec judged_spec = workloads[w];
    judged_spec.pairs = options.judged;
    const std::optional<Workload> judged = draw_workload(judged_spec, options.seed);
    if (!timed || !judged) continue;
    const std::vector<Timing> timings = time_subjects(subjects, *timed, options.timing);
    const auto errors = measure_errors(subjects, judged->pairs);
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      BenchRow row{&subjects[i], w, workloads[w], timings[i], {}};
      if (subjects[i].collider) row.errors = errors.at(subjects[i].name);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace manifuzz
