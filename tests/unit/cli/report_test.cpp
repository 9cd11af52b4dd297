#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

/// What the page's script reads.
Json data_of(const std::string& html) {
  const std::string start = R"(<script type="application/json" id="data">)";
  const std::size_t begin = html.find(start);
  REQUIRE(begin != std::string::npos);
  const std::size_t from = begin + start.size();
  Json data = Json::parse(html.substr(from, html.find("</script>", from) - from), nullptr, false);
  REQUIRE(data.is_object());
  return data;
}

Json reported(const std::vector<std::string>& paths) {
  const Outcome outcome = run_manifuzz(with({"report", "--output", "-", "--maps", "1"}, paths));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return data_of(outcome.out);
}

const Json& case_named(const Json& data, const std::string& name) {
  for (const Json& known : data["cases"]) {
    if (known["file"].get<std::string>().ends_with(name)) return known;
  }
  FAIL("there is no case " << name);
  return data;
}

std::string in_corpus(const std::string& path) {
  return (source_dir() / "corpus" / path).string();
}

}  // namespace

TEST_CASE("a page tells of a case what its file and the judge say") {
  const Json data =
      reported({in_corpus("defects/box2d/witness-box2d-no-contact-on-tied-features.json")});
  CHECK(data["format"] == "manifuzz/report/1");
  REQUIRE(data["cases"].size() == 1);
  const Json& known = data["cases"][0];
  CHECK(known["verdict"] == "known");
  CHECK(known["subject"] == "clip");
  CHECK(known["oracle"] == "box2d");
  CHECK(known["sentence"].get<std::string>().starts_with("oracle wrong (known): box2d reports no"));
  CHECK(known["separation"].get<double>() < 0);
  REQUIRE(known["answers"].size() == 3);
  CHECK(known["answers"][0]["role"] == "truth");
  CHECK_FALSE(known["answers"][0]["manifolds"].empty());
  CHECK(known["answers"][2]["words"] == "no contact");
  CHECK(known["map"].get<std::string>().starts_with("data:image/png;base64,iVBORw0KGgo"));
  CHECK(Json::parse(known["case"].get<std::string>())["format"] == "manifuzz/case/1");
}

TEST_CASE("a page places points in the world, seen from A's position") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "box.jsonl",
      R"({"a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "position": [10, 20]}, "b": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "position": [10.5, 21.5]}})");
  const Json data = reported({file});
  const Json& known = data["cases"][0];
  CHECK(known["origin"] == Json({10.0, 20.0}));
  CHECK(known["bodies"][0]["vertices"][0] == Json({-1.0, -1.0}));
  CHECK(known["bodies"][1]["vertices"][0] == Json({-0.5, 0.5}));
  const Json& manifold = known["answers"][1]["manifolds"][0];
  CHECK(manifold["reference"] == "a");
  CHECK(manifold["normal"] == Json({0.0, 1.0}));
  REQUIRE(manifold["points"].size() == 2);
  for (const Json& point : manifold["points"]) {
    CHECK(point["depth"] == 0.5);
    CHECK(point["position"][1] == 0.5);
    CHECK(point["world"][1] == 20.5);
  }
}

TEST_CASE("a page places what is drawn of a manifold and of the overlap") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "box.jsonl",
      R"({"a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "radius": 0.25}, "b": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "radius": 0.5, "position": [0.5, 1.5]}})");
  const Json known = reported({file})["cases"][0];
  const Json& manifold = known["answers"][1]["manifolds"][0];
  REQUIRE(manifold["reference"] == "a");
  CHECK(manifold["outward"] == Json({0.0, 1.0}));
  CHECK(manifold["face"] == Json({{1.0, 1.0}, {-1.0, 1.0}}));
  CHECK(manifold["edge"] == Json({{-0.5, 0.5}, {1.5, 0.5}}));
  REQUIRE(manifold["planes"].size() == 2);
  CHECK(manifold["planes"][0][0] == Json({1.75, 1.0}));
  CHECK(manifold["planes"][0][1][0] == 1.75);
  CHECK(manifold["planes"][1][0] == Json({-1.75, 1.0}));
  for (const Json& point : manifold["points"]) {
    CHECK(point["bar"][0] == Json({point["position"][0], 0.0}));
    CHECK(point["bar"][1] == Json({point["position"][0], 1.25}));
  }
  CHECK(known["thinnest"]["thickness"] == 0.5);
  CHECK(known["thinnest"]["center"] == Json({0.25, 0.75}));
  CHECK(known["bodies"][0]["letter"][1] < 0);
  CHECK(known["bodies"][1]["letter"][1] > 1.5);
}

TEST_CASE("a page of a run knows how often a bucket was met, and the command that repeats it") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "found").string();
  const std::string json = folder.path() / "run.json";
  REQUIRE(run_manifuzz({"fuzz", "--regime", "tie_bias", "--radius", "0", "--seed", "2", "--cases",
                        "20000", "--corpus", corpus, "--json", json})
              .status == 0);
  const Json data = reported({corpus, json});
  REQUIRE(data["fuzz"].size() == 1);
  CHECK(data["fuzz"][0]["result"]["cases"] == 20000);
  std::size_t worst = 0;
  for (const Json& known : data["cases"]) {
    CHECK(known["count"].get<int>() > 0);
    CHECK(known["commands"][1].get<std::string>().find(" fuzz ") != std::string::npos);
    if (known["role"] != "worst") continue;
    ++worst;
    CHECK(case_named(data, known["smallest"])["bucket"] == known["bucket"]);
  }
  CHECK(worst > 0);
}

TEST_CASE("the page of a run names what makes it again: where its own cases lie") {
  const TemporaryFolder folder;
  const fs::path corpus = folder.path() / "found";
  const std::string page = folder.path() / "page.html";
  const auto page_of = [&](const std::string& cases) {
    const Outcome outcome =
        run_manifuzz({"fuzz", "--regime", "tie_bias", "--radius", "0", "--seed", "2", "--cases",
                      cases, "--corpus", corpus.string(), "--json", folder.path() / "run.json",
                      "--report", page, "--quiet"});
    REQUIRE(outcome.status == 0);
    return data_of(text_of(page));
  };
  const Json found = page_of("20000");
  REQUIRE(found["cases"].size() > 1);
  const fs::path first(found["cases"][0]["file"].get<std::string>());
  const std::string folders = found["command"].get<std::string>();
  CHECK_THAT(folders, Catch::Contains(" report " + first.parent_path().string()));
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    if (entry.is_regular_file() && entry.path().filename() != first.filename()) fs::remove(entry);
  }
  const Json one = page_of("1");
  REQUIRE(one["cases"].size() == 1);
  CHECK_THAT(one["command"].get<std::string>(), Catch::Contains(" report " + first.string() + ' '));
}

TEST_CASE("nothing in a case ends the page's script") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "evil.json",
      R"({"format": "manifuzz/case/1", "note": "</script><script>alert(1)</script>", "a": {"vertices": [[0,0],[1,0],[0,1]]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}})");
  const Json data = reported({file});
  CHECK(data["cases"][0]["note"] == "</script><script>alert(1)</script>");
}

TEST_CASE("a page names what it could not read, and shows the rest") {
  const TemporaryFolder folder;
  folder.write("broken.json", "{");
  folder.write(
      "good.jsonl",
      R"({"a": {"vertices": [[0,0],[1,0],[0,1]]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}})");
  const std::string page = folder.path() / "page.html";
  const Outcome outcome =
      run_manifuzz({"report", "--quiet", folder.path().string(), "--output", page});
  CHECK(outcome.status == 2);
  CHECK(lines_of(outcome.err).size() == 2);
  const Json data = data_of(text_of(page));
  CHECK(data["cases"].size() == 1);
  REQUIRE(data["errors"].size() == 1);
  CHECK(data["errors"][0].get<std::string>().find("broken.json") != std::string::npos);
}

TEST_CASE("results that are no results are named, and the page has the rest") {
  const TemporaryFolder folder;
  folder.write("a.json", R"({"machine": 5, "subject": 1, "buckets": [1]})");
  folder.write("b.json", R"({"machine": {}, "rows": {"x": 1}})");
  folder.write("c.json", R"({"machine": {}, "sweeps": []})");
  const std::string page = folder.path() / "page.html";
  const Outcome outcome =
      run_manifuzz({"report", "--quiet", folder.path().string(), "--output", page});
  CHECK(outcome.status == 2);
  const auto lines = lines_of(outcome.err);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].ends_with("a.json: $.machine: is a number; an object is expected"));
  CHECK(lines[1].ends_with("b.json: $.rows: is an object; an array is expected"));
  CHECK(data_of(text_of(page))["stress"].size() == 1);
}

TEST_CASE("a page of nothing is an error, and nothing is written") {
  const TemporaryFolder folder;
  const std::string page = folder.path() / "page.html";
  const Outcome outcome = run_manifuzz({"report", folder.path().string(), "--output", page});
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_FALSE(std::filesystem::exists(page));
}

TEST_CASE("a page has a sequence with its verdict and its filmstrip") {
  const Json data = reported({in_corpus("sequences")});
  REQUIRE(data["sequences"].size() == 3);
  const Json& known = data["sequences"][0];
  CHECK(known["subject"] == "cached-bullet");
  CHECK(known["verdict"] == "known");
  CHECK(known["frames"] == 2);
  CHECK(known["sentence"].get<std::string>().starts_with("cached-bullet is wrong in frame 1"));
  CHECK(known["svg"].get<std::string>().find("<svg") != std::string::npos);
  CHECK(known["commands"][0].get<std::string>().ends_with("7483ed7d.json"));
}

TEST_CASE("results nested beyond reason are named, and the page has the rest") {
  const TemporaryFolder folder;
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  folder.write("a.json", "{\"machine\": " + deep + ", \"buckets\": []}");
  folder.write("b.json", "{\"machine\": {}, \"more\": " + deep + ", \"rows\": []}");
  folder.write("c.json", R"({"machine": {}, "sweeps": []})");
  const Outcome outcome =
      run_manifuzz({"report", "--quiet", folder.path().string(), "--output", "-"});
  CHECK(outcome.status == 2);
  const auto lines = lines_of(outcome.err);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].ends_with("a.json: $: nested deeper than 32 levels"));
  CHECK(data_of(outcome.out)["stress"].size() == 1);
}

TEST_CASE("a page is not written over what it is made of") {
  const TemporaryFolder folder;
  const std::string given = R"({"machine": {}, "sweeps": []})";
  const std::string result = folder.write("c.json", given);
  std::filesystem::create_symlink(result, folder.path() / "link");
  for (const std::string& output : {result, (folder.path() / "link").string()}) {
    const Outcome outcome = run_manifuzz({"report", folder.path().string(), "--output", output});
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK(text_of(result) == given);
  }
}
