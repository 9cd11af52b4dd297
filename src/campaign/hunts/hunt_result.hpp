#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/json.hpp"
#include "campaign/hunts/filled_cells.hpp"

namespace manifuzz {

struct CampaignResult;
struct CorpusCase;

/// The worst of one measure that a hunt met.
struct HuntRow {
  std::string measure;
  double worst = 0;                     ///< 0: none; may be infinite
  std::optional<double> worst_drawn{};  ///< none: nothing was drawn to compare with
  std::uint64_t seed = 0;               ///< of its case, as the index is
  std::uint64_t index = 0;
  std::string file{};  ///< of a corpus, where it is kept; else empty
};

/// What the result of a hunt says besides what that of a campaign does.
struct HuntResult {
  std::uint64_t rounds = 0;       ///< 0: it was not dealt to machines
  std::uint64_t shares = 0;       ///< of each round
  std::uint64_t cases_dealt = 0;  ///< to all shares of all rounds; 0: an older version's
  std::uint64_t generations = 0;
  std::optional<FilledCells> cells{};  ///< none: of several runs, whose archives were not read
  std::optional<FilledCells> cells_drawn{};
  std::vector<HuntRow> rows{};
  std::vector<std::string> buckets_drawn{};  ///< that drawn cases alone met
};

/// Adds the keys of a hunt to the JSON of its result.
void add_hunt(const HuntResult& hunt, nlohmann::ordered_json& json);
/// The hunt that a result's JSON tells of; none in one of drawn cases. Throws UserError that begins
/// with a path.
std::optional<HuntResult> read_hunt(const JsonView& root);

/// Adds a run's hunt to the sum of those before it. Cells are not known of the sum.
void add_hunt(CampaignResult& sum, const CampaignResult& run);

/// Takes the cases out that hunts keep as the worst of a measure, in worst/COLLIDER/MEASURE.json.
std::vector<CorpusCase> take_out_worst(std::vector<CorpusCase>& cases);
/// Writes those that rows name to a corpus, and names their files there in the rows; what is not
/// among the cases has no file. Throws UserError.
void write_worst(HuntResult& hunt, const std::vector<CorpusCase>& worst,
                 const std::filesystem::path& corpus);

}  // namespace manifuzz
