#include "corpus/corpus.hpp"

#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "kernel/batch.hpp"
#include "scene/scene.hpp"
#include "support/source_tree.hpp"

using namespace manifuzz;

namespace {

/// Both bodies of a case in a scene, B `away` from where the case has it.
class Meeting {
 public:
  explicit Meeting(const PairCase& pair) : pair_(pair) {
    for (const Body* const body : {&pair.a, &pair.b}) {
      const auto shape = scene_.add_shape(body->polygon);
      if (std::holds_alternative<scene::Defect>(shape)) return;
      const auto added = scene_.add(std::get<std::uint32_t>(shape), body->pose);
      if (std::holds_alternative<scene::Defect>(added)) return;
      last_ = std::get<scene::BodyHandle>(added);
      placements_.push_back({shapes_.add(body->polygon), body->pose});
    }
  }

  bool is_possible() const { return placements_.size() == 2; }

  /// Whether the scene's contact is that of the pair alone.
  bool agrees(const Vector2<float>& away) {
    placements_[1].pose.position = pair_.b.pose.position + away;
    const std::vector<scene::Move> moves{{last_, placements_[1].pose}};
    const auto stepped = scene_.step(moves);
    const auto& result = std::get<scene::StepResult>(stepped);
    const std::array<kernel::BodyPair, 1> pairs{{{0, 1}}};
    std::array<Manifold<float>, 1> alone;
    kernel::collide_pairs(shapes_, placements_, pairs, 0, alone);
    if (alone[0].count == 0) return result.contacts.empty();
    return result.contacts.size() == 1 && result.contacts[0].manifold == alone[0];
  }

 private:
  PairCase pair_;
  scene::Scene scene_;
  scene::BodyHandle last_;
  kernel::Shapes<float> shapes_;
  std::vector<kernel::Placement<float>> placements_;
};

/// At distances down to a billionth of both shapes, and back: where the scene's contact is not that
/// of the pair alone.
void check_meeting(const PairCase& pair, Meeting& meeting) {
  const auto size = static_cast<float>(4 * (reach(pair.a.polygon) + pair.a.polygon.radius +
                                            reach(pair.b.polygon) + pair.b.polygon.radius));
  for (int k = -30; k <= 30; ++k) {
    CAPTURE(k);
    const float distance = k == 0 ? 0 : std::ldexp(size, -(30 - std::abs(k)));
    CHECK(meeting.agrees({k < 0 ? distance : -distance, 0.37F * distance}));
  }
}

}  // namespace

TEST_CASE("the pairs of the corpus meet and part in a scene as they do alone") {
  const std::vector<std::filesystem::path> folders{test::source_dir() / "corpus"};
  const Corpus corpus = read_corpus(folders);
  REQUIRE(corpus.cases.size() > 100);
  int met = 0;
  for (const CorpusCase& each : corpus.cases) {
    CAPTURE(each.path);
    Meeting meeting(each.pair());
    if (!meeting.is_possible()) continue;
    ++met;
    check_meeting(each.pair(), meeting);
  }
  CHECK(met > 100);
}

TEST_CASE("pairs of every regime meet and part in a scene as they do alone") {
  for (const auto& regimes : {polygon_regimes(), round_regimes()}) {
    for (const Regime& regime : regimes) {
      CAPTURE(regime.name);
      for (std::uint64_t i = 0; i < 100; ++i) {
        CAPTURE(i);
        const PairCase pair = generate(45, regime, i);
        Meeting meeting(pair);
        if (meeting.is_possible()) check_meeting(pair, meeting);
      }
    }
  }
}
