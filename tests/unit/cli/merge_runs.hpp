#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace manifuzz::test {

using Json = nlohmann::ordered_json;

/// A campaign over indices from `first` on, to NAME.json in the folder; what it finds, to NAME/.
inline Json run(const TemporaryFolder& folder, const std::string& name, int first, int cases,
                const std::string& seed = "2", const std::vector<std::string>& more = {}) {
  const std::string corpus = (folder.path() / name).string();
  const std::vector<std::string> words{"fuzz",
                                       "--regime=tie_bias",
                                       "--regime=sliver",
                                       "--radius=0",
                                       "--ties",
                                       "--seed=" + seed,
                                       "--first=" + std::to_string(first),
                                       "--cases=" + std::to_string(cases),
                                       "--corpus=" + corpus,
                                       "--json=" + corpus + ".json"};
  CHECK(run_manifuzz(with(words, more)).status == 0);
  return Json::parse(text_of(corpus + ".json"));
}

/// The same, with nothing saved but the counts.
inline Json count(const TemporaryFolder& folder, const std::string& name, int first, int cases,
                  const std::string& seed = "2") {
  return run(folder, name, first, cases, seed, {"--no-save"});
}

/// Merges these to OUTPUT/, and to OUTPUT.json where there are results among them.
inline Outcome merge(const TemporaryFolder& folder, const std::vector<std::string>& names,
                     const std::string& output, const std::vector<std::string>& more = {}) {
  const std::string all = (folder.path() / output).string();
  std::vector<std::string> arguments{"merge", "--output", all};
  for (const std::string& name : names) arguments.push_back((folder.path() / name).string());
  if (names.back().ends_with(".json")) {
    arguments.emplace_back("--json");
    arguments.push_back(all + ".json");
  }
  return run_manifuzz(with(arguments, more));
}

}  // namespace manifuzz::test
