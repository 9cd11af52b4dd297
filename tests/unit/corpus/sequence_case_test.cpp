#include <filesystem>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "sequence/motions.hpp"
#include "sequence/sequence_json.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;

namespace {

const std::string kGood =
    R"({"format": "manifuzz/sequence/1", "a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]]}, )"
    R"("b": {"vertices": [[0,0]], "radius": 0.5}, )"
    R"("frames": [{"a": [0,0,1,0], "b": [0,1.25,1,0]}, {"a": [0,0,0.6,0.8], "b": [0.5,1.25,1,0]}]})";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kGood;
  text.replace(text.find(from), from.size(), to);
  return text;
}

CorpusCase parse(const std::string& text) {
  return parse_case(text, FormatKey::required, CaseKind::sequence);
}

}  // namespace

TEST_CASE("a sequence is read as it is written") {
  const CorpusCase read = parse(kGood);
  REQUIRE(kind_of(read.any) == CaseKind::sequence);
  CHECK(read.sequence().frames.size() == 2);
  CHECK(read.sequence().frames[1].a.rotation == Vector2<float>(0.6F, 0.8F));
  CHECK(read.sequence().b.radius == 0.5F);
  CHECK(read.sequence().frames[0].b.position == Vector2<float>(0, 1.25F));
}

TEST_CASE("every motion's sequences read back bit for bit, as lines and as files") {
  for (const Motion& motion : motions()) {
    for (std::uint64_t index = 0; index < 20; ++index) {
      CorpusCase known;
      known.any = draw_sequence(3, motion, index);
      known.found = Found{3, std::string(motion.name), index, {{"cached", "1"}}};
      known.note = "Kept.";
      const CorpusCase again = parse(format_case(known));
      CHECK(again.any == known.any);
      CHECK(again.sequence() == draw_sequence(3, motion, index));
      CHECK(again.found->index == index);
      CHECK(again.note == known.note);
      std::string line;
      append_found_case_line(line, known.any, *known.found);
      CHECK(line.find('\n') == std::string::npos);
      CHECK(parse(line).any == known.any);
    }
  }
}

TEST_CASE("what is wrong with a sequence is named with its path") {
  struct Bad {
    std::string text;
    std::string complaint;
  };
  std::string many = "{\"a\": [0,0,1,0], \"b\": [0,1,1,0]}";
  std::string too_many = many;
  for (std::size_t i = 0; i < kFramesMax; ++i) too_many += "," + many;
  for (const Bad& bad : std::initializer_list<Bad>{
           {changed("\"frames\"", "\"poses\""), "poses"},
           {changed("[0,0,0.6,0.8]", "[0,0,0.6,0.9]"), "$.frames[1].a: [0.6, 0.9] is not a rot"},
           {changed("[0,0,0.6,0.8]", "[0,0,0.6]"), "$.frames[1].a: has 3 elements"},
           {changed("[0,0,0.6,0.8]", "[0,1e99,0.6,0.8]"), "$.frames[1].a[1]"},
           {changed("\"a\": [0,0,1,0], ", ""), "$.frames[0]"},
           {changed("\"radius\": 0.5", "\"radius\": 0.5, \"position\": [0,0]"), "$.b"},
           {changed("[[0,0]], \"radius\": 0.5", "[[0,0]]"), "$.b.vertices"},
           {kGood.substr(0, kGood.find("\"frames\"")) + "\"frames\": []}", "$.frames: has 0"},
           {kGood.substr(0, kGood.find("\"frames\"")) + "\"frames\": [" + too_many + "]}",
            "$.frames: has 2049 frames; 1 to 2048"}}) {
    CAPTURE(bad.text.substr(0, 300), bad.complaint);
    CHECK_THROWS_WITH(parse(bad.text), Catch::Contains(bad.complaint));
  }
}

TEST_CASE("a sequence is no pair case, nor the other way round") {
  CHECK_THROWS_WITH(parse_case(kGood, FormatKey::optional),
                    Catch::Contains("$.format: is a sequence"));
  const std::string pair =
      R"({"a": {"vertices": [[0,0],[1,0],[0,1]]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}})";
  CHECK_THROWS_WITH(parse_case(pair, FormatKey::optional, CaseKind::sequence),
                    Catch::Contains("is a pair case; a sequence"));
  CHECK(kind_of(parse_case(pair, FormatKey::optional, CaseKind::either).any) == CaseKind::pair);
}

TEST_CASE("a corpus keeps sequences apart from pair cases") {
  const test::TemporaryFolder folder;
  CorpusCase known = parse(kGood);
  known.expect = Expectation{"cached", "", "known", "subject/known/normal/none/a/gross", {}};
  const auto file = write_corpus_case(folder.path() / "sequences", known);
  CHECK(file.filename().string().starts_with("subject-known-normal-none-a-gross-"));
  folder.write("lines.jsonl", kGood + "\n");
  const Corpus corpus = read_known(folder.path());
  CHECK(corpus.errors.empty());
  CHECK(corpus.cases.empty());
  REQUIRE(corpus.others.size() == 2);
  CHECK(corpus.others[1].any == known.any);
  // It is not written twice, and not taken for another one.
  CHECK(write_corpus_case(folder.path() / "sequences", known) == file);
  std::get<Sequence>(known.any).frames.pop_back();
  CHECK(write_corpus_case(folder.path() / "sequences", known) != file);
  CHECK(find_case("subject/known/normal/none/a/gross", {{folder.path()}}).file ==
        (folder.path() / "sequences" / corpus_file_name(known)).string());
}
