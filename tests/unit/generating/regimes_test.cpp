#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <catch2/catch.hpp>

#include "base/random.hpp"
#include "generating/regime.hpp"
#include "unit/generating/small_corpus.hpp"

namespace manifuzz {
namespace {

using Points = std::vector<Vector2<double>>;

Points world_vertices(const Body& body) {
  Points points;
  const double c = body.pose.rotation.x();
  const double s = body.pose.rotation.y();
  for (const auto& v : body.polygon.corners()) {
    const double x = v.x();
    const double y = v.y();
    points.emplace_back(c * x - s * y + body.pose.position.x(),
                        s * x + c * y + body.pose.position.y());
  }
  return points;
}

/// The greatest of the faces' signed distances to the nearest of the points, the plain way.
double face_separation(const Points& from, const Points& to) {
  double greatest = -INFINITY;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vector2<double> edge = from[(i + 1) % from.size()] - from[i];
    const double length = std::hypot(edge.x(), edge.y());
    double least = INFINITY;
    for (const auto& point : to) {
      const Vector2<double> offset = point - from[i];
      least = std::min(least, (edge.y() * offset.x() - edge.x() * offset.y()) / length);
    }
    greatest = std::max(greatest, least);
  }
  return greatest;
}

/// The separation less the total radius.
double gap(PairCase pair) {
  const double radii = total_radius(pair);
  // Relative, so that the distance from the origin costs no figures.
  const Vector2<double> apart =
      pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
  pair.a.pose.position = pair.b.pose.position = {0, 0};
  const Points a = world_vertices(pair.a);
  Points b = world_vertices(pair.b);
  for (auto& point : b) point += apart;
  return std::max(face_separation(a, b), face_separation(b, a)) - radii;
}

bool is_valid(const Body& body) {
  for (int i = 0; i < body.polygon.count; ++i) {
    if (!body.polygon.normals[i].array().isFinite().all()) return false;
  }
  return !find_defect(body.polygon.corners()) && is_unit_rotation(body.pose.rotation) &&
         std::isfinite(body.polygon.radius) && body.polygon.radius >= 0 &&
         body.pose.position.array().isFinite().all();
}

struct Counts {
  int invalid = 0;
  int touching = 0;
  int near = 0;
  int touching_or_near = 0;
  std::map<int, int> vertices;
};

Counts count(const Regime& regime, int cases, const GenerationContext& context) {
  Counts counts;
  for (int i = 0; i < cases; ++i) {
    const PairCase pair = generate(1, regime, static_cast<std::uint64_t>(i), context);
    if (!is_valid(pair.a) || !is_valid(pair.b)) {
      ++counts.invalid;
      continue;
    }
    const double distance = gap(pair);
    const bool touches = distance <= 0;
    const bool is_near = std::abs(distance) <= 0.1 * size(pair);
    counts.touching += touches ? 1 : 0;
    counts.near += is_near ? 1 : 0;
    counts.touching_or_near += touches || is_near ? 1 : 0;
    ++counts.vertices[pair.a.polygon.count];
    ++counts.vertices[pair.b.polygon.count];
  }
  return counts;
}

}  // namespace

TEST_CASE("every case of every regime of polygons is valid, and 8 in 10 touch or nearly") {
  const auto corpus = small_corpus();
  constexpr int cases = 20000;
  for (const Regime& regime : polygon_regimes()) {
    INFO("regime " << regime.name);
    const Counts counts = count(regime, cases, {corpus, {}});
    CHECK(counts.invalid == 0);
    if (regime.name == "separated") {
      CHECK(counts.touching == 0);
      continue;
    }
    CHECK(counts.touching_or_near >= cases * 8 / 10);
    CHECK(counts.touching >= cases / 4);
    if (regime.name != "deep") CHECK(counts.near >= cases / 2);
    if (regime.name != "boxes") {
      for (int n = kMinVertices; n <= kMaxVertices; ++n) {
        INFO(n << " vertices");
        CHECK(counts.vertices.count(n) == 1);
      }
    }
  }
}

TEST_CASE("a case depends on the regime's name, not on its place in the list") {
  const Regime& listed = regimes()[3];
  const Regime elsewhere{listed.name, "", listed.attempt};
  const Regime renamed{"another name", "", listed.attempt};
  CHECK(generate(1, elsewhere, 5) == generate(1, listed, 5));
  CHECK_FALSE(generate(1, renamed, 5) == generate(1, listed, 5));
  CHECK_FALSE(generate(1, listed, 6) == generate(1, listed, 5));
  CHECK_FALSE(generate(2, listed, 5) == generate(1, listed, 5));
}

TEST_CASE("regimes are found by name, each name once, each with a line of text") {
  for (const Regime& regime : regimes()) {
    CHECK(find_regime(regime.name) == &regime);
    CHECK_FALSE(regime.description.empty());
    CHECK(regime.description.find('\n') == std::string_view::npos);
  }
  CHECK(find_regime("no_such_regime") == nullptr);
}

TEST_CASE("the context's radius takes the place of every regime's own") {
  const auto corpus = small_corpus();
  for (const Regime& regime : polygon_regimes()) {
    INFO("regime " << regime.name);
    for (const float radius : {0.0f, 0.125f}) {
      int others = 0;
      for (std::uint64_t i = 0; i < 500; ++i) {
        const PairCase pair = generate(3, regime, i, {corpus, radius});
        if (pair.a.polygon.radius != radius || pair.b.polygon.radius != radius) ++others;
      }
      CHECK(others == 0);
    }
  }
}

TEST_CASE("touching cases are within a few ulps of touching, whatever the radius") {
  const Regime& regime = *find_regime("touching");
  for (const auto radius : {std::optional<float>(), std::optional<float>(0.5f)}) {
    int off = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const PairCase pair = generate(4, regime, i, {{}, radius});
      const double reaches = extent(pair) + std::abs(pair.a.pose.position.x()) +
                             std::abs(pair.a.pose.position.y()) + total_radius(pair);
      if (std::abs(gap(pair)) > 8 * ulp_of(reaches)) ++off;
    }
    CHECK(off <= 20);  // where no place on the way has the separation asked for
  }
}

TEST_CASE("regimes reach the ends of their ranges") {
  double farthest = 0;
  double smallest = INFINITY;
  double largest = 0;
  double least_unit = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const PairCase far = generate(5, *find_regime("far_from_origin"), i);
    farthest = std::max(farthest, std::hypot(static_cast<double>(far.a.pose.position.x()),
                                             static_cast<double>(far.a.pose.position.y())));
    const PairCase scaled = generate(5, *find_regime("scaled"), i);
    smallest = std::min(smallest, size(scaled));
    largest = std::max(largest, size(scaled));
    const PairCase turned = generate(5, *find_regime("off_unit"), i);
    const Vector2<double> rotation = turned.a.pose.rotation.cast<double>();
    least_unit = std::max(least_unit, std::abs(rotation.dot(rotation) - 1));
  }
  CHECK(farthest > 5e6);
  CHECK(farthest < 1.1e7);
  CHECK(smallest < 1e-5);
  CHECK(largest > 1e5);
  CHECK(least_unit > 0.98e-5);
}

TEST_CASE("a grid case is made of halves, and often of exact ties") {
  int odd = 0;
  int exact = 0;
  const auto is_half = [](float x) { return 2 * x == std::round(2 * x); };
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const PairCase pair = generate(6, *find_regime("grid"), i);
    for (const Body* body : {&pair.a, &pair.b}) {
      for (const auto& v : body->polygon.corners()) odd += is_half(v.x()) && is_half(v.y()) ? 0 : 1;
      const auto& p = body->pose.position;
      odd += is_half(p.x()) && is_half(p.y()) ? 0 : 1;
    }
    exact += gap(pair) == 0 ? 1 : 0;
  }
  CHECK(odd == 0);
  CHECK(exact > 200);
}

TEST_CASE("without a corpus, its regime still has cases, and with one, they are near its own") {
  const Regime& regime = *find_regime("corpus");
  CHECK_FALSE(find_defect(generate(8, regime, 0).a.polygon.corners()));
  const auto corpus = small_corpus();
  for (std::uint64_t i = 0; i < 200; ++i) {
    const PairCase pair = generate(8, regime, i, {corpus, {}});
    const bool like_one = std::any_of(corpus.begin(), corpus.end(), [&](const PairCase& from) {
      const int counts[] = {pair.a.polygon.count, pair.b.polygon.count};
      const int others[] = {from.a.polygon.count, from.b.polygon.count};
      return std::is_permutation(counts, counts + 2, others);
    });
    CHECK(like_one);
  }
}

TEST_CASE("floats are stepped in their own order, through zero, and never off the end") {
  CHECK(stepped(1.0f, 1) == std::nextafter(1.0f, 2.0f));
  CHECK(stepped(1.0f, -1) == std::nextafter(1.0f, 0.0f));
  CHECK(stepped(-1.0f, 1) == std::nextafter(-1.0f, 0.0f));
  CHECK(stepped(0.0f, -1) == -std::numeric_limits<float>::denorm_min());
  CHECK(stepped(-0.0f, 1) == std::numeric_limits<float>::denorm_min());
  CHECK(stepped(-std::numeric_limits<float>::denorm_min(), 2) ==
        std::numeric_limits<float>::denorm_min());
  CHECK(stepped(std::numeric_limits<float>::max(), 1) == std::numeric_limits<float>::max());
  CHECK(ulp_of(-1.0) == 0x1p-23);
}

}  // namespace manifuzz
