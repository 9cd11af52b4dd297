#include "hunting/worst_cases.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/in_child.hpp"

namespace manifuzz {
namespace {

/// Four digits: enough to tell by how much one case is worse than another.
std::string in_digits(double value) {
  return fmt::format("{:.4g}", value);
}

/// The case that the file has, if it is there.
std::optional<PairCase> kept_case(const std::filesystem::path& file) {
  std::error_code unknown;
  const auto status = std::filesystem::status(file, unknown);
  if (!std::filesystem::exists(status)) return std::nullopt;
  if (!std::filesystem::is_regular_file(status)) {  // a pipe may never answer
    throw UserError(fmt::format("{}: is no file; a case is expected", printable_path(file)));
  }
  return read_case_file(file.string()).pair();
}

void keep(WorstFound& found, const Plan& plan, std::span<const std::filesystem::path> known,
          const std::filesystem::path& folder, Interruption& interruption) {
  const std::string& collider = plan.subject.declaration.name;
  for (const std::filesystem::path& corpus : known) {
    const auto file = worst_file(corpus, collider, found.gauge);
    const std::optional<PairCase> kept = kept_case(file);
    if (kept == found.pair) {
      found.file = file.string();
      return;
    }
    if (!kept) continue;
    const auto observed = observed_now(plan.subject, *kept, interruption);
    if (observed && (*observed)[found.gauge] >= found.value) return;
  }
  const auto file = worst_file(folder, collider, found.gauge);
  CorpusCase saved;
  saved.any = *found.pair;
  saved.found = Found{.seed = plan.seed,
                      .regime = std::string(kHunted.name),
                      .index = plan.index_of(found.number),
                      .versions = {{collider, plan.subject.declaration.version}}};
  saved.note = note_of_worst(found.gauge, found.value);
  write_file(file, format_case(saved));
  found.file = file.string();
}

}  // namespace

std::filesystem::path worst_file(const std::filesystem::path& corpus, const std::string& collider,
                                 Gauge gauge) {
  return corpus / "worst" / collider / fmt::format("{}.json", name_of(gauge, kGaugeNames));
}

std::optional<Observation> observed_now(const Collider& collider, const PairCase& pair,
                                        Interruption& interruption) {
  const Answer answer = ask_in_child(collider, pair, interruption);
  if (std::holds_alternative<Lost>(answer) || std::holds_alternative<Unsupported>(answer)) {
    return std::nullopt;
  }
  const auto truth = std::make_shared<const exact::Truth>(pair);
  const ColliderAnswer given{collider.declaration, answer};
  return observation_of({truth, given, judge_alone(truth, given)});
}

std::string note_of_worst(Gauge gauge, double value) {
  switch (gauge) {
    case Gauge::error:
      return fmt::format("The greatest error of a wrong answer that is known: {} of the size.",
                         in_digits(value));
    case Gauge::missed:
      return fmt::format("The greatest depth that is known to be missed: {} of the size.",
                         in_digits(value));
    default:
      return fmt::format("The greatest share of its bound that is known of a {}: {}.",
                         gauge == Gauge::normal_share     ? "normal"
                         : gauge == Gauge::position_share ? "position"
                                                          : "depth",
                         in_digits(value));
  }
}

void keep_worst(Hunt& hunt, std::span<const std::filesystem::path> known,
                const std::filesystem::path& folder) {
  Interruption interruption;
  for (WorstFound& found : hunt.worst) {
    if (!found.pair) continue;
    try {
      keep(found, hunt.campaign.plan, known, folder, interruption);
    } catch (const Interrupted&) {
      return;
    } catch (const UserError& error) {
      ++hunt.campaign.saving.unwritten;
      if (hunt.campaign.saving.first_error.empty()) {
        hunt.campaign.saving.first_error = error.what();
      }
    }
  }
}

}  // namespace manifuzz
