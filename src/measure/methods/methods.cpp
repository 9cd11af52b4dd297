#include "measure/methods/methods.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "measure/methods/method_errors.hpp"
#include "own_colliders/own_colliders.hpp"
#include "sequence/motions.hpp"

namespace manifuzz {
namespace {

/// The kernel of the widest instruction set, which comes first.
MethodSubject of_bench(std::string method, const std::string& name) {
  static const std::vector<BenchSubject> all = own_subjects();
  return {std::move(method), *std::ranges::find(all, name, &BenchSubject::name)};
}

MethodSubject keeper(std::string name, SequenceCollider (*make)()) {
  return {"points kept", {.name = std::move(name)}, make};
}

struct Workload {
  std::string depths;
  WorkloadSpec spec;
};

std::vector<Workload> pair_workloads() {
  const WorkloadSpec usual = usual_workload();
  std::vector<Workload> all{{"mixed", usual}};
  for (const int vertices : {3, 4, 6, 8}) {
    all.push_back({"mixed", usual});
    all.back().spec.vertices = vertices;
  }
  const auto add = [&](std::string depths, double touching, std::array<double, 2> overlap) {
    all.push_back({std::move(depths), usual});
    all.back().spec.touching = touching;
    all.back().spec.overlap = overlap;
  };
  add("apart", 0, usual.overlap);
  add("shallow", 1, {0, kShallow});
  add("deep", 1, {kShallow, usual.overlap[1]});
  return all;
}

/// The frames of many sequences, one after the other.
struct Frames {
  std::vector<PairCase> pairs;
  std::vector<std::size_t> starts;  ///< of each sequence
};

bool are_sharp_polygons(const Sequence& sequence) {
  const auto is_sharp = [](const ConvexPolygon<float>& shape) {
    return shape.count >= kMinVertices && !shape.is_round() && shape.radius == 0;
  };
  return is_sharp(sequence.a) && is_sharp(sequence.b);
}

Frames draw_frames(std::uint64_t seed, std::size_t of_each) {
  Frames frames;
  for (const Motion& motion : motions()) {
    for (std::size_t i = 0; i < of_each; ++i) {
      const Sequence sequence = draw_sequence(seed, motion, i);
      if (!are_sharp_polygons(sequence)) continue;
      frames.starts.push_back(frames.pairs.size());
      for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
        frames.pairs.push_back(sequence.at(k));
      }
    }
  }
  return frames;
}

/// Pairs that have nothing to do with each other.
Frames apart(std::vector<PairCase> pairs) {
  Frames frames;
  frames.starts.resize(pairs.size());
  std::iota(frames.starts.begin(), frames.starts.end(), std::size_t(0));
  frames.pairs = std::move(pairs);
  return frames;
}

/// Asks a keeper for frame after frame; what it keeps of each sequence lasts from pass to pass.
std::function<void()> pass_of_keeper(const SequenceCollider& keeper, const Frames& frames) {
  using Ask = std::function<KeptAnswer(const PairCase&)>;
  const auto asks = std::make_shared<std::vector<Ask>>();
  for (std::size_t i = 0; i < frames.starts.size(); ++i) asks->push_back(keeper.begin());
  return [&frames, asks, said = std::make_shared<KeptAnswer>()] {
    std::size_t sequence = 0;
    for (std::size_t i = 0; i < frames.pairs.size(); ++i) {
      if (sequence < frames.starts.size() && frames.starts[sequence] == i) ++sequence;
      *said = (*asks)[sequence - 1](frames.pairs[i]);
    }
  };
}

/// The subjects that can be timed over these frames, and their times by the subjects' indices.
std::vector<std::optional<Timing>> time_methods(const std::vector<MethodSubject>& subjects,
                                                const Frames& frames,
                                                const TimingOptions& options) {
  std::vector<BenchSubject> timed;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    BenchSubject subject = subjects[i].bench;
    if (subjects[i].keeper) {
      const SequenceCollider keeper = subjects[i].keeper();
      subject.prepare = [keeper, &frames](std::span<const PairCase>) {
        return pass_of_keeper(keeper, frames);
      };
    }
    if (!subject.prepare) continue;
    timed.push_back(std::move(subject));
    index.push_back(i);
  }
  std::vector<std::optional<Timing>> timings(subjects.size());
  const auto measured = time_subjects(timed, frames.pairs, options);
  for (std::size_t k = 0; k < index.size(); ++k) timings[index[k]] = measured[k];
  return timings;
}

/// What one subject says of frame after frame.
class Asking {
 public:
  explicit Asking(const MethodSubject& subject) {
    if (subject.keeper) {
      keeper_ = subject.keeper();
    } else {
      collider_ = subject.bench.collider();
    }
  }

  const Declaration& declaration() const {
    return keeper_ ? keeper_->declaration : collider_->declaration;
  }
  TouchingPoints ask(const PairCase& pair, bool is_start) {
    if (!keeper_) return touching_points(collider_->collide(pair));
    if (is_start) frame_after_frame_ = keeper_->begin();
    return touching_points(pair, frame_after_frame_(pair));
  }

 private:
  std::optional<Collider> collider_;
  std::optional<SequenceCollider> keeper_;
  std::function<KeptAnswer(const PairCase&)> frame_after_frame_;
};

std::vector<MethodCollector> collect(const std::vector<MethodSubject>& subjects,
                                     const Frames& frames) {
  std::vector<Asking> asking(subjects.begin(), subjects.end());
  std::vector<MethodCollector> collectors(subjects.size());
  std::size_t sequence = 0;
  for (std::size_t i = 0; i < frames.pairs.size(); ++i) {
    const bool is_start = sequence < frames.starts.size() && frames.starts[sequence] == i;
    if (is_start) ++sequence;
    const TrueContact truth(frames.pairs[i]);
    for (std::size_t k = 0; k < subjects.size(); ++k) {
      collectors[k].add(i, truth, asking[k].declaration(), asking[k].ask(frames.pairs[i], is_start),
                        is_start);
    }
  }
  return collectors;
}

}  // namespace

std::vector<MethodSubject> own_methods() {
  return {of_bench("clipping", "clip"),
          of_bench("clipping", "pair"),
          of_bench("separating axes", "sat"),
          of_bench("closest points", "gjk"),
          of_bench("closest points", "gjk+hint"),
          of_bench("of shrunk shapes", "gjk-shrunk"),
          of_bench("GJK, then clipping", "gjk-clip"),
          keeper("cached", make_cached),
          keeper("cached-bullet", make_cached_bullet),
          of_bench("perturbed", "perturbed")};
}

std::size_t method_workload_count() {
  return pair_workloads().size() + 1;
}

std::vector<MethodRow> run_methods(const std::vector<MethodSubject>& subjects,
                                   const MethodsOptions& options,
                                   const std::function<void(std::size_t)>& on_workload) {
  std::vector<MethodRow> rows;
  const auto add = [&](const Workload& workload, const Frames& timed, const Frames& judged) {
    const auto timings = time_methods(subjects, timed, options.timing);
    const auto collectors = collect(subjects, judged);
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      MethodRow row{subjects[i].method, subjects[i].bench,      workload.depths, workload.spec,
                    timings[i],         collectors[i].errors(), std::nullopt};
      if (workload.depths == "frames") row.frames = collectors[i].frames();
      rows.push_back(std::move(row));
    }
  };
  const auto workloads = pair_workloads();
  for (std::size_t w = 0; w < workloads.size(); ++w) {
    on_workload(w);
    WorkloadSpec judged_spec = workloads[w].spec;
    judged_spec.pairs = options.judged;
    auto timed = draw_workload(workloads[w].spec, options.seed);
    auto judged = draw_workload(judged_spec, options.seed);
    if (!timed || !judged) continue;
    add(workloads[w], apart(std::move(*timed)), apart(std::move(*judged)));
  }
  on_workload(workloads.size());
  const Frames frames = draw_frames(options.seed, options.sequences);
  add({"frames", usual_workload()}, frames, frames);
  return rows;
}

}  // namespace manifuzz
