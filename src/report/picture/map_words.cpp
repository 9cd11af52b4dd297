#include "report/picture/map_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "exchange/json.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

std::string features_name(const FeaturePair& features) {
  return feature_name(features.a) + "/" + feature_name(features.b);
}

/// Who fails, and the verb: "box2d is wrong on".
std::string failing_in_words(const JudgedCase& judged) {
  const Bucket& finding = judged.judgement.bucket;
  switch (finding.fault) {
    case Fault::subject:
      return judged.subject.declaration.name + " is wrong on";
    case Fault::oracle:
      return judged.oracle.declaration.name + " is wrong on";
    case Fault::both:
      return "both are wrong on";
    case Fault::none:
      break;
  }
  if (finding.verdict == Verdict::agree) return "somebody is wrong on";
  return fmt::format("the verdict is {} on", to_string(finding.verdict));
}

std::ptrdiff_t count_of(const Neighbourhood& neighbourhood, Cell::State state) {
  return std::ranges::count(neighbourhood.cells, state, &Cell::state);
}

}  // namespace

std::string statement_in_words(const ContactSummary& statement) {
  const char clipping = statement.reference == Side::a ? 'A' : 'B';
  switch (statement.kind) {
    case ContactSummary::Kind::nothing:
      return "no manifold";
    case ContactSummary::Kind::apart:
      return "no contact";
    case ContactSummary::Kind::no_clip:
      return fmt::format("they touch, but the best face, {}'s, clips all away", clipping);
    case ContactSummary::Kind::contact:
      break;
  }
  std::string words = fmt::format("{} clips, {}: {}", clipping, counted(statement.count, "point"),
                                  features_name(statement.features[0]));
  if (statement.count > 1) words += " and " + features_name(statement.features[1]);
  return words;
}

std::string grid_in_words(const Grid& grid) {
  return fmt::format(
      "vertex {} of {} moved by up to {} steps each way in its x and y, a step being {} ({})",
      grid.vertex.index, grid.vertex.side == Side::a ? 'A' : 'B', grid.reach,
      counted(grid.step, "ulp"), brief(grid.step * grid.ulp));
}

std::string severity_in_words(const JudgedCase& judged, const Neighbourhood& neighbourhood) {
  const Severity found = severity(neighbourhood, judged.judgement.bucket);
  std::string words = fmt::format("severity {:.3g}: {} {} of {} neighbours", found.share(),
                                  failing_in_words(judged), found.failing, found.valid);
  if (const auto invalid = count_of(neighbourhood, Cell::State::invalid)) {
    words += fmt::format("; on {} more the polygon is not convex", invalid);
  }
  if (const auto left = count_of(neighbourhood, Cell::State::not_asked)) {
    words += fmt::format("; {} were not asked", left);
  }
  return words;
}

}  // namespace manifuzz
