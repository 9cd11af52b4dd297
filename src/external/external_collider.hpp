#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "collider/collider.hpp"
#include "collider/sequence_collider.hpp"
#include "exchange/json.hpp"
#include "external/c_body.hpp"
#include "external/error_output.hpp"
#include "external/side_effects.hpp"
#include "process/child.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// A shared library, loaded into this process for good. Throws UserError that says why it cannot
/// be.
void* open_library(const std::string& path);

/// What came of a call of `manifuzz_collide`.
struct LibraryCall {
  int status = 0;  ///< what it returned
  SideEffect effect = SideEffect::none;
};

using CollideFunction = decltype(&manifuzz_collide);

/// Calls `manifuzz_collide`; the manifold comes zeroed. What else it does to this process is
/// undone.
LibraryCall call(CollideFunction collide, const PairCase& pair, manifuzz_manifold& manifold);

/// A shared library after manifuzz_collider.h, loaded into this process for good.
class Library {
 public:
  /// Throws UserError that says what is wrong with it.
  explicit Library(const std::string& path);

  const manifuzz_declaration& declaration() const { return declaration_; }
  LibraryCall collide(const PairCase& pair, manifuzz_manifold& manifold) const;
  /// The function itself.
  CollideFunction function() const { return collide_; }

 private:
  manifuzz_declaration declaration_{};
  CollideFunction collide_ = nullptr;
};

/// The declaration as a `Declaration`. Throws UserError that names the field that is wrong.
Declaration declaration_of(const manifuzz_declaration& declared);

/// What `manifuzz_collide` returned for a case (0, or 1 where it declines) and the manifold that it
/// filled in, as an answer: in A's frame, its normal from A to B; `Lost` where it is none, or
/// contradicts the declaration, and where the call did anything besides.
Answer answer_of(const LibraryCall& call, const manifuzz_manifold& manifold,
                 const Declaration& declaration, const manifuzz_declaration& declared,
                 const PairCase& pair);

/// The two names of manifuzz_collider.h, wherever they are from, as a collider in this process.
/// Throws UserError where the declaration is nonsense.
Collider collider_of_function(const manifuzz_declaration& declared, CollideFunction collide);

/// A shared library after manifuzz_collider.h as a collider in this process: the fastest, but where
/// it crashes, so does this process. Throws UserError where the library cannot be loaded.
Collider collider_in_process(const std::string& path);

/// `manifuzz_collide` of that library through all pairs once, their bodies filled in before and
/// each manifold zeroed. Throws UserError where the library cannot be loaded.
std::function<void()> library_pass(const std::string& path, std::span<const PairCase> pairs);

/// A pass through a function that does nothing: it takes the time of the interface itself.
std::function<void()> interface_pass(std::span<const PairCase> pairs);

/// A shared library after manifuzz_collider.h as a collider in a process of its own: one that
/// crashes, hangs longer than `seconds_max` over a case or scribbles over its memory loses that
/// case. Throws UserError where the library cannot be loaded.
Collider collider_in_own_process(const std::string& path, double seconds_max);

/// A program's start, up to its declaration or, of one that declares nothing, its first answer, may
/// take so long: it may have to be compiled.
inline constexpr double kStartSecondsMax = 10;

/// A program that answers case lines with manifold lines (corpus/README.md states both), as a
/// collider. One that dies, hangs longer than `seconds_max` over a case (not counting its start, of
/// `start_seconds_max`), or answers what is no manifold, loses that case. Throws UserError where it
/// cannot be started or declares nonsense.
Collider collider_of_command(const std::string& command, double seconds_max,
                             double start_seconds_max = kStartSecondsMax);

/// What a program declares of itself.
struct ProgramDeclaration {
  Declaration declaration;
  std::optional<Keeping> keeping{};  ///< of the points that it keeps, if it says so
};

/// Reads its line {"declaration": {...}}; an empty line declares nothing. Throws UserError.
ProgramDeclaration program_declaration(const std::string& command, const std::string& line);

/// The case that a program is asked first, so that it can declare itself.
PairCase overlapping_boxes();

/// A program that keeps points and answers frames: it gets a line each of {"sequence": id,
/// "frame": k, ...case}. What it loses ends its sequence; it is started anew before the next.
SequenceCollider keeper_of_command(const std::string& command, double seconds_max,
                                   double start_seconds_max = kStartSecondsMax);

/// How a collider from outside is called: by one of both.
struct NamedSubject {
  std::string command;
  std::string library;
  std::string file{};  ///< that says so
};
using NamedSubjects = std::map<std::string, NamedSubject, std::less<>>;

/// Where names are looked for.
struct SubjectsFrom {
  std::string file{};                            ///< whoever owns it; empty: none was named
  std::vector<std::filesystem::path> corpora{};  ///< else by the folders that a command reads
};

/// The names that files called subjects.json give to colliders, {"NAME": {"command": "..."}} or
/// {"library": "..."}: in or beside each folder of cases, and owned by this user or root. Throws
/// UserError that begins with the file's name.
NamedSubjects read_subjects(const SubjectsFrom& from);

/// How a batch of cases ended.
enum class BatchEnd {
  answered,     ///< every case has its answer
  stopped,      ///< we did not want to go on
  exited,       ///< it ended, or its output did
  timed_out,    ///< no answer in time
  not_json,     ///< a line that is not JSON: what follows may answer another case
  extra_lines,  ///< more lines than cases
};

struct BatchResult {
  std::size_t answered = 0;  ///< of the cases, in order
  BatchEnd end = BatchEnd::answered;
  std::string why;
};

/// A program that reads pair cases, a line each, on its standard input, and writes a manifold line
/// for each to its standard output, in order. Before its first answer it may write its declaration.
/// An answer that is JSON but no manifold is `Lost`, and its case's alone.
class ProgramProcess {
 public:
  ProgramProcess(std::string command, double start_seconds_max, double case_seconds_max)
      : start_seconds(start_seconds_max),
        case_seconds(case_seconds_max),
        command_(std::move(command)),
        error_output_(command_) {}

  double start_seconds;     ///< until a process is ready: it has declared itself, or answered
  double case_seconds;      ///< over a case, once it is ready
  Conventions conventions;  ///< of its answers, as it declares them
  ScalarType scalar = ScalarType::float32;  ///< that it computes in, as it declares

  /// Asks all at once, and reads while it writes; starts the program where it does not run, again
  /// where it died before it was asked. `go_on` is asked several times a second; where it says no,
  /// the program is ended, since the answers that it owes belong to no later case.
  BatchResult ask(std::span<const PairCase> pairs, std::span<Answer> answers,
                  const std::function<bool()>& go_on);

  /// Lines other than cases, each with its end; what `take` throws goes to `refuse`.
  struct Lines {
    std::string text;
    std::size_t count = 0;
    std::function<void(std::size_t index, const JsonView& answer)> take;
    std::function<void(std::size_t index, const std::string& why)> refuse;
    bool may_restart = true;  ///< else one that does not run any more has exited
  };
  BatchResult ask(const Lines& lines, const std::function<bool()>& go_on);

  /// Whether it writes more than it was asked for, within that time.
  bool writes_more(double seconds);

  /// Ends the program. Says how it had ended, if it had by itself.
  std::string stop();
  /// Ends the program too: what it has lost where a batch ended otherwise than answered or stopped.
  Lost lost_by(const BatchResult& result);

  /// The declaration of the last start, a line of JSON, or empty.
  const std::string& declaration() const { return declaration_; }

 private:
  BatchResult exchange(const Lines& lines, const std::function<bool()>& go_on);
  void start();
  bool is_ready() const { return has_answered_ || !declaration_.empty(); }
  bool write_some(std::string_view& text);
  bool read_some();
  bool pass_on_errors();
  void take_lines(const Lines& lines, BatchResult& result);

  std::string command_;
  ErrorOutput error_output_;
  Child child_;
  std::string unread_;
  std::string declaration_;
  bool has_answered_ = false;  ///< since it was started
};

/// Whether a collider that declares this has to be asked at all.
std::optional<Unsupported> beyond_limits(const Declaration& declaration, const PairCase& pair);

/// Whether it can name a collider, and thus files: 1 to 40 letters, digits, - _ or dots.
bool is_collider_name(std::string_view name);

/// What must hold of the declaration of any program or library: a name that can name files, a
/// finite bias, a snippet whose blanks can be filled in. Throws UserError that begins with `prefix`
/// and the field.
void check_declaration(const Declaration& declaration, std::string_view prefix);

/// So many cases are asked at once: enough to hide the round trip's cost, few enough for the cache.
inline constexpr std::size_t kBatch = 256;

/// A collider that does nothing but die or hang is not worth all the cases.
inline constexpr int kLossesInARowMax = 20;

/// Whether the last kLossesInARowMax of the first `done` answers were all lost.
bool is_unresponsive(std::span<const Answer> answers, std::size_t done);

/// What answers up to kBatch cases, as Collider::collide_many does: one at least, unless told to
/// stop.
using AnswerBatch = decltype(Collider::collide_many);

/// The collider of a process of its own, which takes up to so long over a case: it is not asked
/// what is beyond its limits.
Collider isolated(const Declaration& declaration, double seconds_max,
                  const AnswerBatch& answer_batch);

}  // namespace manifuzz
