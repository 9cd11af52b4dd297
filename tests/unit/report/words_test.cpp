#include "report/words.hpp"

#include <catch2/catch.hpp>

#include "unit/report/sample.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

TEST_CASE("numbers in labels are short") {
  CHECK(brief(0.31) == "0.31");
  CHECK(brief(-0.0) == "0");
  CHECK(brief(1.0 / 3) == "0.3333");
  CHECK(brief(20000) == "20000");
  CHECK(brief(-123456) == "-123456");
  CHECK(brief(1e7) == "1e+07");
  CHECK(brief(1e-9) == "1e-09");
}

TEST_CASE("agreement says what they agree on") {
  CHECK(verdict_sentence(judged_case(box_on_box(0.25F))) ==
        "agree within rounding: clip and box2d report 2 points, depths 0.25 and 0.25");
  CHECK(verdict_sentence(judged_case(box_on_box(-0.5F))) ==
        "agree: clip and box2d report no contact, gap 0.5");
}

TEST_CASE("what lies between the polygons") {
  CHECK(truth_in_words(box_on_box(0.25F)) == "overlap 0.25");
  CHECK(truth_in_words(box_on_box(-0.5F)) == "gap 0.5");
  CHECK(truth_in_words(box_on_box(-0.25F, 0.5F)) == "depth 0.25");
  CHECK(truth_in_words(box_on_box(0)) == "overlap 0");
}

TEST_CASE("each verdict has its sentence") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.judgement.magnitude = 0.5;
  const auto sentence = [&](Verdict verdict, Kind kind, Fault fault) {
    judged.judgement.bucket.verdict = verdict;
    judged.judgement.bucket.kind = kind;
    judged.judgement.bucket.fault = fault;
    return verdict_sentence(judged);
  };
  CHECK(sentence(Verdict::known, Kind::missed_contact, Fault::oracle) ==
        "oracle wrong (known): box2d reports no contact, true overlap 0.25");
  CHECK(sentence(Verdict::subject_wrong, Kind::depth, Fault::subject) ==
        "subject wrong: a depth of clip is off by 0.7071");
  CHECK(sentence(Verdict::oracle_wrong, Kind::normal, Fault::oracle) ==
        "oracle wrong: the normal of box2d is off by 0.5");
  CHECK(sentence(Verdict::both_wrong, Kind::position, Fault::both) ==
        "both wrong: a point of clip is off by 0.7071, and box2d is wrong too");
  CHECK(sentence(Verdict::subject_wrong, Kind::count, Fault::subject) ==
        "subject wrong: clip leaves out a point of depth 0.7071");
  CHECK(sentence(Verdict::crashed, Kind::none, Fault::oracle) ==
        "crashed: box2d died on this case");
  CHECK(sentence(Verdict::timed_out, Kind::none, Fault::subject) ==
        "timed out: clip gave no answer in time");
  CHECK(sentence(Verdict::malformed, Kind::none, Fault::oracle) ==
        "malformed: box2d answered nonsense");
  for (std::size_t verdict = 0; verdict < kVerdictNames.size(); ++verdict) {
    for (std::size_t kind = 0; kind < kKindNames.size(); ++kind) {
      const std::string text =
          sentence(static_cast<Verdict>(verdict), static_cast<Kind>(kind), Fault::subject);
      CAPTURE(kVerdictNames[verdict], kKindNames[kind]);
      CHECK(text.size() > 20);
      CHECK(text.find("  ") == std::string::npos);
    }
  }
}

TEST_CASE("what a collider answered") {
  DeclaredAnswer asked = judged_case(box_on_box(0.25F)).subject;
  CHECK(answer_in_words(asked) == "2 points, depths 0.25 and 0.25");
  asked.answer = Unsupported{"too many vertices"};
  CHECK(answer_in_words(asked) == "unsupported: too many vertices");
  asked.answer = Lost{Lost::How::crashed, "crashed"};
  CHECK(answer_in_words(asked) == "crashed");
}

TEST_CASE("an unsupported case says why") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.oracle.answer = Unsupported{"rounded polygons"};
  judged.judgement.bucket = {.verdict = Verdict::unsupported};
  CHECK(verdict_sentence(judged) == "unsupported: box2d cannot take this case: rounded polygons");
}
