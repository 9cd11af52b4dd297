#include <algorithm>

#include <catch2/catch.hpp>

#include "unit/cli/one_eyed.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// What campaigns say of the bucket of that file.
Json row_of(const Json& run, const std::string& file) {
  const std::string bucket = read_case_file(file).expect->bucket;
  for (const Json& row : run["buckets"]) {
    if (row["bucket"] == bucket) return row;
  }
  FAIL("there is no " << bucket);
  return {};
}

/// The files' names, for a campaign's paths begin at the working folder.
std::vector<std::string> names_of(const Json& files) {
  std::vector<std::string> names;
  for (const Json& file : files) {
    names.push_back(std::filesystem::path(file.get<std::string>()).filename().string());
  }
  return names;
}

/// The finding that was met most often.
std::string most_frequent(const std::vector<std::string>& files) {
  return *std::ranges::max_element(files, {}, [](const std::string& file) {
    return read_case_file(file).found->seen->regimes.at("boxes");
  });
}

}  // namespace

TEST_CASE("a campaign whose findings are all accepted is well, and counts their cases") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const auto files = accept_findings(folder, subject);
  const Outcome outcome = campaign(folder, subject);
  CHECK(outcome.status == 0);
  const Json run = json_of(outcome);
  CHECK(run["unexplained"] == 0);
  CHECK(run["accepted"] > 0);
  CHECK(run["stale"] == Json::array());
  for (const std::string& file : files) {
    const Json row = row_of(run, file);
    CHECK(row["accepted"] == true);
    CHECK(row["new"] == false);
    CHECK_FALSE(row.contains("objection"));
    CHECK(row["regimes"]["boxes"] == row["count"]);
  }
}

TEST_CASE("a finding that is worse than is accepted fails campaign and replay, and no other does") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const auto files = accept_findings(folder, subject);
  const std::string file = most_frequent(files);
  CHECK(accept(folder, {file}, {"--up-to", "0"}).status == 0);
  const Outcome outcome = campaign(folder, subject);
  CHECK(outcome.status == 1);
  const Json run = json_of(outcome);
  CHECK_THAT(row_of(run, file)["objection"].get<std::string>(), Contains("worse than is accepted"));
  CHECK(run["unexplained"] == row_of(run, file)["count"]);
  const Outcome again = replay(folder, subject);
  CHECK(again.status == 1);
  const Json replayed = json_of(again);
  CHECK(replayed["accepted"] == files.size() - 1);
  REQUIRE(replayed["failures"].size() == 1);
  CHECK(replayed["failures"][0]["file"] == file);
  CHECK_THAT(replayed["failures"][0]["got"].get<std::string>(), Contains("worse than is accepted"));
}

TEST_CASE("beneath an accepted wrong side no point may move and no depth grow") {
  const TemporaryFolder folder;
  const std::string pattern = R"(*'"reference": "b"'*)";
  const std::string turn = R"(printf '%s\n' "$line" | sed 's/"reference": "b"/"reference": "a"/)";
  const std::string subject = clip_but(folder, "always_a", pattern, turn + "'");
  CHECK(campaign(folder, subject).status == 1);
  CHECK(accept(folder, files_of(folder)).status == 0);
  const Outcome as_accepted = campaign(folder, subject);
  CHECK(as_accepted.status == 0);
  CHECK(json_of(as_accepted)["unexplained"] == 0);
  const std::string deeper = clip_but(folder, "always_a", pattern, turn + R"(;s/"depth": /&50/g')");
  CHECK(campaign(folder, deeper, {"--no-save"}).status == 1);
  CHECK(replay(folder, deeper).status == 1);
}

TEST_CASE("a finding that is more frequent than is accepted fails the campaign, not the replay") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const std::string file = most_frequent(accept_findings(folder, subject));
  Acceptance acceptance = read_case_file(file).accepted.value();
  acceptance.per_million["boxes"] = 1;
  write_acceptance(file, acceptance);
  const Outcome outcome = campaign(folder, subject, {"--no-save"}, "400");
  CHECK(outcome.status == 1);
  CHECK(row_of(json_of(outcome), file)["objection"] == "more frequent than is accepted in boxes");
  CHECK(replay(folder, subject).status == 0);
}

TEST_CASE("what is accepted until a day passes on that day, and fails on the next") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  accept_findings(folder, subject, {"--until", "2026-02-28"});
  CHECK(campaign(folder, subject, {"--today", "2026-02-28"}).status == 0);
  CHECK(replay(folder, subject, {"--today", "2026-02-28"}).status == 0);
  CHECK(campaign(folder, subject, {"--today", "2026-03-01"}).status == 1);
  const Outcome past = replay(folder, subject, {"--today", "2026-03-01"});
  CHECK(past.status == 1);
  CHECK_THAT(past.out, Contains("accepted until 2026-02-28, and that is past"));
}

TEST_CASE("beside what is accepted anything else is new and fails") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const auto files = accept_findings(folder, subject);
  const std::string dropped = files.front();
  CHECK(run_manifuzz({"accept", "--drop", dropped, "--corpus", corpus_in(folder)}).status == 0);
  const Outcome outcome = campaign(folder, subject);
  CHECK(outcome.status == 1);
  CHECK(row_of(json_of(outcome), dropped)["accepted"] == false);
  std::filesystem::remove(dropped);
  CHECK(json_of(campaign(folder, subject, {"--no-save"}))["accepted"] > 0);
  CHECK(campaign(folder, subject, {"--no-save"}).status == 1);
}

TEST_CASE("what is accepted of one subject is not of another") {
  const TemporaryFolder folder;
  accept_findings(folder, one_eyed(folder));
  const std::string another =
      clip_but(folder, "another", R"(*'"reference": "b"'*)", "echo '{\"points\": []}'");
  const Outcome outcome = campaign(folder, another, {"--no-save"});
  CHECK(outcome.status == 1);
  CHECK(json_of(outcome)["accepted"] == 0);
  CHECK(replay(folder, another).status == 1);
}

TEST_CASE("what was accepted and comes no more is stale, in the campaign and in the replay") {
  const TemporaryFolder folder;
  const auto files = accept_findings(folder, one_eyed(folder));
  const std::string subject = mended(folder);
  const Outcome outcome = campaign(folder, subject);
  CHECK(outcome.status == 0);
  CHECK(names_of(json_of(outcome)["stale"]) == names_of(Json(files)));
  const Outcome again = replay(folder, subject);
  CHECK(again.status == 0);
  CHECK(json_of(again)["stale"] == Json(files));
  CHECK(json_of(again)["accepted"] == 0);
  CHECK(json_of(run_manifuzz({"replay", corpus_in(folder), "--subject", "clip", "--json",
                              "-"}))["stale"] == Json::array());  // it is not clip's finding
}

TEST_CASE("a campaign until something new ends with what is worse than is accepted, and says so") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const std::string file = most_frequent(accept_findings(folder, subject));
  CHECK(json_of(campaign(folder, subject, {"--until-new"}))["cases"] == 40);
  CHECK(accept(folder, {file}, {"--up-to", "0"}).status == 0);
  const std::vector<std::string> words{
      "fuzz",     "--subject-command", subject, "--regime",    "boxes",  "--seed",
      "1",        "--cases",           "40",    "--until-new", "--jobs", "2",
      "--corpus", corpus_in(folder)};
  const Outcome outcome = run_manifuzz(words);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, !Contains("nothing new") && Contains("worse than is accepted"));
  const Json two = json_of(campaign(folder, subject, {"--until-new", "--jobs", "2"}));
  const Json one = json_of(campaign(folder, subject, {"--until-new", "--jobs", "1"}));
  CHECK(one["cases"] == row_of(one, file)["first_index"].get<int>() + 1);
  CHECK(one["cases"] == two["cases"]);
  CHECK(one["buckets"] == two["buckets"]);
}

TEST_CASE("JUnit passes what is accepted, and fails what is not") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const auto files = accept_findings(folder, subject);
  const auto junit = [&](const std::string& command) {
    std::vector<std::string> words{command, "--subject-command", subject, "--junit", "-"};
    if (command == "replay") return run_manifuzz(with(words, {corpus_in(folder)})).out;
    words.insert(words.end(), {"--regime", "boxes", "--seed", "1", "--cases", "40", "--no-save",
                               "--corpus", corpus_in(folder)});
    return run_manifuzz(words).out;
  };
  for (const char* command : {"replay", "fuzz"}) {
    CHECK_THAT(junit(command), Contains("failures=\"0\" errors=\"0\""));
  }
  CHECK(accept(folder, {files.front()}, {"--up-to", "0"}).status == 0);
  for (const char* command : {"replay", "fuzz"}) {
    CHECK_THAT(junit(command), !Contains("failures=\"0\"") && Contains("<failure"));
  }
}

TEST_CASE("a property that fails may be accepted, and is stale once it holds", "[longer]") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const auto property = [&](const std::string& seed) {
    return run_manifuzz({"property", "never-empty", "--subject-command", subject, "--cases", "200",
                         "--seed", seed, "--corpus", corpus_in(folder)});
  };
  CHECK(property("1").status == 1);
  const auto files = files_of(folder);
  REQUIRE(files.size() == 1);
  CHECK(accept(folder, files, {"--up-to", "1"}).status == 0);
  const Outcome accepted = property("2");
  CHECK(accepted.status == 0);
  CHECK_THAT(accepted.out, Contains("accepted: never-empty"));
  CHECK(files_of(folder) == files);  // it is saved no more
  CHECK(json_of(replay(folder, subject))["accepted"] == 1);
  CHECK(json_of(replay(folder, mended(folder)))["stale"] == Json(files));
  CHECK(accept(folder, files, {"--up-to", "0"}).status == 0);
  const Outcome worse = property("1");
  CHECK(worse.status == 1);
  CHECK_THAT(worse.out, Contains("worse than is accepted"));
  CHECK(replay(folder, subject).status == 1);
}

TEST_CASE("crashes may be accepted") {
  const TemporaryFolder folder;
  const std::string subject =
      clip_but(folder, "fragile", R"(*'"reference": "b"'*)", "kill -9 $$; exit 3");
  const auto few = [&] { return campaign(folder, subject, {"--jobs", "1"}, "12"); };
  CHECK(few().status == 1);
  const auto files = files_of(folder);
  REQUIRE(files.size() == 1);
  CHECK(read_case_file(files.front()).expect->verdict == "crashed");
  CHECK(accept(folder, files).status == 0);
  CHECK(few().status == 0);
  CHECK(json_of(replay(folder, subject))["accepted"] == 1);
}

TEST_CASE("a baseline decides the status, unless it is of another subject") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const Outcome before = campaign(folder, subject, {"--no-save"});
  CHECK(before.status == 1);
  const std::string baseline = folder.write("baseline.json", before.out);
  const std::vector<std::string> beside_it{"--no-save", "--baseline", baseline};
  const Outcome as_before = campaign(folder, subject, beside_it);
  CHECK(as_before.status == 0);
  CHECK(json_of(as_before)["buckets"][0]["in_baseline"] == true);
  const std::string another =
      clip_but(folder, "another", R"(*'"reference": "b"'*)", "echo '{\"points\": []}'");
  CHECK(campaign(folder, another, beside_it).status == 1);
  const std::string blind =
      clip_but(folder, "one_eyed", "*'\"reference\"'*", "echo '{\"points\": []}'");
  CHECK(campaign(folder, blind, beside_it).status == 1);
}

TEST_CASE("merged corpora accept what each of them accepts") {
  const TemporaryFolder folder;
  const auto files = accept_findings(folder, one_eyed(folder));
  const std::filesystem::path copy = folder.path() / "copy";
  std::filesystem::copy(corpus_in(folder), copy, std::filesystem::copy_options::recursive);
  const std::string first = std::filesystem::relative(files.front(), corpus_in(folder)).string();
  write_acceptance((copy / first).string(), {});
  const std::string merged = (folder.path() / "merged").string();
  CHECK(run_manifuzz({"merge", copy, corpus_in(folder), "--output", merged}).status == 0);
  const Outcome listed = run_manifuzz({"accept", "--list", "--corpus", merged});
  CHECK(lines_of(listed.out).size() == files.size());
}
