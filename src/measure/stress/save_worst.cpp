#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "campaign/pairs/recorded_case.hpp"
#include "campaign/save.hpp"
#include "engines/colliders.hpp"
#include "measure/stress/stress.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// The collider whose worst cases are kept even where it is right.
constexpr std::string_view kKeptAnyhow = "clip";

/// A case worth keeping: where it was met.
struct Witness {
  Unit unit;
  std::uint64_t index = 0;
  double badness = -1;  ///< negative: there is none

  void take(const Unit& of, std::uint64_t at, double how_bad) {
    if (how_bad > badness) *this = {of, at, how_bad};
  }
};

/// The worst of a sweep or a walk: where the subject is wrong, else where its error is largest, if
/// that is kept.
Witness worst_of(const StressResult& result, const Unit& family, std::size_t subject,
                 bool is_kept_anyhow) {
  Witness wrong;
  Witness error;
  for (std::size_t i = 0; i < result.units.size(); ++i) {
    const Unit& unit = result.units[i];
    if (unit.sweep != family.sweep || unit.walk != family.walk) continue;
    const StepStatistics& tally = result.tallies[i][subject];
    if (tally.wrong() > 0) wrong.take(unit, tally.worst_wrong, tally.wrongness);
    if (unit.walk != nullptr || tally.contacts == 0) continue;  // a walk keeps no errors
    if (tally.ill_posed > 0) continue;  // a case on which nobody can be wrong shows nothing
    for (const Spread& spread : {tally.of_size.depth, tally.of_size.position}) {
      error.take(unit, spread.worst, spread.max);
    }
  }
  return wrong.badness < 0 && is_kept_anyhow ? error : wrong;
}

std::string where(const Witness& witness, std::uint64_t seed) {
  if (witness.unit.walk != nullptr) {
    return fmt::format("stress, walk {}, seed {}, frame {}", witness.unit.walk->name, seed,
                       witness.index);
  }
  const Sweep& sweep = *witness.unit.sweep;
  return fmt::format("stress, sweep {} at {:g}, seed {}, case {}", sweep.name,
                     sweep.values[witness.unit.step], seed, witness.index);
}

/// Whether the collider is wrong, and by how much: the order in which witnesses are worse.
std::pair<bool, double> badness_of(const Collider& collider, const PairCase& pair,
                                   Interruption& interruption) {
  const Declaration& declaration = collider.declaration;
  Referee referee(pair);
  const Answer answer = referee.whole(declaration, ask_in_child(collider, pair, interruption));
  const Measured measured = referee.measure(declaration, answer);
  const bool wrong = is_wrong(measured.assessment);
  return {wrong,
          wrong ? measured.wrongness : std::max(measured.of_size.depth, measured.of_size.position)};
}

/// Whether a run before has saved a worse witness, which is then kept.
bool has_worse(const std::filesystem::path& file, const Collider& collider, const PairCase& pair,
               Interruption& interruption) {
  if (!std::filesystem::exists(file)) return false;
  const PairCase saved = read_case_file(file.string()).pair();
  return badness_of(collider, saved, interruption) > badness_of(collider, pair, interruption);
}

/// Writes it where it is a fault by the judge too, or clip's. Returns the file of a run before that
/// shows a worse one, and is kept. A collider of this repository is the subject, against Box2D; any
/// other is the oracle of clip.
std::optional<std::filesystem::path> save_witness(const StressPlan& plan, const StressSubject& of,
                                                  const Witness& witness,
                                                  const std::filesystem::path& corpus,
                                                  const std::string& name,
                                                  Interruption& interruption) {
  const bool is_kept_anyhow = of.name == kKeptAnyhow;
  const Collider subject = of.is_ours ? of.collider : make_clip();
  Collider oracle = of.is_ours ? usual_oracle() : of.collider;
  PairCase pair = case_of(plan, witness.unit, witness.index);
  Judgement judgement = judge_in_child(pair, subject, oracle, interruption);
  if (is_kept_anyhow && judgement.bucket.verdict == Verdict::ill_posed) {
    oracle = make_clip64();  // far from the origin Box2D's world frame leaves nothing to decide
    judgement = judge_in_child(pair, subject, oracle, interruption);
  }
  const bool is_fault = judgement.bucket.fault != Fault::none;
  if (!is_fault && !is_kept_anyhow) return std::nullopt;
  if (is_fault) {
    pair = shrink_finding(pair, subject, oracle, interruption).pair;
    judgement = judge_in_child(pair, subject, oracle, interruption);
  }
  const auto file = corpus / corpus_folder(pair, judgement.bucket, oracle.declaration.name) / name;
  if (has_worse(file, of.collider, pair, interruption)) return file;
  CorpusCase saved = recorded_case(pair, judgement, subject, oracle, interruption);
  saved.note += fmt::format(" {} of {}.", is_fault ? "Shrunk from the worst" : "The worst",
                            where(witness, plan.seed));
  write_file(file, format_case(saved));
  return std::nullopt;
}

}  // namespace

void save_worst(const StressPlan& plan, const StressResult& result,
                const std::filesystem::path& corpus, Interruption& interruption,
                const std::function<void(const std::string& name)>& on_file,
                const std::function<void(const std::filesystem::path& file)>& on_kept) {
  std::vector<Unit> families;
  for (const Sweep* const sweep : plan.sweeps) families.push_back({.sweep = sweep});
  for (const Walk* const walk : plan.walks) families.push_back({.walk = walk});
  for (const Unit& family : families) {
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      const StressSubject& subject = plan.subjects[i];
      if (subject.name == kIdealName || subject.walks_only) continue;
      const Witness witness = worst_of(result, family, i, subject.name == kKeptAnyhow);
      if (witness.badness < 0) continue;
      const std::string name = fmt::format("stress-{}-{}.json", family.name(), subject.name);
      on_file(name);
      const auto kept = save_witness(plan, subject, witness, corpus, name, interruption);
      if (kept) on_kept(*kept);
    }
  }
}

}  // namespace manifuzz
