#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.hpp"
#include "exchange/json.hpp"

namespace manifuzz {

/// Where a case came from: case `index` of `regime` under `seed`, before it was shrunk.
struct Found {
  std::uint64_t seed = 0;
  std::string regime;
  std::uint64_t index = 0;
  std::map<std::string, std::string> versions;  ///< of the colliders that ran, by name
};

/// What was seen when the case was saved. Empty strings were not recorded.
struct Expectation {
  std::string subject;
  std::string oracle;
  std::string verdict;
  std::string bucket;
  std::vector<NamedAnswer> manifolds;    ///< the right ones by kJudgeName, then the colliders'
  std::optional<double> severity = {};   ///< the share of neighbours that fail alike, 0 to 1
  std::optional<double> magnitude = {};  ///< the worst error as a share of the size, or infinite
};

/// A case as corpus/README.md describes it; a bare pair case is one without the other keys.
struct CorpusCase {
  PairCase pair;
  std::optional<Found> found;
  std::optional<Expectation> expect;
  std::string property;  ///< the property that failed on it, or empty
  std::string note;      ///< a sentence of why it is kept, or empty
  std::string path;  ///< the file it was read from, with :line for a line; for errors and reports
};

/// Whether the key "format" may be left out.
enum class FormatKey { required, optional };

/// Reads one case, the white space around it is free. Throws UserError that begins with a JSON path
/// or a line and column; callers put the file's name before it.
CorpusCase parse_case(std::string_view text, FormatKey format_key);

/// The same of a value that is parsed already.
CorpusCase read_case(const JsonView& root, FormatKey format_key);

/// The case on a line that is not blank; errors as `parse_case`.
CorpusCase parse_line(const Line& line);

/// The one case that a file, or the standard input ("-"), holds; errors begin with the file's name.
/// Files named *.json must name the format.
CorpusCase read_case_file(const std::string& path);

/// The text of a corpus file: a line for each polygon and each manifold.
std::string format_case(const CorpusCase& corpus_case);

struct Corpus {
  std::vector<CorpusCase> cases;
  std::vector<std::string> errors;             ///< one line for each file or folder that is broken
  std::vector<std::filesystem::path> files{};  ///< all that were read, broken ones too
};

/// The files of cases (*.json, *.jsonl) among these and in these folders and below, sorted by path,
/// each once, however it is spelled or linked. What is neither adds an error line.
std::vector<std::filesystem::path> find_case_files(std::span<const std::filesystem::path> paths,
                                                   std::vector<std::string>& errors);

/// Adds the cases of one file (*.json: one case; *.jsonl: one a line), or an error line.
void add_case_file(const std::filesystem::path& path, Corpus& corpus);

/// Every case in these files and folders (all such files in
/// them and below), sorted by path. What is broken gives an error line, the rest is read all the
/// same.
Corpus read_corpus(std::span<const std::filesystem::path> paths);

/// The name of a case's file: its bucket (or the property, or "case") with dashes for slashes, and
/// a hash of its pair. Cases with equal pairs and equal buckets share it.
std::string corpus_file_name(const CorpusCase& corpus_case);

/// Where the case belongs in the folder: the file of that name, or, where that holds anything else,
/// the first of name-2.json, name-3.json, ... that holds it or is free.
std::filesystem::path corpus_file(const std::filesystem::path& folder,
                                  const CorpusCase& corpus_case);

/// Writes the case there, whole or not at all; a file that has this pair as the same finding
/// already stays as it is, whatever was noted in it since. Returns its path. Throws UserError.
std::filesystem::path write_corpus_case(const std::filesystem::path& folder,
                                        const CorpusCase& corpus_case);

/// The file beside `file` for the case that it was shrunk from: name.worst.json for name.json.
std::filesystem::path worst_beside(const std::filesystem::path& file);

/// Whether a file's name says that it is such a case, and the file that it was shrunk to: the
/// path itself for any other.
bool is_worst(std::string_view path);
std::string shrunk_beside(std::string_view path);

/// Writes that case there.
void write_worst_case(const std::filesystem::path& file, const CorpusCase& worst);

}  // namespace manifuzz
