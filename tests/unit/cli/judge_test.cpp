#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/bad_cases.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using nlohmann::json;

namespace {

// Two boxes of side 2, B's left side a quarter inside A's right one, and half a length up.
const std::string kBoxes =
    R"({"a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]]}, )"
    R"("b": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "position": [1.75,0.5]}})";

const std::string kRight = R"({"normal": [1,0], "points": [{"position": [0.75,1], "depth": 0.25}, )"
                           R"({"position": [0.75,-0.5], "depth": 0.25}]})";

json judge_answer(const std::string& answer, int status) {
  const TemporaryFolder folder;
  const std::string answers = folder.write("answers.jsonl", answer + "\n");
  const Outcome outcome = run_manifuzz({"judge", "--manifolds", answers}, kBoxes + "\n");
  INFO(outcome.err);
  CHECK(outcome.status == status);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("a judgement has what the contract fixes, in figures anyone can check") {
  const Outcome outcome = run_manifuzz({"judge"}, kBoxes + "\n");
  CHECK(outcome.status == 0);
  const json got = json::parse(outcome.out);
  CHECK(got["separation"] == -0.25);
  CHECK(got["touching"] == true);
  CHECK(got["condition"] == 1.0);
  CHECK(got["verdict"] == "agree");
  CHECK(got["bucket"] == "none/agree/none/none/a");
  for (const char* bound : {"separation", "position", "depth", "normal"}) {
    CHECK(got["bound"][bound] > 0);
    CHECK(got["bound"][bound] < 1e-5);
  }
  CHECK(got["penetration"] == json::parse(R"({"depth": 0.25, "normals": [[1, 0]]})"));
  REQUIRE(got["admissible"].size() == 2);  // A's right side and B's left one tie
  const json& of_a = got["admissible"][0];
  CHECK(of_a["normal"] == json::parse("[1.0, 0.0]"));
  CHECK(of_a["reference"] == "a");
  CHECK(of_a["points"][0]["depth"] == 0.25);
  CHECK(of_a["points"][0]["position"] == json::parse("[0.75, -0.5]"));
  CHECK(of_a["points"][1]["position"] == json::parse("[0.75, 1.0]"));
}

TEST_CASE("no contact is among what is right where the polygons are apart") {
  std::string apart = kBoxes;
  apart.replace(apart.find("1.75"), 4, "2.75");
  const json got = json::parse(run_manifuzz({"judge"}, apart + "\n").out);
  CHECK(got["touching"] == false);
  CHECK(got["condition"].is_null());
  CHECK(got["penetration"] == json::parse(R"({"depth": -0.75, "normals": [[1, 0]]})"));
  CHECK(got["admissible"] == json::parse(R"([{"points": []}])"));
}

TEST_CASE("answers in a file may leave out reference and features") {
  CHECK(judge_answer(kRight, 0)["verdict"] == "agree");
}

TEST_CASE("wrong answers in a file are the subject's, and status 1") {
  std::string wrong = kRight;
  wrong.replace(wrong.find("0.25"), 4, "0.26");
  CHECK(judge_answer(wrong, 1)["bucket"] == "subject/subject_wrong/depth/reference/a/fine");
  CHECK(judge_answer(R"({"points": []})", 1)["bucket"] ==
        "subject/subject_wrong/missed_contact/reference/a/gross");
  std::string features = kRight;
  features.replace(features.find("\"depth\": 0.25"), 13,
                   "\"depth\": 0.25, \"features\": [\"f3\",\"v3\"]");
  CHECK(judge_answer(features, 0)["verdict"] == "agree");  // a tie decides no features
}

TEST_CASE("an answer that cannot be is an answer") {
  CHECK(judge_answer(R"({"unsupported": "too round"})", 0)["verdict"] == "unsupported");
}

TEST_CASE("a known verdict names its entry of the ledger, and no other does") {
  const std::string witness =
      MANIFUZZ_SOURCE_DIR "/corpus/defects/box2d/witness-box2d-no-contact-under-bias.json";
  std::string line = text_of(witness);
  std::erase(line, '\n');
  const json known = json::parse(run_manifuzz({"judge"}, line + "\n").out);
  CHECK(known["verdict"] == "known");
  CHECK(known["ledger"] == "box2d-no-contact-under-bias");
  CHECK_FALSE(json::parse(run_manifuzz({"judge"}, kBoxes + "\n").out).contains("ledger"));
}

TEST_CASE("answers stay with their cases across bad lines") {
  const TemporaryFolder folder;
  const std::string answers = folder.write(
      "answers.jsonl", kRight + "\n{\"error\": \"no\", \"line\": 2}\n" + kRight + "\n");
  const Outcome outcome =
      run_manifuzz({"judge", "--manifolds", answers}, kBoxes + "\n\nnonsense\n" + kBoxes + "\n");
  CHECK(outcome.status == 2);
  const auto lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 3);
  CHECK(json::parse(lines[0])["verdict"] == "agree");
  CHECK(json::parse(lines[1])["line"] == 3);
  CHECK(json::parse(lines[2])["verdict"] == "agree");
}

TEST_CASE("answers too many, too few or broken are refused") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& complaint) {
    const std::string answers = folder.write("answers.jsonl", text);
    const Outcome outcome = run_manifuzz({"judge", "--manifolds", answers}, kBoxes + "\n");
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK(outcome.err.find(complaint) != std::string::npos);
  };
  refused("", "fewer answers than cases");
  refused(kRight + "\n" + kRight + "\n", ":2: more answers than cases");
  refused("{}\n", "points");
  refused(R"({"points": [{"depth": 1}], "normal": [1,0]})", "neither \"position\" nor \"local\"");
  refused(R"({"points": [{"local": [0,0]}], "normal": [1,0]})", "depth");
  refused(R"({"points": [{"local": [0,0], "depth": 1}]})", "normal");
  refused(R"({"points": [1,2,3]})", "0 to 2");
  refused(R"({"points": [{"local": [0,0], "depth": 1, "features": ["f9","v0"]}], "normal": [1,0]})",
          "index below 4");
}

TEST_CASE("where the scalar may overflow the case is ill-posed, and the lines behind it go on") {
  const std::string huge = R"({"vertices": [[-1e38,-1e38],[1e38,-1e38],[1e38,1e38],[-1e38,1e38]]})";
  const std::string line = R"({"a": )" + huge + R"(, "b": )" + huge + "}\n";
  const Outcome outcome = run_manifuzz({"judge"}, line + kBoxes + "\n");
  CHECK(outcome.status == 0);
  const std::size_t end = outcome.out.find('\n');
  const json first = json::parse(outcome.out.substr(0, end));
  CHECK(first["verdict"] == "ill_posed");
  CHECK(first["bound"]["separation"].is_null());
  CHECK(first["admissible"].empty());
  CHECK(json::parse(outcome.out.substr(end))["verdict"] == "agree");
}

TEST_CASE("huge radii end no campaign, and a bias beyond float is refused") {
  for (const char* radius : {"1e5", "1e38", "1.7e38"}) {
    CAPTURE(radius);
    const TemporaryFolder folder;
    const Outcome outcome =
        run_manifuzz({"fuzz", "--radius", radius, "--seed", "17", "--cases", "2000", "--corpus",
                      folder.path().string(), "--judge-every", "1", "--verbose"});
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find("crashed                        0") != std::string::npos);
  }
  CHECK(run_manifuzz({"fuzz", "--tie-bias", "1e300", "--cases", "10", "--no-save"}).status == 2);
}
