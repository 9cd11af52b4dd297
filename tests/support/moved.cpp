#include "support/moved.hpp"

#include <array>

#include "judging/bounds.hpp"

namespace manifuzz {
namespace {

/// Between a quarter of the bound and four times it.
double about(Random& random, double bound) {
  static constexpr std::array<double, 6> kShares{0.25, 0.5, 0.9, 1, 2, 4};
  return random.either_sign(bound * kShares[static_cast<std::size_t>(random.integer(0, 5))]);
}

/// In one of the ways in which answers are wrong, or as it is.
Answer moved_clip(const Answer& answer, const PairCase& pair, const Bounds& bounds,
                  Random& random) {
  const auto* given = std::get_if<Manifold<double>>(&answer);
  if (given == nullptr || given->count == 0) return answer;
  Manifold<double> m = *given;
  auto& point = m.points[static_cast<std::size_t>(random.integer(0, m.count - 1))];
  switch (random.integer(0, 7)) {
    case 0:
      point.position.x() += about(random, bounds.position);
      break;
    case 1:
      point.depth = std::max(0.0, point.depth + about(random, bounds.separation));
      break;
    case 2:
      m.normal += about(random, bounds.normal) * counter_clockwise_quarter(m.normal);
      break;
    case 3:
      m.count = random.integer(0, m.count - 1);
      break;
    case 4:
      point.features.a.index =
          static_cast<unsigned char>(pair.a.polygon.next(point.features.a.index));
      break;
    case 5:
      m.reference = other(m.reference);
      break;
    default:
      break;
  }
  return m;
}

/// In more ways, those in which answers to round pairs are wrong; declared with any policy.
Answer moved_round(const Answer& answer, const PairCase& pair, const Declaration& declaration,
                   Random& random) {
  const auto* given = std::get_if<Manifold<double>>(&answer);
  if (given == nullptr || given->count == 0) return answer;
  const Bounds of_clip = bounds(pair, declaration);
  Manifold<double> m = *given;
  auto& point = m.points[static_cast<std::size_t>(random.integer(0, m.count - 1))];
  const Vector2<double> tangent = counter_clockwise_quarter(m.normal);
  switch (random.integer(0, 6)) {
    case 0:
      m.normal = -m.normal;
      break;
    case 1:
      m.normal += about(random, random.magnitude(-20, 0)) * tangent;
      m.normal.normalize();
      break;
    case 2:
      point.position += about(random, of_clip.position + of_clip.separation) * tangent;
      break;
    case 3:
      point.position += about(random, of_clip.position) * m.normal;
      break;
    case 4:
      point.position += random.uniform(-1, 1) * size(pair) * tangent;
      break;
    case 5:
      m.count = 2;
      m.points[1] = m.points[0];
      m.points[1].position += random.uniform(-1, 1) * size(pair) * tangent;
      break;
    default:
      return moved_clip(answer, pair, of_clip, random);
  }
  return m;
}

}  // namespace

Answer moved(const Answer& answer, const PairCase& pair, const Declaration& declaration,
             Random& random) {
  return is_round(pair) ? moved_round(answer, pair, declaration, random)
                        : moved_clip(answer, pair, bounds(pair, declaration), random);
}

SecondPoint any_policy(Random& random) {
  switch (random.integer(0, 5)) {
    case 0:
      return SecondPoint::never();
    case 1:
      return SecondPoint::within(random.magnitude(-20, 0));
    default:
      return {};
  }
}

}  // namespace manifuzz
