#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "judging/admissible.hpp"
#include "support/source_tree.hpp"

// What the corpus says is right, the judge still says is right, to the last digit.

using namespace manifuzz;

namespace {

/// What the file says is right.
std::vector<Manifold<double>> recorded_as_right(const Expectation& expect) {
  std::vector<Manifold<double>> manifolds;
  for (const NamedAnswer& named : expect.manifolds) {
    if (named.collider == kJudgeName) manifolds.push_back(std::get<Manifold<double>>(named.answer));
  }
  return manifolds;
}

void check_same(const Manifold<double>& now, const Manifold<double>& recorded) {
  constexpr double rounding = 1e-15;  // of the normal's way into the world and back
  REQUIRE(now.count == recorded.count);
  if (now.count == 0) return;
  CHECK(now.reference == recorded.reference);
  CHECK((now.normal - recorded.normal).norm() <= rounding);
  for (int i = 0; i < now.count; ++i) {
    CHECK(now.points[i].position == recorded.points[i].position);
    CHECK(now.points[i].depth == recorded.points[i].depth);
    CHECK(now.points[i].features == recorded.points[i].features);
  }
}

}  // namespace

TEST_CASE("what the corpus says is right is what the judge says is right") {
  const std::filesystem::path folders[] = {test::source_dir() / "corpus"};
  const Corpus corpus = read_corpus(folders);
  int compared = 0;
  for (const CorpusCase& recorded : corpus.cases) {
    if (!recorded.expect) continue;
    INFO(recorded.path);
    const auto expected = recorded_as_right(*recorded.expect);
    if (expected.empty()) continue;
    const Collider subject = find_collider(recorded.expect->subject);
    const auto now = right_manifolds(admissible(recorded.pair(), subject.declaration));
    REQUIRE(now.size() == expected.size());
    for (std::size_t i = 0; i < now.size(); ++i) check_same(now[i], expected[i]);
    ++compared;
  }
  CHECK(compared > 30);
}
