#include "corpus/corpus.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "support/bad_cases.hpp"
#include "support/permissions.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
namespace fs = std::filesystem;

namespace {

CorpusCase sample_case() {
  CorpusCase sample = parse_case(test::good_case(), FormatKey::required);
  sample.found = Found{std::numeric_limits<std::uint64_t>::max(),
                       "sliver",
                       12,
                       {{"box2d", "2.4.1"}, {"clip", "0.1.0"}}};
  Manifold<double> manifold;
  manifold.count = 1;
  manifold.normal = {0, 1};
  manifold.points[0] = {{0.5, 1}, 0.25, {{Feature::Kind::face, 2}, {Feature::Kind::vertex, 0}}};
  sample.expect = Expectation{"clip",
                              "box2d",
                              "known",
                              "oracle/known/missed_contact/reference/a",
                              {{"clip", manifold}, {"box2d", Manifold<double>()}},
                              0.125};
  sample.note = "Why \"this\" is kept: caf\xc3\xa9";
  return sample;
}

Corpus read_corpus_at(const fs::path& path) {
  return read_corpus({&path, 1});
}

std::ptrdiff_t files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

}  // namespace

TEST_CASE("A corpus file has a line for each polygon and each manifold") {
  CHECK(format_case(sample_case()) == R"({
  "format": "manifuzz/case/1",
  "a": {
    "vertices": [[-1,-1],[1,-1],[1,1],[-1,1]],
    "radius": 0,
    "position": [0,0],
    "rotation": [1,0]
  },
  "b": {
    "vertices": [[0,0],[2,0],[1,2]],
    "radius": 0,
    "position": [0.5,0.75],
    "rotation": [1,0]
  },
  "found": {"seed": 18446744073709551615, "regime": "sliver", "index": 12, "versions": {"box2d": "2.4.1", "clip": "0.1.0"}},
  "expect": {
    "subject": "clip",
    "oracle": "box2d",
    "verdict": "known",
    "bucket": "oracle/known/missed_contact/reference/a",
    "severity": 0.125,
    "manifolds": [
      {"collider": "clip", "normal": [0,1], "reference": "a", "points": [{"position": [0.5,1], "local": [0.5,1], "depth": 0.25, "features": ["f2","v0"]}]},
      {"collider": "box2d", "points": []}
    ]
  },
  "note": "Why \"this\" is kept: caf)"
                                      "\xc3\xa9\"\n}\n");
}

TEST_CASE("A corpus file reads back whole") {
  const CorpusCase sample = sample_case();
  const CorpusCase read = parse_case(format_case(sample), FormatKey::required);
  CHECK(read.any == sample.any);
  CHECK(read.found->seed == sample.found->seed);
  CHECK(read.found->regime == "sliver");
  CHECK(read.found->index == 12);
  CHECK(read.found->versions == sample.found->versions);
  CHECK(read.expect->bucket == sample.expect->bucket);
  CHECK(read.expect->severity == 0.125);
  CHECK(read.expect->manifolds.size() == 2);
  CHECK(read.note == sample.note);
  CHECK(format_case(read) == format_case(sample));
}

TEST_CASE("A case that no collider was asked has no versions") {
  CorpusCase sample = sample_case();
  sample.found->versions.clear();
  const std::string text = format_case(sample);
  CHECK(text.find("versions") == std::string::npos);
  CHECK(parse_case(text, FormatKey::required).found->index == 12);
  std::string line;
  append_found_case_line(line, sample.any, *sample.found);
  CHECK(line.find('\n') == std::string::npos);
  CHECK(parse_case(line, FormatKey::required).any == sample.any);
}

TEST_CASE("A severity from 0 to 1 reads back, and none stays none") {
  CorpusCase sample = sample_case();
  for (const std::optional<double> severity :
       {std::optional(0.0), std::optional(1.0), std::optional(0.507), std::optional<double>()}) {
    sample.expect->severity = severity;
    const std::string text = format_case(sample);
    CHECK(parse_case(text, FormatKey::required).expect->severity == severity);
    CHECK((text.find("severity") != std::string::npos) == severity.has_value());
  }
}

TEST_CASE("A property's case reads back") {
  CorpusCase sample = parse_case(test::good_case(), FormatKey::required);
  sample.property = "swap_mirrors";
  sample.expect = Expectation{"clip", "", "", "", {}};
  const CorpusCase read = parse_case(format_case(sample), FormatKey::required);
  CHECK(read.property == "swap_mirrors");
  CHECK(read.expect->subject == "clip");
  CHECK(read.expect->oracle.empty());
  CHECK(corpus_file_name(read).starts_with("property-swap_mirrors-"));
}

TEST_CASE("A file is named by its bucket and its pair alone") {
  CorpusCase sample = sample_case();
  const std::string name = corpus_file_name(sample);
  CHECK(name.starts_with("oracle-known-missed_contact-reference-a-"));
  CHECK(name.size() == std::string("oracle-known-missed_contact-reference-a-01234567.json").size());
  sample.found.reset();
  sample.note.clear();
  CHECK(corpus_file_name(sample) == name);
  std::get<PairCase>(sample.any).b.pose.position.x() += 1;
  CHECK(corpus_file_name(sample) != name);
  sample.expect->bucket = "../../etc/passwd\n";
  CHECK(corpus_file_name(sample).starts_with("------etc-passwd--"));
}

TEST_CASE("A case is never written over another finding, nor over what is no case") {
  const test::TemporaryFolder folder;
  CorpusCase sample = sample_case();
  const fs::path usual = write_corpus_case(folder.path(), sample);
  sample.expect->subject = "pair";
  const fs::path second = write_corpus_case(folder.path(), sample);
  CHECK(second.stem().string() == usual.stem().string() + "-2");
  CHECK(read_case_file(usual.string()).expect->subject == "clip");
  CHECK(write_corpus_case(folder.path(), sample) == second);
  sample.note = "Mine.";
  CHECK(write_corpus_case(folder.path(), sample) == second);
  CHECK(read_case_file(second.string()).note != "Mine.");
  folder.write(usual.filename().string(), "not a case");
  CHECK(corpus_file(folder.path(), sample_case()).stem().string() == usual.stem().string() + "-3");
}

TEST_CASE("The file of what a case was shrunk from is told by its name") {
  CHECK(worst_beside("a/b.json") == "a/b.worst.json");
  CHECK(is_worst("a/b.worst.json"));
  CHECK_FALSE(is_worst("a/b.json"));
  CHECK(shrunk_beside("a/b.worst.json") == "a/b.json");
  CHECK(collider_of_hunted("corpus/worst/clip/error.json") == "clip");
  CHECK(collider_of_hunted("corpus/defects/clip/error.json").empty());
  CHECK(shrunk_beside("a/b.json") == "a/b.json");
}

TEST_CASE("A case is written whole, with its folder, and read back") {
  const test::TemporaryFolder folder;
  const fs::path path = write_corpus_case(folder.path() / "new" / "folder", sample_case());
  CHECK(test::text_of(path) == format_case(sample_case()));
  CHECK(write_corpus_case(folder.path() / "new" / "folder", sample_case()) == path);
  CHECK(files_in(path.parent_path()) == 1);
  const Corpus corpus = read_corpus_at(folder.path());
  CHECK(corpus.errors.empty());
  REQUIRE(corpus.cases.size() == 1);
  CHECK(corpus.cases[0].path == path);
}

TEST_CASE("A file that cannot be written leaves nothing behind") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  CHECK_THROWS_WITH(write_corpus_case(file, sample_case()), Catch::Contains("file"));
  fs::create_directory(folder.path() / corpus_file_name(sample_case()));
  CHECK_THROWS_WITH(write_corpus_case(folder.path(), sample_case()),
                    Catch::Contains("is a folder"));
  CHECK(files_in(folder.path()) == 2);
}

TEST_CASE("A full disk is one clear error", "[disk]") {
  try {
    write_file("/dev/full", "text");
    FAIL("nothing was thrown");
  } catch (const UserError& error) {
    CHECK(std::string(error.what()) == "/dev/full: cannot write it: No space left on device");
  }
  CHECK(!fs::is_regular_file("/dev/full"));
}

TEST_CASE("A corpus is sorted by path, and other files are passed over") {
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "b");
  folder.write("c.json", test::good_case());
  folder.write("b/a.json", test::good_case());
  folder.write("README.md", "not a case");
  folder.write("b/.hidden", "{");
  folder.write("a.jsonl", test::good_case() + "\r\n\n" + test::good_case());
  const Corpus corpus = read_corpus_at(folder.path());
  CHECK(corpus.errors.empty());
  std::vector<std::string> paths;
  for (const auto& read : corpus.cases) paths.push_back(read.path);
  const std::string top = folder.path().string();
  CHECK(paths == std::vector<std::string>{top + "/a.jsonl:1", top + "/a.jsonl:3", top + "/b/a.json",
                                          top + "/c.json"});
}

TEST_CASE("A path that is given twice is read once") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("c.json", test::good_case());
  const std::array<fs::path, 2> paths = {folder.path(), file};
  CHECK(read_corpus(paths).cases.size() == 1);
}

TEST_CASE("Each broken file is one line, and the rest is read") {
  const test::TemporaryFolder folder;
  folder.write("good.json", test::good_case());
  folder.write("empty.json", "");
  folder.write("blank.jsonl", "\n \n");
  folder.write("huge.json", std::string(3 << 20, ' '));
  folder.write("binary.json", std::string("\x7f"
                                          "ELF\0\0",
                                          6));
  folder.write("two.json", test::good_case() + "\n" + test::good_case());
  folder.write("bad.jsonl", "{\n" + test::good_case() + "\nnull\nnull\n");
  fs::create_symlink("nowhere", folder.path() / "link.json");
  const Corpus corpus = read_corpus_at(folder.path());
  CHECK(corpus.cases.size() == 2);
  const std::array<std::string, 7> expected = {
      "/bad.jsonl:1: column 2: not JSON: "
      "unexpected "
      "end of input; expected string literal (and 2 more bad lines)",
      "/binary.json: column 5: not JSON: a NUL byte; UTF-8 text is expected",
      "/blank.jsonl: is empty; one case a line is expected",
      "/empty.json: is empty; one case is expected",
      "/huge.json: is larger than 1 MiB; that is too much to read",
      "/link.json: cannot open it: No such file or directory",
      "/two.json: line 2, column 1: not JSON: unexpected '{'; expected end of input"};
  REQUIRE(corpus.errors.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(corpus.errors[i] == folder.path().string() + expected[i]);
  }
}

TEST_CASE("Paths that hold no cases are one line each") {
  const test::TemporaryFolder folder;
  const std::array<fs::path, 3> paths = {folder.path() / "absent", folder.path() / "absent.json",
                                         folder.write("notes.txt", "hello")};
  const Corpus corpus = read_corpus(paths);
  CHECK(corpus.cases.empty());
  REQUIRE(corpus.errors.size() == 3);
  for (const auto& error : corpus.errors) CHECK(test::is_one_clear_line(error + "\n"));
}

TEST_CASE("Files and folders without permission are one line each") {
  const test::BoundByPermissions bound;
  const test::TemporaryFolder folder;
  chmod(folder.write("secret.json", test::good_case()).c_str(), 0);
  fs::create_directory(folder.path() / "closed");
  chmod((folder.path() / "closed").c_str(), 0);
  const Corpus corpus = read_corpus_at(folder.path());
  chmod((folder.path() / "closed").c_str(), 0700);
  REQUIRE(corpus.errors.size() == 2);
  for (const auto& error : corpus.errors) CHECK_THAT(error, Catch::Contains("Permission denied"));
}
