#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "base/json.hpp"
#include "base/text.hpp"
#include "engines/colliders.hpp"
#include "exchange/json.hpp"
#include "judging/judge.hpp"
#include "judging/manifold_error.hpp"
#include "support/run_program.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// The checkers of corpus/conformance against the judge.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// Cases of the stored suite.
struct Sample {
  std::vector<std::string> lines;
  std::vector<PairCase> pairs;
};

/// Every case in so many.
Sample sample(std::size_t step = 5) {
  const auto all = lines_of(text_of(source_dir() / "corpus/conformance/cases.jsonl"));
  Sample result;
  for (std::size_t i = 0; i < all.size(); i += step) {
    const JsonTree tree = parse_json(all[i]);
    const JsonView view(tree);
    result.lines.push_back(all[i]);
    result.pairs.push_back({read_body(view.at("a")), read_body(view.at("b"))});
  }
  return result;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) (text += line) += '\n';
  return text;
}

/// What is done to an answer number i.
using Damage = std::function<void(Manifold<double>& manifold, std::size_t i)>;

std::vector<std::string> answers_of(const Collider& collider, const std::vector<PairCase>& pairs,
                                    const Damage& damage) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Answer answer = Unsupported{"its shapes"};
    if (takes(collider, pairs[i])) answer = ask(collider, pairs[i]);
    if (auto* const manifold = std::get_if<Manifold<double>>(&answer)) damage(*manifold, i);
    append_answer(lines.emplace_back(), pairs[i], collider.declaration.name, answer);
  }
  return lines;
}

/// "right", "wrong" or "unsupported" of each, as a port in that scalar.
std::vector<std::string> judged(const std::vector<std::string>& answers,
                                const std::vector<PairCase>& pairs, ScalarType scalar) {
  const Declaration port{.name = "port", .scalar = scalar};
  std::vector<std::string> words;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const JsonTree tree = parse_json(answers[i]);
    const Answer answer =
        whole(read_reported_answer(JsonView(tree), pairs[i], conventions_of(port)), pairs[i], port);
    const auto truth = std::make_shared<const exact::Truth>(pairs[i]);
    const Bucket bucket = judge_alone(truth, {port, answer}).bucket;
    words.emplace_back(bucket.verdict == Verdict::unsupported ? "unsupported"
                       : bucket.fault == Fault::none          ? "right"
                                                              : "wrong");
  }
  return words;
}

struct Checker {
  std::string program;
  std::string script;

  std::vector<std::string> command() const {
    return {program, (source_dir() / "corpus/conformance" / script).string()};
  }
};

const std::vector<Checker> kCheckers{{"python3", "check.py"}, {"node", "check.mjs"}};

bool is_there(const Checker& checker) {
  if (run_program({"sh", "-c", "command -v " + checker.program}).status == 0) return true;
  skip(checker.program + " is not installed");
  return false;
}

/// What the checker says of each answer, in the judge's words.
std::vector<std::string> checked(const Checker& checker, const Sample& sample,
                                 const std::vector<std::string>& answers, ScalarType scalar) {
  const TemporaryFolder folder;
  const std::string cases = folder.write("cases.jsonl", joined(sample.lines));
  const std::string file = folder.write("answers.jsonl", joined(answers));
  const Outcome outcome = run_program(
      with(checker.command(), {"--each", "--cases", cases, "--scalar",
                               scalar == ScalarType::float32 ? "float32" : "float64", file}));
  CHECK(outcome.err.empty());
  CHECK(outcome.status <= 1);
  auto words = lines_of(outcome.out);
  const bool has_failed = words.back().starts_with("fail");
  CHECK(outcome.status == (has_failed ? 1 : 0));
  words.pop_back();
  for (std::string& word : words) {
    word = word.substr(word.find(": ") + 2);
    if (word != "right" && word != "unsupported") word = "wrong";
  }
  return words;
}

/// By a share of what it is, and by a share of the largest bounds that there are.
void shift(double& figure, std::size_t i) {
  constexpr double kShares[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 1e-15};
  figure += figure * kShares[i % std::size(kShares)];
}

const std::vector<std::pair<std::string, Damage>> kDamages{
    {"none", [](Manifold<double>&, std::size_t) {}},
    {"a position", [](Manifold<double>& m, std::size_t i) { shift(m.points[0].position.x(), i); }},
    {"a depth", [](Manifold<double>& m, std::size_t i) { shift(m.points[i % 2].depth, i / 2); }},
    {"the normal", [](Manifold<double>& m, std::size_t i) { shift(m.normal.y(), i); }},
    {"a point less", [](Manifold<double>& m, std::size_t) { m.count = std::max(m.count - 1, 0); }},
    {"the other reference",
     [](Manifold<double>& m, std::size_t) { m.reference = other(m.reference); }},
    {"other features",
     [](Manifold<double>& m, std::size_t) { m.points[0].features = m.points[1].features; }},
    {"a reversed normal", [](Manifold<double>& m, std::size_t) { m.normal = -m.normal; }}};

}  // namespace

TEST_CASE("our colliders that clip pass the conformance suite by both checkers") {
  const Sample cases = sample();
  for (const Checker& checker : kCheckers) {
    if (!is_there(checker)) return;
    for (const char* const name : {"clip", "clip64", "pair", "batch", "batch64", "gjk-clip"}) {
      CAPTURE(checker.script, name);
      const Collider collider = find_collider(name);
      const auto answers = answers_of(collider, cases.pairs, kDamages[0].second);
      const auto words = checked(checker, cases, answers, collider.declaration.scalar);
      CHECK(std::ranges::count(words, "right") > 200);
      CHECK(std::ranges::count(words, "wrong") == 0);
    }
  }
}

TEST_CASE("both checkers agree with the judge on answers of engines, and on damaged ones",
          "[longer]") {
  const Sample cases = sample();
  for (const Checker& checker : kCheckers) {
    if (!is_there(checker)) return;
    for (const char* const name : {"clip", "clip64", "box2d"}) {
      const Collider collider = find_collider(name);
      const ScalarType scalar = collider.declaration.scalar;
      std::size_t wrong = 0;
      for (const auto& [what, damage] : kDamages) {
        CAPTURE(checker.script, name, what);
        const auto answers = answers_of(collider, cases.pairs, damage);
        const auto right = judged(answers, cases.pairs, scalar);
        CHECK(checked(checker, cases, answers, scalar) == right);
        wrong += static_cast<std::size_t>(std::ranges::count(right, "wrong"));
      }
      CHECK(wrong > 500);
    }
  }
}

TEST_CASE("a planted bug fails the suite where its answers do, and an unedited copy's never") {
  if (!is_there(kCheckers[0])) return;
  const std::string script = (source_dir() / "tests/conformance/planted_bugs").string();
  const Sample cases = sample(1);
  const Collider clip = find_collider("clip");
  const auto right = answers_of(clip, cases.pairs, kDamages.front().second);
  const auto reversed = answers_of(clip, cases.pairs, kDamages.back().second);
  const TemporaryFolder folder;
  folder.write("edits.unedited_copy.clip.float32.jsonl", joined(right));
  folder.write("edits.no_bug.clip.float32.jsonl", joined(right));
  folder.write("edits.reversed.clip.float32.jsonl", joined(reversed));
  const Outcome outcome = run_program({"python3", script, folder.path().string()});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::StartsWith("edits.no_bug passes\nedits.reversed clip "));
  CHECK_THAT(outcome.out,
             Catch::EndsWith("edits.unedited_copy passes\n"
                             "1 of 2 bugs fail the suite; 0 of 1 unedited copies do\n"));
  folder.write("edits.unedited_copy.clip.float32.jsonl", joined(reversed));
  CHECK(run_program({"python3", script, folder.path().string()}).status == 1);
}

TEST_CASE("a checker asks a program about what it declares that it takes") {
  for (const Checker& checker : kCheckers) {
    if (!is_there(checker)) return;
    CAPTURE(checker.script);
    const std::string program = (source_dir() / "scripts/colliders/python/clip.py").string();
    const Outcome outcome = run_program(with(checker.command(), {"--", "python3", program}));
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.out, Catch::StartsWith("pass: 0 of ") && Catch::EndsWith("as float64\n"));
  }
}

TEST_CASE("both checkers say the same of answers that are odd") {
  constexpr const char* kPoint =
      R"({"points": [{"local": [0, 0], "depth": 0.5}], "normal": [1, 0])";
  const std::vector<std::string> odd{
      "null",
      "5",
      "[]",
      R"("no")",
      "{}",
      R"({"points": null})",
      R"({"points": [], "normal": null})",
      R"({"unsupported": null})",
      R"({"points": [5], "normal": [1, 0]})",
      R"({"points": [null], "normal": [1, 0]})",
      R"({"points": [[]], "normal": [1, 0]})",
      R"({"points": [{"local": null, "position": [0, 0], "depth": 0.5}], "normal": [1, 0]})",
      R"({"points": [{"local": [true, 0], "depth": 0.5}], "normal": [1, 0]})",
      R"({"points": [{"local": [1e999, 0], "depth": 0.5}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": true}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": null}], "depth": 0.5, "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0]}], "depth": -1, "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5}], "normal": [1, 0, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5}]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5, "features": null}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5, "features": []}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5, "features": ["f0"]}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5, "features": "f0"}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5, "features": [["f0"], "v0"]}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5, "features": ["f0", "v0", "v0"]}], "normal": [1, 0]})",
      R"({"points": [{"local": [0, 0], "depth": 0.5, "features": ["f0", "v9"]}], "normal": [1, 0]})",
      std::string(kPoint) + R"(, "reference": null})",
      std::string(kPoint) + R"(, "reference": "c"})",
      std::string(kPoint) + R"(, "reference": false})",
      std::string(kPoint) + "}"};
  const TemporaryFolder folder;
  const std::string line = lines_of(text_of(source_dir() / "corpus/conformance/cases.jsonl"))[0];
  const std::string cases =
      folder.write("cases.jsonl", joined(std::vector<std::string>(odd.size(), line)));
  const std::string answers = folder.write("answers.jsonl", joined(odd));
  std::vector<std::string> said;
  for (const Checker& checker : kCheckers) {
    if (!is_there(checker)) return;
    const Outcome outcome =
        run_program(with(checker.command(), {answers, "--cases", cases, "--each"}));
    CHECK(outcome.status == 1);
    const auto is_malformed = [](const std::string& row) {
      return row.find(": malformed: ") != row.npos;
    };
    CHECK(std::ranges::count_if(lines_of(outcome.out), is_malformed) == 23);
    said.push_back(outcome.out);
    const std::string nan = folder.write("nan.jsonl", "{\"points\": NaN}\n");
    CHECK_THAT(run_program(with(checker.command(), {nan})).err,
               Catch::Contains("nan.jsonl:1: no JSON"));
    const Outcome full =
        run_program({"/bin/sh", "-c", "\"$@\" >/dev/full", "sh", checker.command()[0],
                     checker.command()[1], answers, "--cases", cases});
    CHECK(full.status == 2);
    CHECK(is_one_clear_line(full.err));
  }
  CHECK(said[0] == said[1]);
}

TEST_CASE("bad input to a checker is one line on what is wrong, and status 2") {
  const TemporaryFolder folder;
  const std::string few = folder.write("few.jsonl", "{\"points\": []}\n");
  const std::string broken = folder.write("broken.jsonl", "{\"points\": []}\n{\n");
  const std::string biased = folder.write("bias", R"({"declaration": {"tie_bias": 0.0005}})");
  const std::string named = folder.write("named.jsonl", "{\"declaration\": \"mine\"}\n");
  const std::string unsupported = folder.write(
      "unsupported.jsonl", R"({"unsupported": "", "format": "manifuzz/conformance/1"})");
  for (const Checker& checker : kCheckers) {
    if (!is_there(checker)) return;
    const std::vector<std::pair<std::vector<std::string>, std::string>> bad{
        {{few}, "1 answers; 2000 are expected"},
        {{broken}, "broken.jsonl:2: no JSON"},
        {{biased}, "declares tie_bias 0.0005"},
        {{folder.path().string() + "/none"}, "none"},
        {{named}, "its declaration is no object"},
        {{unsupported, "--cases", unsupported}, "a case of manifuzz/conformance/1 is expected"},
        {{"--", "false"}, "false ended with status 1"},
        {{}, "either a file of answers or, after --, a command is expected"}};
    for (const auto& [words, expected] : bad) {
      CAPTURE(checker.script, expected);
      const Outcome outcome = run_program(with(checker.command(), words));
      CHECK(outcome.status == 2);
      CHECK(is_one_clear_line(outcome.err));
      CHECK_THAT(outcome.err, Catch::Contains(expected));
    }
  }
}
