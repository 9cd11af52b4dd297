#include <filesystem>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/report/sample.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

std::string case_line() {
  std::string line;
  append_case_line(line, box_on_box(0.25F));
  return line + '\n';
}

}  // namespace

TEST_CASE("show writes the text, and the picture where it is asked for") {
  const TemporaryFolder folder;
  const std::string file = folder.write("case.jsonl", case_line());
  const std::string picture = (folder.path() / "new" / "case.svg").string();
  const Outcome outcome = run_manifuzz({"show", file, "--svg", picture});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Contains("agree within rounding"));
  CHECK_THAT(all_text(read_svg(text_of(picture))), Contains("agree within rounding"));
  CHECK(text_of(picture).find(folder.path().string()) == std::string::npos);
}

TEST_CASE("show shows the answer of a collider that says which shapes it used") {
  const TemporaryFolder folder;
  const std::string file = folder.write("case.jsonl", case_line());
  const Outcome outcome = run_manifuzz({"show", file, "--subject", "gjk-shrunk"});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("1 point"));
}

TEST_CASE("show - reads stdin, --svg - writes the picture alone") {
  const Outcome outcome = run_manifuzz({"show", "-", "--svg", "-"}, case_line());
  CHECK(outcome.status == 0);
  CHECK(read_svg(outcome.out).front().name == "svg");
  CHECK(run_manifuzz({"show", "-", "--svg", "-"}, case_line()).out == outcome.out);
}

TEST_CASE("the colliders are those asked for, else the recorded ones, else clip and box2d") {
  const TemporaryFolder folder;
  CorpusCase recorded;
  recorded.any = box_on_box(0.25F);
  recorded.expect = Expectation{"clip64", "clip", {}, {}, {}};
  const std::string file = folder.write("case.json", format_case(recorded));
  const std::string by_record = run_manifuzz({"show", file}).out;
  CHECK_THAT(by_record, Contains("subject: clip64 ") && Contains("oracle: clip "));
  const std::string asked = run_manifuzz({"show", file, "--subject", "box2d"}).out;
  CHECK_THAT(asked, Contains("subject: box2d ") && Contains("oracle: clip "));
  const std::string usual = run_manifuzz({"show", "-"}, case_line()).out;
  CHECK_THAT(usual, Contains("subject: clip ") && Contains("oracle: box2d "));
}

TEST_CASE("show --map writes the map and says how severe the case is") {
  const TemporaryFolder folder;
  const std::string file = folder.write("case.jsonl", case_line());
  const std::string map = (folder.path() / "new" / "map.png").string();
  const Outcome outcome = run_manifuzz({"show", file, "--map", map, "--map-step", "8"});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Contains("a step being 8 ulps"));
  CHECK_THAT(outcome.out, Contains("severity 0: somebody is wrong on 0 of 16641 neighbours"));
  CHECK(text_of(map).starts_with("\x89PNG\r\n\x1a\n"));
  CHECK(read_svg(run_manifuzz({"show", file, "--map", map, "--svg", "-"}).out).size() > 1);
}

TEST_CASE("show refuses bad input in one line") {
  const TemporaryFolder folder;
  const std::string good = folder.write("case.jsonl", case_line());
  const std::string map = (folder.path() / "map.png").string();
  const std::string full_disk = (folder.path() / "full.png").string();
  std::filesystem::create_symlink("/dev/full", full_disk);
  const std::string a_folder = (folder.path() / "folder.png").string();
  std::filesystem::create_directory(a_folder);
  const std::vector<std::vector<std::string>> all = {
      {"show"},
      {"show", (folder.path() / "none.json").string()},
      {"show", folder.path().string()},
      {"show", folder.write("broken.json", "{\"a\": 1}")},
      {"show", folder.write("empty.json", "")},
      {"show", good, "--subject", "clop"},
      {"show", good, "--oracle", "clop"},
      {"show", good, "--svg", folder.path().string()},
      {"show", good, "--svg", good + "/case.svg"},
      {"show", good, "--svg", (folder.path() / "case.jpg").string()},
      {"show", good, "--svg", (folder.path() / "case").string()},
      {"show", good, "--map", (folder.path() / "map.svg").string()},
      {"show", good, "--map", "-"},
      {"show", good, "--map", ""},
      {"show", good, "--map", good + "/map.png"},
      {"show", good, "--map", full_disk},
      {"show", good, "--map", a_folder},
      {"show", good, "--map-step", "2"},
      {"show", good, "--map", map, "--map-step", "0"},
      {"show", good, "--map", map, "--map-step", "-1"},
      {"show", good, "--map", map, "--map-step", "100001"},
  };
  for (const auto& arguments : all) {
    const Outcome outcome = run_manifuzz(arguments);
    CAPTURE(arguments, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(is_one_clear_line(outcome.err));
    CHECK_FALSE(std::filesystem::exists(map));
  }
}

TEST_CASE("every defect in the corpus has its picture") {
  int pictures = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(source_dir() / "corpus/defects")) {
    std::filesystem::path file = entry.path();
    if (file.extension() != ".json" || file.stem().extension() == ".worst") continue;
    INFO(file);
    CHECK(std::filesystem::exists(file.replace_extension(".svg")));
    ++pictures;
  }
  CHECK(pictures > 10);
}

TEST_CASE("a polygon that rounding leaves no thickness is drawn") {
  const auto file =
      source_dir() / "corpus/defects/box2d/oracle-known-missed_contact-none-a-gross-0103adb7.json";
  const Outcome outcome = run_manifuzz({"show", file.string(), "--svg", "-"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("</svg>"));
}
