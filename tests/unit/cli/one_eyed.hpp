#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "corpus/corpus.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

// A subject that is wrong on some cases, and the corpus of what it does wrong.

namespace manifuzz::test {

using Json = nlohmann::ordered_json;

/// The command of a program that declares this name and answers as `clip` does, but where that
/// finds what `pattern` says, as a shell's `case` has it: there it does as `instead` says.
inline std::string clip_but(const TemporaryFolder& folder, const std::string& name,
                            const std::string& pattern, const std::string& instead) {
  const std::string script =
      "echo '{\"declaration\": {\"name\": \"" + name +
      "\", \"version\": \"1\", \"frame\": \"local\"}}'\n'" + manifuzz_path() +
      "' collide --collider clip | while read -r line; do\n  case \"$line\" "
      "in " +
      pattern + ") " + instead + " ;;\n  *) printf '%s\\n' \"$line\" ;;\n  esac\ndone\n";
  return "sh '" + folder.write(name + std::to_string(script.size()) + ".sh", script) + "'";
}

/// Finds no contact where B has the reference.
inline std::string one_eyed(const TemporaryFolder& folder) {
  return clip_but(folder, "one_eyed", R"(*'"reference": "b"'*)", "echo '{\"points\": []}'");
}

/// A right collider of the name that the wrong one has.
inline std::string mended(const TemporaryFolder& folder) {
  return clip_but(folder, "one_eyed", "nothing", "exit 3");
}

inline std::string corpus_in(const TemporaryFolder& folder) {
  return (folder.path() / "corpus").string();
}

/// A campaign of few cases, which shrinks nothing; what it says is JSON.
inline Outcome campaign(const TemporaryFolder& folder, const std::string& command,
                        const std::vector<std::string>& more = {},
                        const std::string& cases = "40") {
  const std::vector<std::string> words{
      "fuzz", "--subject-command", command, "--regime", "boxes",           "--seed", "1", "--cases",
      cases,  "--shrink-seconds",  "0",     "--corpus", corpus_in(folder), "--json", "-"};
  return run_manifuzz(with(words, more));
}

inline Json json_of(const Outcome& outcome) {
  INFO(outcome.err);
  Json json = Json::parse(outcome.out, nullptr, false);
  REQUIRE(json.is_object());
  return json;
}

/// The files of the corpus.
inline std::vector<std::string> files_of(const TemporaryFolder& folder) {
  const std::filesystem::path corpus = corpus_in(folder);
  std::vector<std::string> files;
  for (const CorpusCase& known : read_corpus({&corpus, 1}).cases) files.push_back(known.path);
  return files;
}

inline Outcome accept(const TemporaryFolder& folder, const std::vector<std::string>& files,
                      const std::vector<std::string>& more = {}) {
  const std::vector<std::string> words{"accept", "--because", "known since 2.3", "--corpus",
                                       corpus_in(folder)};
  return run_manifuzz(with(with(words, files), more));
}

/// What the subject does wrong, saved.
inline std::vector<std::string> save_findings(const TemporaryFolder& folder,
                                              const std::string& command) {
  CHECK(campaign(folder, command).status == 1);
  const std::vector<std::string> files = files_of(folder);
  REQUIRE(files.size() >= 3);
  return files;
}

/// The same, and accepted, each of them.
inline std::vector<std::string> accept_findings(const TemporaryFolder& folder,
                                                const std::string& command,
                                                const std::vector<std::string>& more = {}) {
  const std::vector<std::string> files = save_findings(folder, command);
  CHECK(accept(folder, files, more).status == 0);
  return files;
}

inline Outcome replay(const TemporaryFolder& folder, const std::string& command,
                      const std::vector<std::string>& more = {}) {
  return run_manifuzz(
      with({"replay", corpus_in(folder), "--subject-command", command, "--json", "-"}, more));
}

}  // namespace manifuzz::test
