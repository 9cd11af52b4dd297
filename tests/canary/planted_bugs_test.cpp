#include <cmath>
#include <csignal>
#include <limits>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "campaign/run.hpp"
#include "campaign/save.hpp"
#include "engines/colliders.hpp"

// Bugs planted into a right collider. A campaign must find each, and blame the right one.

using namespace manifuzz;

namespace {

using Spoil = void (*)(const PairCase& pair, Manifold<double>& manifold);

Collider spoilt(Spoil spoil) {
  Collider collider = find_collider("clip");
  const auto right = collider.collide;
  collider.collide = [right, spoil](const PairCase& pair) {
    auto manifold = std::get<Manifold<double>>(right(pair));
    spoil(pair, manifold);
    return Answer(manifold);
  };
  return collider;
}

Plan plan_of(Collider subject, std::uint64_t cases = 40'000) {
  Plan plan;
  plan.subject = std::move(subject);
  plan.oracle = find_collider("box2d");
  for (const Regime& regime : polygon_regimes()) plan.regimes.push_back(&regime);
  plan.seed = 1;
  plan.cases = cases;
  plan.jobs = 2;
  return plan;
}

std::unique_ptr<Tally> run(const Plan& plan) {
  Interruption interruption;
  JobsResult result = run_jobs(plan, {0, plan.cases_max()}, interruption, [](const Progress&) {});
  CHECK(result.tally->cases() == *plan.cases);
  return std::move(result.tally);
}

bool blames_subject(const Tally& tally, Kind kind) {
  return std::ranges::any_of(tally.buckets.all(), [kind](const BucketTallies::Met& met) {
    return met.bucket.kind == kind && met.bucket.verdict == Verdict::subject_wrong;
  });
}

struct Bug {
  const char* what;
  Kind kind;
  Spoil spoil;
};

const Bug kBugs[] = {
    {"no contact where there are two points", Kind::missed_contact,
     [](const PairCase&, Manifold<double>& m) { m.count = m.count == 2 ? 0 : m.count; }},
    {"a contact for polygons just apart", Kind::phantom_contact,
     [](const PairCase& pair, Manifold<double>& m) {
       if (m.count > 0) return;
       m.count = 1;
       m.normal = {1, 0};
       m.points[0] = {pair.a.polygon.vertices[0].cast<double>(), 0, {}};
     }},
    {"the normal points from B to A", Kind::reversed,
     [](const PairCase&, Manifold<double>& m) { m.normal = -m.normal; }},
    {"the second point is lost", Kind::count,
     [](const PairCase&, Manifold<double>& m) { m.count = std::min(m.count, 1); }},
    {"the points are midpoints", Kind::position,
     [](const PairCase&, Manifold<double>& m) {
       for (int i = 0; i < m.count; ++i) {
         m.points[i].position += m.normal * (m.points[i].depth / 2);
       }
     }},
    {"the depths are swapped", Kind::depth,
     [](const PairCase&, Manifold<double>& m) {
       if (m.count == 2) std::swap(m.points[0].depth, m.points[1].depth);
     }},
    {"the features name the vertex behind", Kind::features,
     [](const PairCase& pair, Manifold<double>& m) {
       for (int i = 0; i < m.count; ++i) {
         auto& index = m.points[i].features.a.index;
         index = static_cast<unsigned char>(pair.a.polygon.previous(index));
       }
     }},
};

}  // namespace

TEST_CASE("a campaign blames each planted bug on the subject") {
  for (const Bug& bug : kBugs) {
    DYNAMIC_SECTION(bug.what) {
      const Plan plan = plan_of(spoilt(bug.spoil));
      CHECK(blames_subject(*run(plan), bug.kind));
    }
  }
}

TEST_CASE("the collider itself is not blamed") {
  CHECK(run(plan_of(find_collider("clip")))->unexplained() == 0);
}

TEST_CASE("a bug of the oracle is the oracle's") {
  Plan plan = plan_of(find_collider("clip"));
  plan.oracle = spoilt(kBugs[2].spoil);
  const auto tally = run(plan);
  CHECK(tally->count(Verdict::oracle_wrong) > 0);
  CHECK(tally->count(Verdict::subject_wrong) == 0);
}

TEST_CASE("nonsense is malformed") {
  const auto tally = run(plan_of(spoilt([](const PairCase&, Manifold<double>& m) {
    m.points[0].depth = std::numeric_limits<double>::quiet_NaN();
  })));
  CHECK(tally->count(Verdict::malformed) > 0);
}

TEST_CASE("a collider that crashes now and then loses those cases and no other") {
  Collider crashing = find_collider("clip");
  const auto right = crashing.collide;
  crashing.collide = [right](const PairCase& pair) {
    if (pair.a.polygon.count == 8 && pair.b.polygon.count == 8) raise(SIGKILL);
    return right(pair);
  };
  const auto tally = run(plan_of(crashing, 4000));
  CHECK(tally->count(Verdict::crashed) > 0);
  CHECK(tally->count(Verdict::agree) > 2000);
  const Bucket bucket = bucket_of_lost(Verdict::crashed, Fault::subject);
  REQUIRE(tally->buckets.find(bucket) != nullptr);
  CHECK(tally->buckets.find(bucket)->count == tally->count(Verdict::crashed));
}

TEST_CASE("a collider that hangs loses the case, and the campaign goes on") {
  Collider hanging = find_collider("clip");
  const auto right = hanging.collide;
  hanging.collide = [right](const PairCase& pair) {
    static const PairCase fatal = generate(1, *find_regime("generic"), 5);
    while (pair == fatal) usleep(1000);
    return right(pair);
  };
  const auto tally = run(plan_of(hanging, 2000));
  CHECK(tally->count(Verdict::timed_out) == 1);
  CHECK(tally->unexplained() == 1);
}

TEST_CASE("the number of jobs changes no verdict and no bucket") {
  Plan plan = plan_of(spoilt(kBugs[3].spoil), 20'000);
  const auto two = run(plan);
  plan.jobs = 1;
  const auto one = run(plan);
  CHECK(one->verdicts == two->verdicts);
  const auto met = one->buckets.all();
  const auto also_met = two->buckets.all();
  REQUIRE(met.size() == also_met.size());
  for (std::size_t i = 0; i < met.size(); ++i) {
    CHECK(met[i].bucket == also_met[i].bucket);
    CHECK(met[i].tally->count == also_met[i].tally->count);
    CHECK(met[i].tally->first == also_met[i].tally->first);
    CHECK(met[i].tally->worst == also_met[i].tally->worst);
    CHECK(met[i].tally->error.magnitude == also_met[i].tally->error.magnitude);
    CHECK(met[i].tally->regimes == also_met[i].tally->regimes);
  }
}
