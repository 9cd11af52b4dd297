#include <catch2/catch.hpp>

#include "corpus/preference.hpp"
#include "exact/truth.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"

using namespace manifuzz;

namespace {

PairCase messy() {
  return generate(1, *find_regime("generic"), 3);
}

std::vector<float> xs(const ConvexPolygon<float>& polygon) {
  std::vector<float> values;
  for (const auto& v : polygon.corners()) values.push_back(v.x());
  return values;
}

}  // namespace

TEST_CASE("digits are those of the shortest decimal") {
  CHECK(significant_digits(0) == 0);
  CHECK(significant_digits(1) == 1);
  CHECK(significant_digits(-0.25F) == 2);
  CHECK(significant_digits(1200) == 2);
  CHECK(significant_digits(0.1F) == 1);
  CHECK(significant_digits(1e-20F) == 1);
}

TEST_CASE("rounding and stepping go by significant digits") {
  CHECK(rounded_to_digits(0.123456F, 2) == 0.12F);
  CHECK(rounded_to_digits(-987.6F, 1) == -1000);
  CHECK(nearer_to_zero(7) == 6);
  CHECK(nearer_to_zero(-0.25F) == -0.24F);
  CHECK(nearer_to_zero(1) == 0);
  CHECK(nearer_to_zero(3e-12F) == 2e-12F);
}

TEST_CASE("every simpler case is valid and simpler") {
  int count = 0;
  for (std::uint64_t index = 0; index < 20; ++index) {
    const PairCase pair = generate(2, regimes()[index % regimes().size()], index);
    rc::seq::forEach(simpler_cases(pair), [&](const PairCase& simpler) {
      ++count;
      CHECK(complexity(simpler) < complexity(pair));
      CHECK(revalidated(simpler).has_value());
    });
  }
  CHECK(count > 1000);
}

TEST_CASE("anything shrinks to two triangles at the origin") {
  const Shrunk shrunk = shrink(messy(), [](const PairCase&) { return true; });
  CHECK(shrunk.complete);
  const Complexity least = complexity(shrunk.pair);
  CHECK(least.vertices == 6);
  CHECK(least.placements == 0);
  CHECK(least.digits <= 6);
}

TEST_CASE("what the predicate needs is kept, and nothing else") {
  SECTION("five vertices of A") {
    PairCase start = messy();
    start.a = generate(1, *find_regime("regular"), 0).a;
    for (std::uint64_t i = 0; start.a.polygon.count < 6; ++i) {
      start.a = generate(1, *find_regime("generic"), i).a;
    }
    const auto five = [](const PairCase& p) { return p.a.polygon.count >= 5; };
    const Shrunk shrunk = shrink(start, five);
    CHECK(shrunk.pair.a.polygon.count == 5);
    CHECK(shrunk.pair.b.polygon.count == 3);
    CHECK(complexity(shrunk.pair).placements == 0);
  }
  SECTION("a position beyond 2 along x") {
    PairCase start = messy();
    start.b.pose.position = {7.654321F, -3.25F};
    const auto beyond = [](const PairCase& p) { return p.b.pose.position.x() > 2; };
    const Shrunk shrunk = shrink(start, beyond);
    CHECK(shrunk.pair.b.pose.position == Vector2<float>(3, 0));
    CHECK(complexity(shrunk.pair).placements == 1);
  }
  SECTION("a radius of at least two") {
    PairCase start = messy();
    start.a.polygon.radius = 7.654321F;
    const auto rounded = [](const PairCase& p) { return p.a.polygon.radius >= 2; };
    const Shrunk shrunk = shrink(start, rounded);
    CHECK(shrunk.pair.a.polygon.radius == 2);
    CHECK(shrunk.pair.b.polygon.radius == 0);
  }
}

TEST_CASE("tiny numbers are as hard to read as large ones") {
  PairCase tiny = messy();
  for (float* number : free_numbers(tiny)) *number *= 1e-6F;
  Shrunk shrunk = shrink(tiny, [](const PairCase&) { return true; });
  for (const float* number : free_numbers(shrunk.pair)) {
    CHECK((*number == 0 || std::abs(*number) >= 0.1F));
  }
}

TEST_CASE("shrinking is deterministic and keeps to its limit") {
  PairCase large = messy();
  for (float* number : free_numbers(large)) *number *= 10;
  const auto wide = [](const PairCase& p) { return diameter(p.a.polygon) > 3; };
  const Shrunk once = shrink(large, wide);
  const Shrunk again = shrink(large, wide);
  CHECK(once.pair == again.pair);
  CHECK(once.evaluations == again.evaluations);
  const Shrunk stopped = shrink(large, wide, 5);
  CHECK(stopped.evaluations == 5);
  CHECK_FALSE(stopped.complete);
  CHECK(wide(stopped.pair));
}

TEST_CASE("what a plain case shows has one normal form, wherever it was found") {
  const auto overlaps = [](const PairCase& p) {
    const exact::Truth truth(p);
    return truth.compare_separation(-0.1) < 0;
  };
  std::vector<PairCase> forms;
  for (std::uint64_t i = 0; forms.size() < 20; ++i) {
    const PairCase pair = generate(9, *find_regime("generic"), i);
    if (overlaps(pair)) forms.push_back(shrink(pair, overlaps).pair);
  }
  for (const PairCase& form : forms) CHECK(form == forms.front());
  CHECK(complexity(forms.front()).vertices == 6);
}

TEST_CASE("numbers of ordinary size are preferred to few digits") {
  PairCase start = messy();
  start.b.pose.position = {1250, 0};
  // 2000 has one digit, and what lies between 1.15 and 1.4 two.
  const auto either = [](const PairCase& p) {
    const float x = p.b.pose.position.x();
    return x > 1240 || (x > 1.15F && x < 1.4F);
  };
  const Shrunk shrunk = shrink(start, either);
  CHECK(shrunk.pair.b.pose.position == Vector2<float>(1.2F, 0));
  CHECK(complexity(shrunk.pair).odd_numbers == 0);
  CHECK(shrink(shrunk.pair, either).pair == shrunk.pair);
}

TEST_CASE("sizes of one case that are far apart are brought nearer") {
  PairCase start = messy();
  for (Body* body : {&start.a, &start.b}) body->pose = {};
  for (auto& vertex : start.a.polygon.vertices) vertex *= 2e7F;
  for (auto& vertex : start.b.polygon.vertices) vertex *= 3e-6F;
  const auto unlike = [](const PairCase& p) {
    return diameter(p.a.polygon) > 1000 * diameter(p.b.polygon);
  };
  const Shrunk shrunk = shrink(*revalidated(start), unlike);
  PairCase copy = shrunk.pair;
  for (const float* number : free_numbers(copy)) CHECK(is_ordinary(*number));
}

TEST_CASE("a clear lead of the best face is preferred to near ties and to ties") {
  const auto overlaps = [](const PairCase& p) {
    return exact::Truth(p).compare_separation(-0.1) < 0;
  };
  // B's corner lies as deep behind A's right face as behind its upper one, but for 2e-7.
  PairCase near_tie;
  near_tie.a.polygon =
      make_polygon<float>(std::vector<Vector2<float>>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  near_tie.b.polygon = make_polygon<float>(std::vector<Vector2<float>>{{0, 0}, {2, 1}, {1, 2}});
  near_tie.b.pose.position = {0.5F, 0.5000002F};
  REQUIRE(complexity(near_tie).is_near_tie);
  const PairCase shrunk = shrink(near_tie, overlaps).pair;
  CHECK(lead_of_best_face(shrunk) > 0.05);
  CHECK(shrink(shrunk, overlaps).pair == shrunk);
}

TEST_CASE(
    "of cases of one bucket the simplest is preferred, then the one with the greatest error") {
  CorpusCase plain;
  plain.any = messy();
  plain.expect = Expectation{};
  plain.expect->magnitude = 0.1;
  CorpusCase worse = plain;
  worse.expect->magnitude = 0.2;
  CorpusCase odd = worse;
  std::get<PairCase>(odd.any).a.pose.position.x() = 2e9F;
  CHECK(preference(worse) < preference(plain));
  CHECK(preference(plain) < preference(odd));
}

TEST_CASE("of symmetric images one is the normal form") {
  PairCase pair = messy();
  for (Body* body : {&pair.a, &pair.b}) body->pose = {};
  const auto far_out = [](const PairCase& p) {
    return std::max(diameter(p.a.polygon), diameter(p.b.polygon)) > 40;
  };
  PairCase turned = pair;
  for (Body* body : {&turned.a, &turned.b}) {
    for (auto& vertex : body->polygon.vertices) vertex = 20 * counter_clockwise_quarter(vertex);
  }
  for (Body* body : {&pair.a, &pair.b}) {
    for (auto& vertex : body->polygon.vertices) vertex *= 20;
  }
  const PairCase swapped{turned.b, turned.a};
  CHECK(complexity(shrink(*revalidated(pair), far_out).pair).vertices == 6);
  CHECK(shrink(*revalidated(turned), far_out).pair == shrink(*revalidated(swapped), far_out).pair);
}

TEST_CASE("no case is tried twice") {
  std::vector<std::vector<float>> tried;
  shrink(messy(), [&](const PairCase& p) {
    std::vector<float> key = xs(p.a.polygon);
    const std::vector<float> of_b = xs(p.b.polygon);
    key.insert(key.end(), of_b.begin(), of_b.end());
    for (const Side side : {Side::a, Side::b}) {
      for (const auto& v : p[side].polygon.corners()) key.push_back(v.y());
      key.insert(key.end(),
                 {p[side].polygon.radius, p[side].pose.position.x(), p[side].pose.position.y(),
                  p[side].pose.rotation.x(), p[side].pose.rotation.y()});
    }
    tried.push_back(key);
    return false;
  });
  const std::size_t all = tried.size();
  std::sort(tried.begin(), tried.end());
  CHECK(std::unique(tried.begin(), tried.end()) - tried.begin() == static_cast<long>(all));
}
