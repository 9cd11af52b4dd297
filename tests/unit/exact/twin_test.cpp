#include "support/twin.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/named_tests.hpp"

// The judge against its twin, in every regime: on what colliders answer, and on answers moved by
// about as much as the bounds allow. MANIFUZZ_TWIN_CASES sets how many a regime.

namespace manifuzz {
namespace {

/// Between a quarter of the bound and four times it.
double about(Random& random, double bound) {
  static constexpr std::array<double, 6> kShares{0.25, 0.5, 0.9, 1, 2, 4};
  return random.either_sign(bound * kShares[static_cast<std::size_t>(random.integer(0, 5))]);
}

/// An answer as it is, or moved in one of the ways in which answers are wrong.
Answer moved(const Answer& answer, const PairCase& pair, const Bounds& bounds, Random& random) {
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
      return moved(answer, pair, of_clip, random);
  }
  return m;
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

std::vector<TwinCandidate> judged_candidates(const Admissible& right) {
  std::vector<TwinCandidate> candidates;
  for (const exact::Clip* clip : right.candidates) {
    candidates.push_back({clip->reference.side, clip->reference.index, clip->incident});
  }
  return candidates;
}

void compare(const Regime& regime) {
  const std::array<Collider, 3> colliders{make_clip(), make_clip64(), make_box2d()};
  std::vector<PairCase> corpus;
  for (std::uint64_t i = 0; i < 20; ++i) corpus.push_back(generate(3, *find_regime("grid"), i));
  for (std::uint64_t i = 0; i < twin_cases(regime.is_round ? 500 : 2000); ++i) {
    const PairCase pair = generate(11, regime, i, {.corpus = corpus, .radius = {}});
    Random random(11, "answers", i);
    Collider subject = colliders[random.chance(0.5) ? 0 : 1];
    // Box2D takes few round pairs.
    const Collider& oracle = colliders[random.chance(is_round(pair) ? 0.75 : 0.25) ? 1 : 2];
    if (is_round(pair)) subject.declaration.second_point = any_policy(random);
    const Answer right = subject.collide(pair);
    const Answer of_subject = is_round(pair)
                                  ? moved_round(right, pair, subject.declaration, random)
                                  : moved(right, pair, bounds(pair, subject.declaration), random);
    const Answer of_oracle = oracle.collide(pair);
    const ColliderAnswer s{subject.declaration, of_subject};
    const ColliderAnswer o{oracle.declaration, of_oracle};
    std::string line;
    append_case_line(line, pair);
    INFO(line << "\n"
              << subject.declaration.name << " against " << oracle.declaration.name << ", index "
              << i);
    const TwinJudgement twin = twin_judge(pair, s, o);
    REQUIRE(standing(exact::Truth(pair)).touching == twin.touching);
    REQUIRE(judged_candidates(admissible(pair, s.declaration)) == twin.candidates);
    REQUIRE(to_string(as_twin_has_it(judge(pair, s, o).bucket)) == to_string(twin.bucket));
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const Regime& regime : regimes()) {
    test::add_test("the judge and its twin agree in the regime " + std::string(regime.name),
                   "[twin]", [&regime] { compare(regime); });
  }
  return true;
}();

}  // namespace
}  // namespace manifuzz
