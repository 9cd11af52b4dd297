#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/report/svg_reader.hpp"

// What a program says of itself, and in its answers, is written by whoever wrote the program: it
// is shown as text, and is no command to a terminal, a browser or the runner of a workflow.

using namespace manifuzz::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// Each as it stands in JSON, between quotes.
const std::vector<std::string>& words_no_terminal_may_get() {
  static const std::vector<std::string> all{"\\u001b[31mred",  "\\u001b]0;title\\u0007",
                                            "two\\nlines",     "\\r\\n::error::owned",
                                            "over\\rwritten",  "\\b\\b\\b",
                                            "\\u0000",         "nul\\u0000inside",
                                            "\\u009b2J",       "\\u202eevil",
                                            "\\u2066isolated", "caf\xc3\xa9"};
  return all;
}

const std::vector<std::string>& words_that_are_no_text() {
  static const std::vector<std::string> all{"\xff\xfe", "\xc3\x28", "\\ud800", "\x1b[31m", "\\"};
  return all;
}

const std::vector<std::string>& words_of_plain_letters() {
  static const std::vector<std::string> all =
      with({"::error::owned", "<script>x()</script>", "</script><img src=x>", "]]><failure/>",
            "<!--", "|a|b|", "`id` ```", "$(touch owned)"},
           {"\\\"quoted\\\"", "it's", "../../owned", "%0A::error::owned", "&amp;&#60;b>",
            "a b; touch owned"});
  return all;
}

/// All of these, in as few versions as a program may declare.
std::vector<std::string> versions_of(const std::vector<std::string>& words) {
  constexpr std::size_t longest = 60;
  std::vector<std::string> versions{""};
  for (const std::string& word : words) {
    if (versions.back().size() + word.size() > longest) versions.emplace_back();
    versions.back() += word;
  }
  return versions;
}

/// A program that declares what `members` says, and gives each of the answers in turn.
std::string program_that_says(const TemporaryFolder& folder, const std::string& members,
                              const std::vector<std::string>& answers) {
  const std::string declaration =
      folder.write("declaration", "{\"declaration\": {\"frame\": \"local\", " + members + "}}\n");
  std::string lines;
  for (const std::string& answer : answers) lines += answer + "\n";
  const std::string all = folder.write("answers", lines);
  const std::string script = "cat '" + declaration + "'\nexec 3< '" + all +
                             "'\nwhile read -r line; do\n  read -r answer <&3 || { exec 3< '" +
                             all + "'; read -r answer <&3; }\n  printf '%s\\n' \"$answer\"\ndone\n";
  return "sh '" + folder.write("program.sh", script) + "'";
}

std::vector<std::string> campaign_against(const std::string& program, const TemporaryFolder& folder,
                                          const std::string& cases) {
  const std::string in = folder.path().string() + "/";
  const std::vector<std::string> asked{manifuzz_path(), "fuzz", "--subject-command", program};
  const std::vector<std::string> drawn{"--regime", "boxes", "--seed", "1", "--cases", cases};
  return with(with(asked, drawn),
              {"--oracle", "clip64", "--jobs", "1", "--shrink-seconds", "0", "--corpus",
               in + "corpus", "--json", in + "run.json", "--junit", in + "junit.xml"});
}

/// A command as a step of a workflow.
std::vector<std::string> in_workflow(const TemporaryFolder& folder,
                                     const std::vector<std::string>& command) {
  return with({"env", "GITHUB_ACTIONS=true", "GITHUB_SERVER_URL=https://github.com",
               "GITHUB_REPOSITORY=me/engine", "GITHUB_SHA=abc123",
               "GITHUB_STEP_SUMMARY=" + (folder.path() / "summary.md").string()},
              command);
}

bool is_plain_text(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Commands to the runner are all of our own making.
void check_annotations(const std::string& out) {
  for (const std::string& line : lines_of(out)) {
    CAPTURE(line);
    if (line.starts_with("::")) CHECK(line.starts_with("::error title=manifuzz fuzz"));
    CHECK(times(line, "::") <= 2);
  }
}

nlohmann::json data_of_page(const std::string& page) {
  const std::string start = R"(<script type="application/json" id="data">)";
  const std::size_t from = page.find(start) + start.size();
  REQUIRE(from > start.size());
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from), nullptr,
                               false);
}

/// No tag of the page of these files is the program's.
void check_page_of(const std::vector<std::string>& files) {
  const Outcome outcome = run_manifuzz(with({"report", "--maps", "1", "--output", "-"}, files));
  CAPTURE(outcome.err);
  const std::string& page = outcome.out;
  CHECK(data_of_page(page).is_object());
  CHECK(times(page, "<script") == 2);
  CHECK(times(page, "</script") == 2);
  CHECK(times(page, "<img") == 0);
  CHECK(times(page, "<!--") == 0);
}

void check_corpus_names(const TemporaryFolder& folder) {
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "corpus")) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    CHECK(std::ranges::all_of(name, [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
    }));
    CHECK((std::isalnum(static_cast<unsigned char>(name.front())) != 0));
    if (entry.is_regular_file()) ++files;
  }
  CHECK(files > 0);
}

/// Nothing but what a campaign is told to write is there.
void check_files(const TemporaryFolder& folder) {
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    const std::vector<std::string> expected{"answers",  "corpus",     "declaration", "junit.xml",
                                            "run.json", "program.sh", "summary.md"};
    CHECK(std::ranges::find(expected, name) != expected.end());
  }
}

void check_outputs(const TemporaryFolder& folder, const Outcome& outcome) {
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 1);
  CHECK(is_plain_text(outcome.out));
  CHECK(is_plain_text(outcome.err));
  check_annotations(outcome.out);
  check_corpus_names(folder);
  check_files(folder);
  const auto elements = read_svg(text_of(folder.path() / "junit.xml"));
  const auto failures = std::ranges::count(elements, "failure", &Element::name);
  CHECK(std::to_string(failures) == elements.at(0).attributes.at("failures"));
  for (const std::string& line : lines_of(text_of(folder.path() / "summary.md"))) {
    CAPTURE(line);
    CHECK_THAT(line, !Catch::StartsWith("::") && !Contains("<script") && !Contains("<img") &&
                         !Contains("\x1b"));
  }
}

std::string member(const std::string& key, const std::string& word) {
  return "\"" + key + "\": \"" + word + "\"";
}

}  // namespace

TEST_CASE("a program whose name or version is hostile is refused in one clear line") {
  const TemporaryFolder folder;
  const auto check = [&folder](const std::string& members, const std::string& complaint) {
    const std::string program = program_that_says(folder, members, {R"({"points": []})"});
    const Outcome outcome = run_program(campaign_against(program, folder, "10"));
    CAPTURE(members, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(is_one_clear_line(outcome.err));
    CHECK(outcome.err.size() < 600);
    CHECK_THAT(outcome.err, Contains(complaint));
    CHECK_FALSE(fs::exists(folder.path() / "corpus"));
  };
  for (const std::string& word : with(words_no_terminal_may_get(), words_of_plain_letters())) {
    check(member("name", word), "declare");
  }
  check(member("name", ""), "is not a valid name");
  check(member("name", std::string(100'000, 'x')), "is not a valid name");
  check(member("name", ".."), "is not a valid name");
  for (const std::string& word : words_no_terminal_may_get()) {
    check(R"("name": "mine", )" + member("version", word), "declare");
  }
  check(R"("name": "mine", )" + member("version", std::string(100'000, 'x')),
        "is not a valid version");
}

TEST_CASE("a program whose declaration is no JSON is one that declares nothing") {
  for (const std::string& word : words_that_are_no_text()) {
    const TemporaryFolder folder;
    const std::string program =
        program_that_says(folder, member("name", word), {R"({"points": []})"});
    CAPTURE(word);
    check_outputs(folder,
                  run_program(in_workflow(folder, campaign_against(program, folder, "10"))));
  }
}

TEST_CASE("hostile words that a program may use for its version are text in every output") {
  for (const std::string& word : versions_of(words_of_plain_letters())) {
    const TemporaryFolder folder;
    const std::string program = program_that_says(
        folder, R"("name": "--help", )" + member("version", word), {R"({"points": []})"});
    CAPTURE(word);
    check_outputs(folder,
                  run_program(in_workflow(folder, campaign_against(program, folder, "10"))));
    const std::string said = nlohmann::json::parse("\"" + word + "\"").get<std::string>();
    const std::string json = (folder.path() / "run.json").string();
    const auto run = nlohmann::json::parse(text_of(json));
    CHECK(run["versions"]["--help"] == said);
    CHECK(run["subject"] == "--help");
    check_page_of({json});
  }
}

TEST_CASE("hostile words in a program's answers are text in every output") {
  const TemporaryFolder folder;
  std::vector<std::string> answers;
  for (const std::string& word : with(words_no_terminal_may_get(), words_of_plain_letters())) {
    answers.push_back("{" + member("unsupported", word) + "}");
    answers.push_back("{\"points\": [], \"" + word + "\": 1}");
    answers.push_back("{\"points\": [{" + member("position", word) + "}]}");
    answers.push_back(R"({"points": [], "normal": [0, 1], )" + member("reference", word) + "}");
    answers.push_back("{" + word);
  }
  answers.push_back(R"({"points": []})");
  const std::string program = program_that_says(
      folder,
      R"("name": "mine", "version": "1", "claims": "separation", )"
      R"("tolerance": {"relative": 1e-9, "source": "\u001b[31m\n::error::<script>"})",
      answers);
  const auto campaign = campaign_against(program, folder, "200");
  check_outputs(folder, run_program(in_workflow(folder, campaign)));
  const auto run = nlohmann::json::parse(text_of(folder.path() / "run.json"));
  CHECK(run["verdicts"]["malformed"] > 0);
  CHECK(run["verdicts"]["unsupported"] > 0);
  const std::string corpus = (folder.path() / "corpus").string();
  check_page_of({corpus, (folder.path() / "run.json").string()});
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    if (entry.path().extension() != ".json") continue;
    const Outcome outcome =
        run_manifuzz({"show", entry.path().string(), "--subject-command", program});
    CAPTURE(outcome.out, outcome.err);
    CHECK_THAT(outcome.out, !Contains("\x1b") && !Contains("\n::"));
    CHECK(is_plain_text(outcome.err));
  }
}

TEST_CASE("a terminal gets no word of a program but in plain letters") {
  const TemporaryFolder folder;
  const std::string program =
      program_that_says(folder, R"("name": "mine")", {"\x1b[31m\x1b]0;title\x07\xe2\x80\xae"});
  const auto campaign = campaign_against(program, folder, "60");
  std::string screen = run_on_terminal(with({"env", "TERM=xterm", "NO_COLOR=1"}, campaign)).out;
  CHECK_THAT(screen, Contains("mine gave no answer again and again: '\\x1b[31m\\x1b]0;title\\x07"));
  for (const std::string& ours : {std::string("\x1b[K"), std::string("\r")}) {
    for (auto at = screen.find(ours); at != screen.npos; at = screen.find(ours)) {
      screen.erase(at, ours.size());
    }
  }
  CHECK(is_plain_text(screen));
}

TEST_CASE("a command or library that cannot be used is one clear line, whatever its name holds") {
  const std::vector<std::vector<std::string>> choices{
      {"--subject", "./\x1b[31m\n::error::.so"},
      {"--subject", "./\x1b[31m\n::error::.so", "--in-process"},
      {"--subject-command", "./no-such-program '\x1b[31m\n::error::' 2> /dev/null"},
      {"--subject-command", "echo '{\"declaration\": {\"name\": \"a b\"}}'\n# \x1b[31m"}};
  for (const auto& choice : choices) {
    const Outcome outcome = run_manifuzz(with({"fuzz", "--cases", "10", "--no-save"}, choice));
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(is_one_clear_line(outcome.err));
    CHECK_THAT(outcome.err, Contains("\\x1b[31m"));
  }
}
