#include "oracle/external/limits.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "cases/text.hpp"
#include "cases/user_error.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kNameLengthMax = 40;

bool can_name_files(std::string_view name) {
  return !name.empty() && name.size() <= kNameLengthMax && name.front() != '.' &&
         std::ranges::all_of(name, [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
         });
}

}  // namespace

std::optional<Unsupported> beyond_limits(const Declaration& declaration, const PairCase& pair) {
  const int vertices = std::max(pair.a.polygon.count, pair.b.polygon.count);
  if (vertices > declaration.max_vertices) {
    return Unsupported{fmt::format("takes up to {} vertices", declaration.max_vertices)};
  }
  if (!declaration.takes_radius && total_radius(pair) > 0) {
    return Unsupported{"takes no rounded polygons"};
  }
  return std::nullopt;
}

void check_declaration(const Declaration& declaration, std::string_view prefix) {
  if (!can_name_files(declaration.name)) {
    throw UserError(fmt::format("{}name: '{}' is no name; 1 to {} letters, digits, - _ . are",
                                prefix, printable(declaration.name), kNameLengthMax));
  }
  if (!std::isfinite(declaration.tie_bias) || declaration.tie_bias < 0) {
    throw UserError(fmt::format("{}tie_bias: {} is no length; 0 or more is expected", prefix,
                                declaration.tie_bias));
  }
}

Collider isolated(const Declaration& declaration, CollideMany collide_many) {
  Collider collider;
  collider.declaration = declaration;
  collider.collide_many = [declaration, collide_many](std::span<const PairCase> pairs,
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
    std::vector<Answer> answered(asked.size());
    const std::size_t count = collide_many(asked, answered, go_on);
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
