#include "hunting/property_hunt.hpp"

#include <cstdlib>
#include <utility>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "corpus/corpus.hpp"
#include "hunting/rare_bugs.hpp"
#include "hunting/rare_colliders.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

PropertyHuntPlan property_plan_of(const Collider& subject,
                                  const std::vector<std::string_view>& names, std::uint64_t cases,
                                  int jobs = 2) {
  PropertyHuntPlan plan{
      .properties = {}, .subject = subject, .corpus = {}, .seed = 4, .cases = cases, .jobs = jobs};
  for (const Property& property : properties()) {
    if (names.empty() || std::ranges::count(names, property.name) > 0) {
      plan.properties.push_back(&property);
    }
  }
  return plan;
}

/// Until the failures are saved.
PropertyHunt run_property(const PropertyHuntPlan& plan) {
  Interruption interruption;
  return hunt_properties(plan, interruption, [](const PropertyHuntProgress&) {});
}

std::vector<CheckedProperty> checked(PropertyHuntPlan plan, const std::string& save_to) {
  plan.save_to = save_to;
  Interruption interruption;
  return checked_by_hunt(run_property(plan), plan, {}, interruption, [](const CheckedProperty&) {});
}

/// The clip, which dies of shapes with eight vertices.
Collider dying_of_octagons() {
  Collider collider = make_clip();
  collider.declaration.name = "dying";
  collider.with_tie_bias = nullptr;
  collider.collide = [clip = make_clip()](const PairCase& pair) {
    if (pair.a.polygon.count == 8) std::_Exit(3);
    return clip.collide(pair);
  };
  return collider;
}

/// The clip, its depths greater by so much of the size, where that is so of the case.
Collider too_deep(double share, bool (*is_so)(const PairCase&)) {
  Collider collider = make_clip();
  collider.with_tie_bias = nullptr;
  collider.collide = [share, is_so, clip = make_clip()](const PairCase& pair) {
    Answer answer = clip.collide(pair);
    auto& manifold = std::get<Manifold<double>>(answer);
    for (ContactPoint<double>& point : manifold.points) {
      if (is_so(pair)) point.depth += share * size(pair);
    }
    return answer;
  };
  return collider;
}

Collider too_deep_heptagons() {
  return too_deep(0.25, [](const PairCase& pair) { return pair.a.polygon.count == 7; });
}

}  // namespace

TEST_CASE("any number of jobs finds the same failures of properties") {
  const std::pair<Collider, std::uint64_t> subjects[] = {{too_deep_heptagons(), 6000},
                                                         {dying_of_octagons(), 1200}};
  for (const auto& [subject, cases] : subjects) {
    CAPTURE(subject.declaration.name);
    const PropertyHunt alone = run_property(property_plan_of(subject, {}, cases, 1));
    const PropertyHunt shared = run_property(property_plan_of(subject, {}, cases, 3));
    CHECK(alone.cases == cases);
    CHECK(shared.cases == alone.cases);
    CHECK(shared.generations == alone.generations);
    CHECK(shared.cells == alone.cells);
    REQUIRE(shared.hunted.size() == properties().size());
    bool has_failed = false;
    for (std::size_t i = 0; i < alone.hunted.size(); ++i) {
      CAPTURE(alone.hunted[i].property->name);
      CHECK(shared.hunted[i].applied == alone.hunted[i].applied);
      CHECK(shared.hunted[i].first == alone.hunted[i].first);
      CHECK(shared.hunted[i].worst == alone.hunted[i].worst);
      CHECK(shared.hunted[i].failing == alone.hunted[i].failing);
      has_failed = has_failed || alone.hunted[i].first.has_value();
    }
    CHECK(has_failed);
  }
}

TEST_CASE("a hunt finds a property's failure that as many drawn cases do not, and saves it small") {
  const std::string_view bug = "deep_on_a_short_face";
  const PropertyHuntPlan plan = property_plan_of(with_rare_bug(bug), {"depth-is-overlap"}, 60'000);
  const Property& property = *plan.properties.front();
  CHECK(run_property(property, plan.subject, {4, 60'000, {}, {}}).passed);

  const TemporaryFolder folder;
  const std::vector<CheckedProperty> found = checked(plan, folder.path().string());
  REQUIRE(found.size() == 1);
  const CheckedProperty& failed = found.front();
  REQUIRE(failed.result.failing.has_value());
  CHECK_FALSE(failed.holds());
  CHECK(failed.result.cases == 60'000);
  CHECK(failed.result.magnitude == Approx(0.25).epsilon(0.1));
  const CorpusCase saved = read_case_file(failed.saved);
  CHECK(saved.property == property.name);
  CHECK(saved.pair() == *failed.result.failing);
  CHECK(rare_bugs_met_by(exact::Truth(saved.pair())) >> index_of_bug(bug) & 1);
  CHECK(check(property, plan.subject, saved.pair()).kind == PropertyOutcome::Kind::fails);
  CHECK(check(property, make_clip(), saved.pair()).kind == PropertyOutcome::Kind::holds);
  CHECK(failed.names_again() == "depth-is-overlap --hunt --cases 60000");
}

TEST_CASE("what fails properties stands in a file until a hunt of them has saved it") {
  const TemporaryFolder folder;
  PropertyHuntPlan plan =
      property_plan_of(too_deep_heptagons(), {"depth-is-overlap", "renumbering"}, 6000);
  plan.save_to = folder.path().string();
  const std::filesystem::path journal = folder.path() / "property-4.jsonl";
  {
    run_property(plan);  // and no more, as of a hunt that is killed
    const Corpus left = read_corpus_folder(folder.path());
    REQUIRE_FALSE(left.cases.empty());
    for (const CorpusCase& one : left.cases) {
      CHECK(one.property == "depth-is-overlap");
      const Property& property = *find_by_name(properties(), one.property);
      CHECK(check(property, plan.subject, one.pair()).kind == PropertyOutcome::Kind::fails);
    }
    std::filesystem::remove(journal);
  }
  const std::vector<CheckedProperty> saved = checked(plan, plan.save_to);
  CHECK(std::ranges::count_if(saved, [](const auto& one) { return !one.saved.empty(); }) == 1);
  CHECK_FALSE(std::filesystem::exists(journal));
}

TEST_CASE("a collider that dies fails the property that asked it, and the hunt goes on") {
  const PropertyHuntPlan plan =
      property_plan_of(dying_of_octagons(), {"never-empty", "renumbering"}, 600);
  const PropertyHunt hunt = run_property(plan);
  CHECK(hunt.cases == 600);
  for (const CheckedProperty& one : checked(plan, "")) {
    CAPTURE(one.property->name);
    if (one.result.passed) continue;
    CHECK(one.result.why == "crashed");
    REQUIRE(one.result.failing.has_value());
    CHECK(one.result.failing->a.polygon.count == 8);
  }
  CHECK(std::ranges::any_of(hunt.hunted,
                            [](const HuntedProperty& one) { return one.first.has_value(); }));
}

TEST_CASE("a property that holds measures more the nearer an answer is to its bound") {
  const Property& property = *find_by_name(properties(), "depth-is-overlap");
  const Vector2<float> box[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair{{make_polygon<float>(box), {}}, {make_polygon<float>(box), {}}};
  pair.b.pose.position = {1.75F, 0.5F};
  double before = 0;
  bool has_failed = false;
  for (double share = 0x1p-26; !has_failed && share < 1; share *= 2) {
    const PropertyOutcome outcome =
        check(property, too_deep(share, [](const PairCase&) { return true; }), pair);
    has_failed = outcome.kind == PropertyOutcome::Kind::fails;
    if (!has_failed) CHECK(outcome.of_bound <= 1);
    CHECK(measure_of(outcome) > before);
    before = measure_of(outcome);
  }
  CHECK(has_failed);
  CHECK(before > 1);
}
