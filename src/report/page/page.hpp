#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/named_colliders.hpp"
#include "campaign/plan.hpp"
#include "campaign/result.hpp"
#include "campaign/trial.hpp"
#include "collider/collider.hpp"
#include "report/picture/pictures.hpp"

namespace manifuzz {

/// A case on the page: what `show` shows, and what its file and the runs add.
struct PageCase {
  JudgedCase judged;       ///< its judgement is of these answers, where `is_judged`
  bool is_judged = false;  ///< false: a collider is missing, of which the file tells all there is
  std::vector<Manifold<double>> right;  ///< every right one, the one to show first
  std::string smallest;                 ///< of a worst witness: the file of what it was shrunk to
  std::optional<std::uint64_t> count;   ///< how often the runs met its bucket
  std::vector<std::string> commands;    ///< that show or repeat it
  std::optional<CaseMap> map;
};

/// A case as the page's script reads it, with what is drawn of it: everything in world directions
/// and lengths, seen from A's position; null where a number is not finite.
nlohmann::ordered_json page_case_json(const PageCase& page_case);

/// What runs say of a bucket.
struct BucketRuns {
  std::optional<std::uint64_t> count;  ///< how often they met it
  std::vector<std::string> commands;   ///< that repeat it
};
BucketRuns runs_of(const CorpusCase& given, const std::vector<ResultFile>& results);

/// The sequences of these files as the page's script reads them, each with its verdict and, where
/// its collider is there to be asked, its filmstrip. Throws Interrupted.
nlohmann::ordered_json page_sequences_json(const RunFiles& files, const TrialOf& trial_of,
                                           const std::string& program, Interruption& interruption);

/// The number of buckets whose neighbourhood is drawn by default: that takes a few seconds.
inline constexpr std::size_t kMapsUsual = 12;

/// Who is asked about what files do not answer themselves.
struct PageColliders {
  NamedColliders of_pairs;
  TrialOf of_sequences;
};

/// How the page's commands call this program.
struct PageCommands {
  std::string program;
  std::string again;  ///< makes the page again, or empty
};

/// The page of these files, its cases in their order: one HTML file that needs nothing else. Its
/// data is a JSON object in the element `data`, which src/report/page/scripts/data.js reads.
/// Answers are those that a file records; else its colliders are asked. At most `maps_max` buckets
/// get the map of their smallest witness, those with somebody wrong first. Throws UserError where a
/// signal interrupts it.
std::string page_of(const RunFiles& files, PageColliders colliders, std::size_t maps_max,
                    const PageCommands& commands);

}  // namespace manifuzz
