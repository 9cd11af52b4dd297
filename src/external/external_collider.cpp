#include "external/external_collider.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "collider/snippet.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kNameLengthMax = 40;

constexpr std::size_t kVersionLengthMax = 60;

bool is_plain(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return c >= ' ' && c < 0x7f; });
}

/// Throws where a snippet says what is none of these.
template <class Words>
void expect_known(std::string_view word, const Words& words, std::string_view prefix) {
  if (std::ranges::find(words, word) != words.end()) return;
  throw UserError(fmt::format("{}snippet: there is no '{}'{}; there are {}", prefix,
                              printable(word), did_you_mean(word, words), fmt::join(words, ", ")));
}

/// Every @a.NAME@, with brackets or not, and every condition @a.NAME? must be known to
/// report/upstream/program.cpp; b as a.
void check_snippet(std::string_view snippet, std::string_view prefix) {
  for (std::size_t at = snippet.find('@'); at != snippet.npos; at = snippet.find('@', at + 1)) {
    std::string_view rest = snippet.substr(at + 1);
    if (rest.starts_with('!')) rest.remove_prefix(1);
    if (!rest.starts_with("a.") && !rest.starts_with("b.")) continue;
    rest.remove_prefix(2);
    const std::size_t end = rest.find_first_of("@?[{( \n");
    if (end == rest.npos || rest[end] == ' ' || rest[end] == '\n') continue;
    const std::string_view word = rest.substr(0, end);
    if (rest[end] == '?') {
      expect_known(word, kSnippetConditions, prefix);
    } else {
      expect_known(word, kSnippetKeys, prefix);
    }
  }
}

}  // namespace

bool is_collider_name(std::string_view name) {
  return !name.empty() && name.size() <= kNameLengthMax && name.front() != '.' &&
         std::ranges::all_of(name, [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
         });
}

std::optional<Unsupported> beyond_limits(const Declaration& declaration, const PairCase& pair) {
  const int vertices = std::max(pair.a.polygon.count, pair.b.polygon.count);
  if (vertices > declaration.max_vertices) {
    return Unsupported{fmt::format("takes up to {} vertices", declaration.max_vertices)};
  }
  if (!declaration.takes_radius && total_radius(pair) > 0 && !is_round(pair)) {
    return Unsupported{"takes no rounded polygons"};
  }
  if (!takes_shapes(declaration, pair)) {
    const int least = std::min(pair.a.polygon.count, pair.b.polygon.count);
    if (declines(declaration, pair)) return Unsupported{"has no function for such a pair"};
    const bool is_too_small =
        std::ranges::any_of(std::array{pair.a, pair.b}, [&](const Body& body) {
          return body.polygon.count >= kMinVertices &&
                 !has_at_least(body.polygon, declaration.least_polygon);
        });
    if (is_too_small) return Unsupported{"takes no polygon so flat, or so small"};
    return Unsupported{least >= declaration.min_vertices ? "takes no polygons with round corners"
                       : least == 1                      ? "takes no circles"
                                                         : "takes no segments or capsules"};
  }
  return std::nullopt;
}

void check_declaration(const Declaration& declaration, std::string_view prefix) {
  if (!is_collider_name(declaration.name)) {
    throw UserError(
        fmt::format("{}name: '{}' is not a valid name; 1 to {} letters, digits, - _ . are", prefix,
                    printable(declaration.name), kNameLengthMax));
  }
  if (declaration.version.size() > kVersionLengthMax || !is_plain(declaration.version)) {
    throw UserError(
        fmt::format("{}version: '{}' is not a valid version; up to {} printable characters are",
                    prefix, printable(declaration.version), kVersionLengthMax));
  }
  check_snippet(declaration.snippet, prefix);
  const std::array<std::pair<std::string_view, double>, 5> lengths{
      {{"tie_bias", declaration.tie_bias.absolute},
       {"speculative", declaration.speculative},
       {"least_depth", declaration.least_depth},
       {"tolerance.absolute", declaration.tolerance.absolute},
       {"tolerance.relative", declaration.tolerance.relative}}};
  for (const auto& [key, length] : lengths) {
    if (std::isfinite(length) && length >= 0) continue;
    throw UserError(
        fmt::format("{}{}: {} is not a valid length; 0 or more is expected", prefix, key, length));
  }
  const LeastPolygon& least = declaration.least_polygon;
  if (!(least.turn >= 0 && least.turn < std::numbers::pi / 2)) {
    throw UserError(fmt::format(
        "{}least_polygon.turn: {} is not a valid angle; one from 0 to below pi / 2 is expected",
        prefix, least.turn));
  }
  if (!(std::isfinite(least.area) && least.area >= 0)) {
    throw UserError(fmt::format(
        "{}least_polygon.area: {} is not a valid area; 0 or more is expected", prefix, least.area));
  }
  if (!(std::abs(declaration.tie_bias.relative) < 1)) {
    throw UserError(
        fmt::format("{}tie_bias.relative: {} is not a valid share; one between -1 and 1 is", prefix,
                    declaration.tie_bias.relative));
  }
  if (!declaration.tolerance.is_none() && declaration.tolerance_source.empty()) {
    throw UserError(fmt::format(
        "{}tolerance.source: is missing; a tolerance needs the place that states it", prefix));
  }
  const bool is_clip = !is_judged_by_curve(declaration);
  if (is_clip) {
    const std::array<std::pair<std::string_view, bool>, 4> not_of_clips{
        {{"speculative", declaration.speculative > 0},
         {"least_depth", declaration.least_depth > 0},
         {"tolerance", !declaration.tolerance.is_none()},
         {"depths", declaration.shares_depth}}};
    for (const auto& [key, is_said] : not_of_clips) {
      if (!is_said) continue;
      throw UserError(
          fmt::format("{}{}: not used for clips; declare \"clips\": false as well", prefix, key));
    }
  }
  const bool is_of_clip =
      declaration.points == PointsAt::clip || declaration.points == PointsAt::midpoint;
  if (is_clip && !is_of_clip) {
    throw UserError(
        fmt::format("{}points: of clips, \"clip\" or \"midpoint\" is expected; declare \"clips\": "
                    "false for others",
                    prefix));
  }
}

bool is_unresponsive(std::span<const Answer> answers, std::size_t done) {
  if (done < std::size_t{kLossesInARowMax}) return false;
  return std::ranges::all_of(
      answers.subspan(done - kLossesInARowMax, kLossesInARowMax),
      [](const Answer& answer) { return std::holds_alternative<Lost>(answer); });
}

Collider isolated(const Declaration& declaration, double seconds_max,
                  const AnswerBatch& answer_batch) {
  Collider collider;
  collider.declaration = declaration;
  collider.seconds_max = seconds_max;
  collider.collide_many = [declaration, answer_batch](std::span<const PairCase> pairs,
                                                      std::span<Answer> answers,
                                                      const std::function<bool()>& go_on) {
    std::vector<PairCase> asked;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (auto declined = beyond_limits(declaration, pairs[i])) {
        answers[i] = *std::move(declined);
      } else {
        asked.push_back(pairs[i]);
        places.push_back(i);
      }
    }
    const std::span<const PairCase> all = asked;
    std::vector<Answer> answered(asked.size());
    std::size_t count = 0;
    while (count < all.size() && go_on() && !is_unresponsive(answered, count)) {
      const std::size_t batch = std::min(kBatch, all.size() - count);
      count +=
          answer_batch(all.subspan(count, batch), std::span(answered).subspan(count, batch), go_on);
    }
    for (std::size_t k = 0; k < count; ++k) answers[places[k]] = std::move(answered[k]);
    return count < asked.size() ? places[count] : pairs.size();
  };
  collider.collide = [many = collider.collide_many](const PairCase& pair) {
    Answer answer;
    many({&pair, 1}, {&answer, 1}, [] { return true; });
    return answer;
  };
  return collider;
}

}  // namespace manifuzz
