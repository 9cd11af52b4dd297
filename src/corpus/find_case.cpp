#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "corpus/corpus.hpp"
#include "corpus/preference.hpp"

namespace manifuzz {

Corpus read_known(const std::filesystem::path& folder) {
  if (folder.empty()) throw UserError("--corpus: is empty; a folder is expected");
  std::error_code unreadable;
  if (!std::filesystem::exists(folder, unreadable) && !unreadable) return {};
  return read_corpus({&folder, 1});
}

Corpus read_corpus_folder(const std::filesystem::path& folder) {
  Corpus corpus = read_known(folder);
  if (!corpus.errors.empty()) throw UserError(corpus.errors.front());
  return corpus;
}

std::vector<PairCase> pairs_of(const Corpus& corpus, std::uint64_t seed) {
  std::set<std::string> accepted;
  for (const CorpusCase& known : corpus.cases) {
    if (known.accepted) accepted.insert(known.path);
  }
  std::vector<PairCase> pairs;
  for (const CorpusCase& known : corpus.cases) {
    const bool found_here = known.found && known.found->seed == seed;
    const bool is_accepted = accepted.contains(shrunk_beside(known.path));
    const bool is_bred = known.found && known.found->regime == kRegimeOfHunts;
    if (!found_here && !is_accepted && !is_bred && known.property.empty()) {
      pairs.push_back(known.pair());
    }
  }
  return pairs;
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kListedMax = 5;

using CaseList = std::vector<const CorpusCase*>;

std::string dashed(std::string text) {
  std::ranges::replace(text, '/', '-');
  return text;
}

/// Whether it is that bucket, or that bucket with its error class.
bool is_of(const std::string& bucket, const std::string& wanted) {
  constexpr int kDashes = 4;  // without a class
  return bucket == wanted ||
         (std::ranges::count(wanted, '-') == kDashes && bucket.starts_with(wanted + '-'));
}

std::string file_name(const CorpusCase& known) {
  return fs::path(known.path).filename().string();
}

std::string bucket_of(const CorpusCase& known) {
  return known.expect ? known.expect->bucket : "";
}

/// Files that match; the worst ones, which lie beside their shrunk forms, only where no other does.
template <class Matches>
CaseList matching(const std::vector<CorpusCase>& corpus, const Matches& matches) {
  CaseList shrunk;
  CaseList worst;
  for (const CorpusCase& known : corpus) {
    const bool is_file = known.path.ends_with(".json");  // not a line of one
    if (is_file && matches(known)) (is_worst(known.path) ? worst : shrunk).push_back(&known);
  }
  return shrunk.empty() ? worst : shrunk;
}

/// "corpus", or "corpus and build/found".
std::string in_words(std::span<const fs::path> folders) {
  std::vector<std::string> names;
  for (const fs::path& folder : folders) names.push_back(printable_path(folder));
  return fmt::format("{}", fmt::join(names, " and "));
}

[[noreturn]] void complain_of_none(const std::string& name, std::span<const fs::path> folders,
                                   const std::vector<CorpusCase>& corpus) {
  std::set<std::string> names;
  for (const CorpusCase& known : corpus) {
    names.insert({bucket_of(known), dashed(bucket_of(known)), file_name(known)});
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw UserError(fmt::format("{}: there is no such file, and no such bucket or file in {}{}",
                              printable_path(name), in_words(folders), did_you_mean(name, views)));
}

[[noreturn]] void complain_of_several(const std::string& name, std::span<const fs::path> folders,
                                      const CaseList& found) {
  std::vector<std::string> names;
  for (const CorpusCase* const known : found) names.push_back(printable_path(file_name(*known)));
  std::ranges::sort(names);
  names.resize(std::min(names.size(), kListedMax));
  const std::size_t left = found.size() - names.size();
  const std::string more = left > 0 ? fmt::format(" and {} more", left) : "";
  throw UserError(fmt::format("{}: {} files in {} have names that begin so: {}{}",
                              printable_path(name), found.size(), in_words(folders),
                              fmt::join(names, ", "), more));
}

}  // namespace

FoundCase find_case(const std::string& name, std::span<const fs::path> folders) {
  std::error_code unknown;
  if (name == "-" || fs::exists(name, unknown)) return {name};
  const std::vector<CorpusCase> corpus = read_corpus(folders).all();  // what is whole of it
  const std::string wanted = dashed(name);
  const CaseList alike = matching(
      corpus, [&](const CorpusCase& known) { return is_of(dashed(bucket_of(known)), wanted); });
  if (!alike.empty()) {
    const CorpusCase& smallest = **std::ranges::min_element(
        alike, {}, [](const CorpusCase* known) { return preference(*known); });
    const std::string of =
        alike.size() > 1 ? fmt::format(", the smallest of {} with that bucket", alike.size()) : "";
    return {smallest.path, fmt::format("using {}{}", printable_path(smallest.path), of)};
  }
  const CaseList begun = matching(
      corpus, [&](const CorpusCase& known) { return file_name(known).starts_with(wanted); });
  if (begun.empty()) complain_of_none(name, folders, corpus);
  if (begun.size() > 1) complain_of_several(name, folders, begun);
  const std::string& path = begun.front()->path;
  return {path, fmt::format("using {}", printable_path(path))};
}

}  // namespace manifuzz
