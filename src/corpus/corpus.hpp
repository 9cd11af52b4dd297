#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/file.hpp"
#include "base/text.hpp"
#include "corpus/acceptance.hpp"
#include "exchange/json.hpp"
#include "geometry/pair_case.hpp"
#include "geometry/sequence.hpp"

namespace manifuzz {

/// Where a case came from: case `index` of `regime` under `seed`, before it was shrunk.
struct Found {
  std::uint64_t seed = 0;
  std::string regime;
  std::uint64_t index = 0;
  std::map<std::string, std::string> versions;  ///< of the colliders that ran, by name
  std::optional<Seen> seen = {};                ///< of what somebody is to blame for
  bool is_unshrunk = false;                     ///< there was no time to make it smaller
};

/// What was seen when the case was saved. Empty strings were not recorded.
struct Expectation {
  std::string subject;
  std::string oracle;
  std::string verdict;
  std::string bucket;
  std::vector<NamedAnswer> manifolds;    ///< the right ones by kJudgeName, then the colliders'
  std::optional<double> severity = {};   ///< the share of neighbours that fail alike, 0 to 1
  std::optional<double> magnitude = {};  ///< how wrong, as a share of the size, or infinite
  std::optional<Errors> errors = {};     ///< in what; not recorded by older versions
};

/// A case of any kind. Each kind has functions of one name for its own type, such as
/// `append_case_line`, and formats of its own.
using AnyCase = std::variant<PairCase, Sequence>;

/// Appends a case as one line, without the line's end.
void append_case_line(std::string& out, const AnyCase& any);

/// Which cases are read, in the order of AnyCase; the others are errors.
enum class CaseKind { pair, sequence, either };

/// The kind of a case.
inline CaseKind kind_of(const AnyCase& any) {
  return static_cast<CaseKind>(any.index());
}

/// How many frames a case has; a pair case has none.
inline std::size_t frames_in(const AnyCase& any) {
  const auto* const sequence = std::get_if<Sequence>(&any);
  return sequence != nullptr ? sequence->frames.size() : 0;
}

/// A case as corpus/README.md describes it; a bare one is one without the other keys.
struct CorpusCase {
  AnyCase any;
  std::optional<Found> found = {};
  std::optional<Expectation> expect = {};
  std::optional<Acceptance> accepted = {};
  std::string property = {};  ///< the property that failed on it, or empty
  std::string note = {};      ///< a sentence of why it is kept, or empty
  std::string path =
      {};  ///< the file it was read from, with :line for a line; for errors and reports

  /// The pair or the sequence that it must be.
  const PairCase& pair() const { return std::get<PairCase>(any); }
  const Sequence& sequence() const { return std::get<Sequence>(any); }
};

/// Whether the key "format" may be left out.
enum class FormatKey { required, optional };

/// The value of the key "format" in each line of a file of the conformance suite, which holds no
/// cases to replay: whatever reads a corpus passes over it.
inline constexpr std::string_view kConformanceFormat = "manifuzz/conformance/1";

/// Reads one case, the white space around it is free. Throws UserError that begins with a JSON path
/// or a line and column; callers put the file's name before it.
CorpusCase parse_case(std::string_view text, FormatKey format_key, CaseKind kind = CaseKind::pair);

/// Reads one case from a value that is parsed already.
CorpusCase read_case(const JsonView& root, FormatKey format_key, CaseKind kind = CaseKind::pair);

/// The case on a line that is not blank; errors as `parse_case`.
CorpusCase parse_line(const Line& line, CaseKind kind = CaseKind::pair);

/// The one case that a file, or the standard input ("-"), holds; errors begin with the file's name.
/// Files named *.json must name the format.
CorpusCase read_case_file(const std::string& path, CaseKind kind = CaseKind::pair);

/// The text of a corpus file: a line for each polygon, each frame and each manifold.
std::string format_case(const CorpusCase& corpus_case);

/// Appends a case, and where it came from, as one line, without the line's end.
void append_found_case_line(std::string& out, const AnyCase& any, const Found& found,
                            std::string_view property = {});

struct Corpus {
  std::vector<CorpusCase> cases;               ///< pair cases
  std::vector<std::string> errors;             ///< one line for each file or folder that is broken
  std::vector<std::filesystem::path> files{};  ///< all that were read, broken ones too
  std::vector<CorpusCase> others{};            ///< of all other kinds, in the same order

  /// Adds it to its like.
  void add(CorpusCase one);
  /// Adds all of another corpus behind its own.
  void add(Corpus more);
  /// The cases among which those of a kind are.
  const std::vector<CorpusCase>& of(CaseKind kind) const {
    return kind == CaseKind::pair ? cases : others;
  }
  /// The others behind the pair cases.
  std::vector<CorpusCase> all() const;
};

/// The files of cases (*.json, *.jsonl) among these and in these folders and below, sorted by path,
/// each once, however it is spelled or linked. What is neither adds an error line.
std::vector<std::filesystem::path> find_case_files(std::span<const std::filesystem::path> paths,
                                                   std::vector<std::string>& errors);

/// Adds the cases of one file (*.json: one case; *.jsonl: one a line), or an error line.
void add_case_file(const std::filesystem::path& path, Corpus& corpus);

/// Every case in these files and folders (all such files in them and below), sorted by path. What
/// is broken gives an error line, the rest is read all the same.
Corpus read_corpus(std::span<const std::filesystem::path> paths);

/// The name of a case's file: its bucket (or the property, or "case") with dashes for slashes, and
/// a hash of its pair. Cases with equal pairs and equal buckets share it.
std::string corpus_file_name(const CorpusCase& corpus_case);

/// Where the case belongs in the folder: the file of that name, or, where that holds anything else,
/// the first of name-2.json, name-3.json, ... that holds it or is free.
std::filesystem::path corpus_file(const std::filesystem::path& folder,
                                  const CorpusCase& corpus_case);

/// The folders of a corpus that findings are saved in.
inline constexpr std::array<std::string_view, 6> kCorpusFolders{
    "seeds", "ties", "defects", "regressions", "sequences", "worst"};

/// Writes the case there, whole or not at all; a file that has this pair as the same finding
/// already stays as it is, whatever was noted in it since. Returns its path. Throws UserError.
std::filesystem::path write_corpus_case(const std::filesystem::path& folder,
                                        const CorpusCase& corpus_case);

/// Writes that acceptance into the case's file, or, with none, takes it out. Throws UserError.
void write_acceptance(const std::string& file, const std::optional<Acceptance>& acceptance);

/// The file beside `file` for the case that it was shrunk from: name.worst.json for name.json.
std::filesystem::path worst_beside(const std::filesystem::path& file);

/// Whether a file's name says that it is such a case, and the file that it was shrunk to: the
/// path itself for any other.
bool is_worst(std::string_view path);
std::string shrunk_beside(std::string_view path);

/// The collider whose worst case a hunt kept in that file, worst/COLLIDER/MEASURE.json: empty where
/// the file is none of these.
std::string collider_of_hunted(const std::filesystem::path& file);

/// Writes that case there.
void write_worst_case(const std::filesystem::path& file, const CorpusCase& worst);

/// Appends what answers a case, one line or several, the last without its end; throws UserError
/// where there is no answer. `index` counts the lines that are not blank, bad ones too, from 0.
using AnswerCase = std::function<void(const AnyCase& any, std::size_t index, std::string& lines)>;

/// Reads cases of a kind from a file (*.json: one; else one a line, blank lines skipped; "-":
/// stdin) and writes the lines for each to the standard output, in order and constant memory. A bad
/// line gives {"error": "...", "line": N} in its place. Whoever feeds a pipe gets every answer
/// before the next read. Throws UserError at the end where a line was bad, or where there was no
/// case.
void answer_each(const std::string& file, CaseKind kind, const AnswerCase& answer);

/// An option, and the file or folder that it names to be written; an empty path: none.
struct OutputPath {
  enum class Kind {
    data,    ///< a file, or "-" for the standard output
    file,    ///< a file
    folder,  ///< a folder for files that are no cases
    corpus,  ///< a folder for cases
  };
  std::string_view option;  ///< "--json"
  std::string path;
  Kind kind = Kind::data;
  std::vector<std::string_view> endings{};  ///< one of which a file's name must have, if any
  std::string replaces{};                   ///< an input whose place it may take
};

/// What the names of pictures end in.
inline const std::vector<std::string_view> kPictureEndings{".svg", ".png"};

/// Everything that a command reads and writes.
struct CommandFiles {
  std::vector<OutputPath> outputs;
  std::vector<std::filesystem::path> inputs{};  ///< files, and folders whose cases are read
};

/// What must not or cannot be written.
struct BadOutput : UserError {
  BadOutput(const std::string& what, std::vector<std::string_view> which)
      : UserError(what), options(std::move(which)) {}

  bool concerns(std::string_view option) const;

  std::vector<std::string_view> options;  ///< those that it is about
};

/// The check that every command makes before it runs; whether an output takes the standard output,
/// which then has nothing else. Paths are compared by the file that they mean, not by their
/// spelling. Throws BadOutput where two outputs go to one place; where one is a file that is read,
/// or would be taken for a case of a folder that is read or written; and where one cannot be made:
/// what is missing of it is made and taken away again.
bool check_outputs(const CommandFiles& files);

/// Whether this output would pass beside these, but for whether it can be made.
bool is_apart(const OutputPath& output, const CommandFiles& files);

/// What is known: a corpus folder, sorted by path, and a line for each broken file; empty where
/// there is no such folder. Throws UserError where none is named.
Corpus read_known(const std::filesystem::path& folder);

/// A corpus folder, sorted by path; empty where there is no such folder. Throws UserError on the
/// first broken file, for what is drawn from a corpus depends on all of it.
Corpus read_corpus_folder(const std::filesystem::path& folder);

/// In place of the regime of a case that a hunt bred.
inline constexpr std::string_view kRegimeOfHunts = "hunt";

/// The pairs that a campaign with this seed may mutate: all but those that the seed itself or a
/// property found, so that saving a finding changes no case and its command repeats it; and all but
/// accepted ones, around which the same mistake comes in every disguise, and those that hunts bred,
/// the worst there are, around which engines do what no ledger counts on.
std::vector<PairCase> pairs_of(const Corpus& corpus, std::uint64_t seed);

/// A case's file, and what there is to say of the choice.
struct FoundCase {
  std::string file;
  std::string remark{};  ///< "taken: ..." where the name was not the file's
};

/// The file that is meant: the name itself where it is "-" or exists. Else it is looked up in these
/// folders, as a bucket (with slashes or dashes), whose smallest case it is then, or as the
/// beginning of a file's name. Throws UserError where that gives no case, or several.
FoundCase find_case(const std::string& name, std::span<const std::filesystem::path> folders);

}  // namespace manifuzz
