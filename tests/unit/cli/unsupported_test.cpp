#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/report/svg_reader.hpp"

// What commands make of a case that one of both colliders cannot take.

using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// Two circles, which `gjk-clip` does not take.
std::string circles() {
  return R"({"format": "manifuzz/case/2", "a": {"vertices": [[0,0]], "radius": 1}, )"
         R"("b": {"vertices": [[0,0]], "radius": 1, "position": [1.5,0]}})";
}

/// Two triangles, which each does.
std::string triangles() {
  return R"({"format": "manifuzz/case/1", "a": {"vertices": [[0,0],[1,0],[0,1]]}, )"
         R"("b": {"vertices": [[0,0],[1,0],[0,1]], "position": [0.5,0]}})";
}

}  // namespace

TEST_CASE("replay counts what is unsupported apart, and does not fail for it") {
  const TemporaryFolder folder;
  folder.write("circles.json", circles());
  folder.write("triangles.json", triangles());
  const std::string junit = (folder.path() / "junit.xml").string();
  const std::vector<std::string> replay{"replay", folder.path().string(), "--subject", "gjk-clip"};
  const Outcome text = run_manifuzz(with(replay, {"--junit", junit}));
  INFO(text.out << text.err);
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Contains("2 cases, 1 passed, 0 failed"));
  CHECK_THAT(text.out, Contains("; 1 unsupported, for a collider cannot take them"));
  const auto elements = read_svg(text_of(junit));
  CHECK(elements[1].attributes.at("skipped") == "1");
  CHECK(elements[3].name == "skipped");
  CHECK(elements[3].attributes.at("message") == "unsupported: gjk-clip or box2d cannot take it");
  const auto json = nlohmann::json::parse(run_manifuzz(with(replay, {"--json", "-"})).out);
  CHECK(json["cases"] == 2);
  CHECK(json["passed"] == 1);
  CHECK(json["failed"] == 0);
  CHECK(json["unsupported"] == 1);
  CHECK(json["failures"].empty());
}

TEST_CASE("shrink refuses a case that a collider cannot take") {
  const Outcome outcome = run_manifuzz({"shrink", "-", "--subject", "gjk-clip"}, circles());
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains("gjk-clip or box2d cannot take it"));
}

TEST_CASE("a campaign saves what is unsupported as it was met, without shrinking it") {
  const TemporaryFolder folder;
  const Outcome outcome = run_manifuzz({"fuzz", "--corpus", folder.path().string(), "--regime",
                                        "circles", "--seed", "1", "--cases", "20", "--subject",
                                        "gjk-clip", "--shrink-seconds", "0", "--json", "-"});
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["unshrunk"] == 0);
  CHECK(run_manifuzz({"shrink", folder.path().string()}).status == 0);
}
