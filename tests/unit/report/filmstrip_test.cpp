#include <catch2/catch.hpp>

#include "report/sequence/sequence_report.hpp"
#include "report/sequence/strip_frames.hpp"
#include "sequence/motions.hpp"
#include "unit/report/svg_reader.hpp"
#include "unit/sequence/keepers.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// A box that rocks on a platform which turns by 8 degrees a frame.
CorpusCase platform(std::size_t frames) {
  CorpusCase known = parse_case(
      R"({"a": {"vertices": [[-3,-0.5],[3,-0.5],[3,0.5],[-3,0.5]]},
          "b": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]]}, "frames": [
          {"a": [0,0,1,0], "b": [0,1.49,1,0]},
          {"a": [0,0,0.990268,0.139173], "b": [-0.20737,1.4755,0.989703,0.143133]},
          {"a": [0,0,0.961262,0.275637], "b": [-0.4107,1.43228,0.962357,0.27179]},
          {"a": [0,0,0.913545,0.406737], "b": [-0.60604,1.36118,0.911911,0.410388]}]})",
      FormatKey::optional, CaseKind::sequence);
  std::vector<FramePoses>& all = std::get<Sequence>(known.any).frames;
  while (all.size() < frames) all.push_back(all.back());
  all.resize(frames);
  return known;
}

JudgedSequence judged(const CorpusCase& given, Mistake mistake) {
  JudgedSequence all{given, keeper_with(mistake), {}, {}};
  all.answers = ask_sequence(all.subject, given.sequence());
  all.judgement = judge_sequence(given.sequence(), all.subject, all.answers);
  return all;
}

}  // namespace

TEST_CASE("a filmstrip has a frame for each frame, and what is wrong in red") {
  const JudgedSequence wrong = judged(platform(4), Mistake::stale_normal);
  REQUIRE(wrong.judgement.bucket.kind == Kind::normal);
  const std::string svg = filmstrip_svg(wrong);
  check_numbers(svg);
  const auto elements = read_svg(svg);
  CHECK(select(elements, "rect", "frame").size() == 4);
  CHECK(select(elements, "rect", "wrong-frame decides").size() == 1);
  const std::string text = all_text(elements);
  for (const char* const words :
       {"is wrong in frame", "frame 0", "frame 3", "kept since frame", "new", "true overlap 0.01",
        "the normal did not turn with its body", "degrees off", "true", "its anchor on A"}) {
    CAPTURE(words);
    CHECK(text.find(words) != std::string::npos);
  }
  std::size_t points = 0;
  for (const KeptAnswer& answer : wrong.answers) {
    points += std::get<KeptManifold>(answer).points.size();
  }
  // One more of each in the legend.
  CHECK(select(elements, "circle", "anchor a").size() == points + 1);
  CHECK(select(elements, "circle", "anchor b").size() == points + 1);
  CHECK(select(elements, "line", "kept wrong").size() >= 2);
  CHECK(select(elements, "line", "truth").size() >= 2);
}

TEST_CASE("what is right is not red, and has no second normal beside its own") {
  const auto elements = read_svg(filmstrip_svg(judged(platform(4), Mistake::none)));
  CHECK(select(elements, "rect", "wrong-frame").empty());
  CHECK(select(elements, "rect", "wrong-frame decides").empty());
  CHECK(select(elements, "line", "kept wrong").size() == 1);  // the legend's
  CHECK(all_text(elements).find("is right in each of 4 frames") != std::string::npos);
}

TEST_CASE("of many frames those are shown that matter") {
  const JudgedSequence wrong = judged(platform(40), Mistake::stale_normal);
  const auto shown = frames_that_matter(wrong);
  CHECK(shown.size() <= kStripMax);
  CHECK(shown.front() == 0);
  CHECK(std::ranges::count(shown, wrong.judgement.frame) == 1);
  CHECK(std::ranges::count(shown, wrong.judgement.frame + 1) == 1);
  CHECK(all_text(read_svg(filmstrip_svg(wrong))).find("of 40 frames") != std::string::npos);
}

TEST_CASE("the text of a sequence says frame by frame what is kept, born, and wrong") {
  const std::string text = sequence_text(judged(platform(3), Mistake::stale_normal));
  for (const char* const words : {"frame 0: right", "frame 2: the normal did not turn", "born",
                                  "kept since frame 1", "overlap 0.01", "bucket", "magnitude"}) {
    CAPTURE(text, words);
    CHECK(text.find(words) != std::string::npos);
  }
}

TEST_CASE("sequences of any motion can be drawn, whatever keeps points") {
  for (const Motion& motion : motions()) {
    for (const Mistake mistake : {Mistake::none, Mistake::stale_normal, Mistake::past_gap}) {
      CorpusCase known;
      known.any = draw_sequence(5, motion, 0);
      const std::string svg = filmstrip_svg(judged(known, mistake));
      CAPTURE(motion.name);
      check_numbers(svg);
      CHECK(read_svg(svg).size() > 10);
    }
  }
}
