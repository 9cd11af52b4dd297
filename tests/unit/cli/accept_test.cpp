#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "support/bad_cases.hpp"
#include "support/permissions.hpp"
#include "unit/cli/one_eyed.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

Outcome list(const TemporaryFolder& folder) {
  return run_manifuzz({"accept", "--list", "--corpus", corpus_in(folder)});
}

Outcome drop(const TemporaryFolder& folder, const std::string& file) {
  return run_manifuzz({"accept", "--drop", file, "--corpus", corpus_in(folder)});
}

void check_not_accepted(const Outcome& outcome, const std::string& complaint) {
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains(complaint));
}

}  // namespace

TEST_CASE("accept says what is accepted in a line a file, which the file has then") {
  const TemporaryFolder folder;
  const std::string file = save_findings(folder, one_eyed(folder)).front();
  const std::string before = text_of(file);
  const Outcome outcome =
      accept(folder, {file},
             {"--link", "https://example.org/7", "--until", "2027-01-31", "--up-to", "0.5"});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.starts_with("accepted " + file + ": subject/"));
  CHECK(lines_of(outcome.out).size() == 1);
  CHECK_THAT(outcome.out,
             Contains(" of one_eyed, up to 0.5 of the size in missing, until 2027-01-31"));
  const CorpusCase known = read_case_file(file);
  REQUIRE(known.accepted);
  CHECK(known.accepted->because == "known since 2.3");
  CHECK(known.accepted->link == "https://example.org/7");
  CHECK(known.accepted->until == "2027-01-31");
  CHECK((*known.accepted->errors_up_to)[Component::missing] == 0.5);
  CHECK(known.accepted->per_million.contains("boxes"));
  CHECK(drop(folder, file).status == 0);
  CHECK(text_of(file) == before);
}

TEST_CASE("without more than a reason three times the worst is accepted, and a rate a regime") {
  const TemporaryFolder folder;
  const std::string file = accept_findings(folder, one_eyed(folder)).front();
  const CorpusCase known = read_case_file(file);
  const Seen seen = known.found->seen.value();
  CHECK((*known.accepted->errors_up_to)[Component::missing] == 3 * seen.magnitude);
  CHECK(known.accepted->until.empty());
  REQUIRE(seen.regimes.size() == 1);
  CHECK(known.accepted->per_million.at("boxes") ==
        accepted_per_million(seen.regimes.at("boxes"), seen.cases));
}

TEST_CASE("what is accepted is listed, a line each, until it is dropped") {
  const TemporaryFolder folder;
  CHECK(list(folder).status == 0);  // there is no corpus yet
  const auto files = accept_findings(folder, one_eyed(folder), {"--until", "2026-01-31"});
  const auto lines = lines_of(list(folder).out);
  REQUIRE(lines.size() == files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    CHECK(lines[i].starts_with("accepted " + files[i] + ": subject/"));
    CHECK_THAT(lines[i], Contains("until 2026-01-31") && Contains(": known since 2.3"));
  }
  CHECK(drop(folder, files.front()).status == 0);
  CHECK(lines_of(list(folder).out).size() == files.size() - 1);
  check_not_accepted(drop(folder, files.front()), "is not accepted");
}

TEST_CASE("by its kind one file stands for all of the corpus that have its kind and subject") {
  const TemporaryFolder folder;
  const auto files = save_findings(folder, one_eyed(folder));
  const Outcome outcome = accept(folder, {files.front()}, {"--kind"});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  const std::string kind = "missed_contact";
  REQUIRE(read_case_file(files.front()).expect->bucket.find(kind) != std::string::npos);
  std::size_t of_kind = 0;
  for (const std::string& file : files) {
    const CorpusCase known = read_case_file(file);
    const bool is_of_kind = known.expect->bucket.find(kind) != std::string::npos;
    of_kind += is_of_kind ? 1 : 0;
    CHECK(known.accepted.has_value() == (is_of_kind && !is_worst(file)));
    if (known.accepted) CHECK(known.accepted->is_of_kind);
  }
  CHECK(of_kind > 1);
}

TEST_CASE("a finding that is accepted again is accepted as was said last") {
  const TemporaryFolder folder;
  const std::string file = accept_findings(folder, one_eyed(folder)).front();
  CHECK(accept(folder, {file, file}, {"--up-to", "0.125"}).status == 0);
  CHECK((*read_case_file(file).accepted->errors_up_to)[Component::missing] == 0.125);
  CHECK(text_of(file).find("\"accepted\"") == text_of(file).rfind("\"accepted\""));
}

TEST_CASE("the worst of a finding stands for it, and so does its bucket") {
  const TemporaryFolder folder;
  const std::string file = save_findings(folder, one_eyed(folder)).front();
  const std::string worst = worst_beside(file).string();
  fs::copy_file(file, worst);
  const std::string bucket = read_case_file(file).expect->bucket;
  for (const std::string& name : {worst, bucket}) {
    CHECK(accept(folder, {name}).status == 0);
    CHECK(read_case_file(file).accepted);
    CHECK_FALSE(read_case_file(worst).accepted);
    CHECK(drop(folder, name).status == 0);
    CHECK_FALSE(read_case_file(file).accepted);
  }
}

TEST_CASE("the file that is given is marked where it is, and a case from stdin in the corpus") {
  const TemporaryFolder folder;
  const std::string file = save_findings(folder, one_eyed(folder)).front();
  const std::string text = text_of(file);
  const std::string name = fs::path(file).filename().string();
  fs::remove_all(corpus_in(folder));
  const std::string elsewhere = folder.write("elsewhere.json", text);
  const std::string kept = corpus_in(folder) + "/regressions/" + name;
  const Outcome outside = accept(folder, {elsewhere});
  CHECK(outside.status == 0);
  CHECK_THAT(outside.err, Contains("it is accepted only in runs whose --corpus holds it"));
  CHECK(read_case_file(elsewhere).accepted);
  CHECK_FALSE(fs::exists(kept));
  const Outcome from_stdin =
      run_manifuzz({"accept", "-", "--because", "so", "--corpus", corpus_in(folder)}, text);
  CHECK(from_stdin.status == 0);
  CHECK(read_case_file(kept).accepted);
}

TEST_CASE(
    "a line of the corpus is accepted in a file of its own, for in the lines it had no room") {
  const TemporaryFolder folder;
  const std::string file = save_findings(folder, one_eyed(folder)).front();
  const std::string line = Json::parse(text_of(file)).dump() + "\n";
  fs::remove_all(corpus_in(folder));
  fs::create_directory(corpus_in(folder));
  const std::string lines = folder.write("corpus/lines.jsonl", line);
  CHECK(accept(folder, {lines}).status == 0);
  CHECK(text_of(lines) == line);
  CHECK(files_of(folder).size() == 2);
  CHECK(lines_of(list(folder).out).size() == 1);
}

TEST_CASE("what is nobody's mistake cannot be accepted, and nothing else is then", "[bad-input]") {
  const TemporaryFolder folder;
  const std::string good = save_findings(folder, one_eyed(folder)).front();
  const std::string agreeing = folder.write("agreeing.json", good_case());
  std::string as_tie = text_of(good);
  const std::string bucket = read_case_file(good).expect->bucket;
  as_tie.replace(as_tie.find(bucket), bucket.size(), "none/tie/depth/none/a");
  const std::string tie = folder.write("tie.json", as_tie);
  for (const std::string& bad : {agreeing, tie}) {
    check_not_accepted(accept(folder, {good, bad}), bad + ": shows nobody's mistake");
  }
  check_not_accepted(accept(folder, {good, corpus_in(folder)}), "is a folder; a file is expected");
  check_not_accepted(accept(folder, {good, folder.write("empty.json", "")}), "is empty");
  CHECK_FALSE(read_case_file(good).accepted);
}

TEST_CASE("bad usage of accept is one clear line, status 2, and changes no file", "[bad-input]") {
  const TemporaryFolder folder;
  const std::string file = save_findings(folder, one_eyed(folder)).front();
  const std::string before = text_of(file);
  const std::vector<std::vector<std::string>> bad{
      {},
      {file},
      {file, "--because", "  "},
      {file, "--because", "so", "--until", "2026-02-30"},
      {file, "--because", "so", "--until", "tomorrow"},
      {file, "--because", "so", "--until", ""},
      {file, "--because", "so", "--today", "2026-13-01"},
      {file, "--because", "so", "--up-to", "-1"},
      {file, "--because", "so", "--up-to", "nan"},
      {file, "--because", "so", "--up-to", "much"},
      {file, "--because", "so", "--link", ""},
      {file, "--list"},
      {file, "--drop", file},
      {"--list", "--drop", file},
      {"--list", "--because", "so"},
      {"--drop", file, "--because", "so"},
      {"--drop", file, "--until", "2027-01-31"},
      {"--drop", file},
      {"--drop", "no-such-file"},
      {"no-such-file", "--because", "so"}};
  for (const auto& arguments : bad) {
    CAPTURE(arguments);
    check_not_accepted(
        run_manifuzz(with(with({"accept"}, arguments), {"--corpus", corpus_in(folder)})), "");
  }
  CHECK(text_of(file) == before);
}

TEST_CASE("accept says so where the folder cannot be written, and the file is whole",
          "[bad-input]") {
  const BoundByPermissions bound;
  const TemporaryFolder folder;
  const std::string file = save_findings(folder, one_eyed(folder)).front();
  const std::string before = text_of(file);
  const fs::path regressions = fs::path(file).parent_path();
  fs::permissions(regressions, fs::perms::owner_read | fs::perms::owner_exec);
  check_not_accepted(accept(folder, {file}), "Permission denied");
  fs::permissions(regressions, fs::perms::owner_all);
  CHECK(text_of(file) == before);
}
