#include "cli/stress_save.hpp"

#include <optional>

#include <fmt/format.h>

#include "campaign/findings.hpp"
#include "campaign/guarded.hpp"
#include "cli/colliders.hpp"

namespace manifuzz {
namespace {

constexpr std::string_view kSteady = "clip";
constexpr std::string_view kOracle = "box2d";

/// A case worth keeping: where it was met.
struct Witness {
  Unit unit;
  std::uint64_t index = 0;
  float badness = -1;

  void take(const Unit& of, std::uint64_t at, float how_bad) {
    if (how_bad > badness) *this = {of, at, how_bad};
  }
};

/// The worst of a sweep or a walk: where the contestant is wrong, and where its error is largest.
struct Worst {
  std::optional<Witness> wrong;
  std::optional<Witness> error;
};

Worst worst_of(const StressResult& result, const Unit& family, std::size_t contestant) {
  Witness wrong;
  Witness error;
  for (std::size_t i = 0; i < result.units.size(); ++i) {
    const Unit& unit = result.units[i];
    if (unit.sweep != family.sweep || unit.walk != family.walk) continue;
    const StepTally& tally = result.tallies[i][contestant];
    if (tally.wrong() > 0) wrong.take(unit, tally.worst_wrong, tally.wrongness);
    if (unit.walk != nullptr || tally.contacts == 0) continue;  // a walk keeps no errors
    for (const Spread& spread : {tally.of_size.depth, tally.of_size.position}) {
      error.take(unit, spread.worst, spread.max);
    }
  }
  const auto found = [](const Witness& witness) {
    return witness.badness < 0 ? std::nullopt : std::optional(witness);
  };
  return {found(wrong), found(error)};
}

std::string name_of(const Unit& unit) {
  return std::string(unit.walk != nullptr ? unit.walk->name : unit.sweep->name);
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

/// A collider of this repository is put to the test, any other is held against one.
std::pair<Collider, Collider> parties_of(const Collider& collider) {
  const ColliderEntry* const entry = find_entry(collider.declaration.name);
  if (entry != nullptr && entry->is_ours) return {collider, find_collider(kOracle)};
  return {find_collider(kSteady), collider};
}

}  // namespace

std::size_t save_worst(const StressPlan& plan, const StressResult& result,
                       const std::filesystem::path& corpus, Interruption& interruption,
                       const std::function<void(const std::string&)>& on_file) {
  std::vector<Unit> families;
  for (const Sweep* const sweep : plan.sweeps) families.push_back({.sweep = sweep});
  for (const Walk* const walk : plan.walks) families.push_back({.walk = walk});
  std::size_t written = 0;
  for (const Unit& family : families) {
    for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
      const Contestant& contestant = plan.contestants[i];
      if (contestant.name == kIdealName || contestant.walks_only) continue;
      const Worst worst = worst_of(result, family, i);
      const bool is_steady = contestant.name == kSteady;
      if (!worst.wrong && !(is_steady && worst.error)) continue;
      const Witness& witness = worst.wrong ? *worst.wrong : *worst.error;
      const std::string name = fmt::format("stress-{}-{}.json", name_of(family), contestant.name);
      on_file(name);
      const auto [subject, oracle] = parties_of(contestant.collider);
      PairCase pair = case_of(plan, witness.unit, witness.index);
      Judgement judgement = judge_guarded(pair, subject, oracle, interruption);
      const bool is_fault = judgement.bucket.fault != Fault::none;
      if (!is_fault && !is_steady) continue;
      if (is_fault) {
        pair = shrink_finding(pair, subject, oracle, interruption).pair;
        judgement = judge_guarded(pair, subject, oracle, interruption);
      }
      CorpusCase saved = recorded_case(pair, judgement, subject, oracle, interruption);
      saved.note += fmt::format(" {} of {}.", is_fault ? "Shrunk from the worst" : "The worst",
                                where(witness, plan.seed));
      const auto folder = corpus / corpus_folder(judgement.bucket, oracle.declaration.name);
      write_file(folder / name, format_case(saved));
      ++written;
    }
  }
  return written;
}

}  // namespace manifuzz
