#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "campaign/replay.hpp"
#include "campaign/result.hpp"
#include "campaign/run.hpp"

namespace manifuzz {

/// The value of a variable of the environment; empty where there is none.
std::string environment(const char* name);

// Colours, and what a person at a terminal is told beside the results.

/// From now on words are coloured on each stream that is an able terminal, unless the environment
/// names NO_COLOR. Before, nowhere: text that is built for a file or a test is plain.
void allow_colours();

/// A word for stdout, its spaces included: what is well, what decides a status, what is new.
std::string good(std::string_view word);
std::string bad(std::string_view word);
std::string fresh(std::string_view word);

/// What is wrong, a line on the standard error: "manifuzz: what".
void write_complaint(std::string_view what);
void write_complaints(const std::vector<std::string>& all);

/// From now on nothing but data, what is wrong, and what decides a status.
void be_quiet();
bool is_quiet();

/// A line on the standard error that nothing depends on; none when quiet.
void write_remark(std::string_view line);

/// One line on a terminal, written over and over; nothing when quiet, and where stderr is no
/// terminal that could erase it.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine& operator=(ProgressLine&&) = delete;  // neither moved nor copied

  void show(std::string_view text) const;

 private:
  bool is_shown_;
};

/// Whether tables are left out: when quiet, where this file (empty: none, "-": stdout) has what
/// they say.
bool leaves_out_tables(std::string_view file);

/// JSON as it is written for people and programs: indented, with a line's end. Paths need not be
/// UTF-8; what is not is replaced.
std::string json_text(const nlohmann::ordered_json& json);

/// Outputs that are written one by one: one that fails is named, once, and no other is lost by
/// that.
class Outputs {
 public:
  /// Runs what writes an output, if it is asked for; it may throw a UserError.
  void write(bool is_asked, const std::function<void()>& write_it);
  /// What went wrong beside the writing, if anything did.
  void add_error(const std::string& what);

  /// What is said of a run that was interrupted; its outputs are written and say so too.
  void add_interruption(const std::string& what);

  bool are_written() const { return are_written_; }
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  std::vector<std::string> errors_;
  bool are_written_ = true;
};

/// Whether the collider of that name is there on any machine.
using IsAtHand = std::function<bool(const std::string& collider)>;

/// What somebody new can do next, in about a dozen lines: commands that work when pasted where they
/// are, and a case of `corpus` to look at, where there is such a folder. `program` is this one as
/// it was called.
std::string next_steps(const std::string& program, const std::string& corpus,
                       const IsAtHand& is_at_hand);

/// How a run is called again, for a shell: this program, and the options that choose colliders,
/// seed and corpus.
struct CalledAgain {
  std::string program;
  std::string options;
  std::string to_show{};  ///< those of `show` for a case that it saved, with the space before
};

// What campaigns, replays, properties and lists print, for people.

/// How many findings of so many cases were written to that folder, and the verdicts of the result.
std::string merged_text(const MergedRuns& runs, std::size_t cases, const std::string& folder);

/// "FILE: there is no collider ...", of a case whose subject is not at hand.
std::string why_unasked(const CorpusCase& unasked);
/// Whose finding is accepted and comes no more, a line each.
std::string stale_in_words(std::span<const std::string> files);
/// A line that counts; empty where there was no case.
std::string replay_counts(const ReplayRun& run);
/// What failed, a line each, and that line.
std::string replay_text(const ReplayRun& run);
/// What `replay --json` writes beside where it ran; `unread` files could not be read.
void append_replay_json(nlohmann::ordered_json& json, const ReplayRun& run, std::size_t unread);

/// What RapidCheck says, how to repeat a failure, and where its case was written.
std::string property_text(const CheckedProperty& checked);
/// All of them in at most 20 lines: how many hold, and of those that fail the command that shows
/// it.
std::string property_screen(std::span<const CheckedProperty> checked, const std::string& subject,
                            const CalledAgain& again);
/// A property that holds, in a line.
std::string property_line(const CheckedProperty& checked);

/// What there is, a line each, with its description.
std::string collider_line(const Declaration& declaration);
std::string list_regimes();
std::string list_sweeps();
std::string list_scenes();
std::string list_ledger();

}  // namespace manifuzz
