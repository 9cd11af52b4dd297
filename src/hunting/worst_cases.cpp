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

/// How bad the case is that the file has, if any.
double kept_value(const std::filesystem::path& file, Gauge gauge, const Collider& collider,
                  Interruption& interruption) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return 0;
  const PairCase kept = read_case_file(file.string()).pair();
  const auto observed = observed_now(collider, kept, interruption);
  return observed ? (*observed)[gauge] : 0;
}

void keep(WorstFound& found, const Plan& plan, const std::filesystem::path& corpus,
          Interruption& interruption) {
  const auto file = worst_file(corpus, plan.subject.declaration.name, found.gauge);
  if (found.value > kept_value(file, found.gauge, plan.subject, interruption)) {
    CorpusCase saved;
    saved.any = *found.pair;
    saved.found =
        Found{.seed = plan.seed,
              .regime = std::string(kHunted.name),
              .index = plan.index_of(found.number),
              .versions = {{plan.subject.declaration.name, plan.subject.declaration.version}}};
    saved.note = note_of_worst(found.gauge, found.value);
    write_file(file, format_case(saved));
  }
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

void keep_worst(Hunt& hunt, const std::filesystem::path& corpus) {
  Interruption interruption;
  for (WorstFound& found : hunt.worst) {
    if (!found.pair) continue;
    try {
      keep(found, hunt.campaign.plan, corpus, interruption);
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
