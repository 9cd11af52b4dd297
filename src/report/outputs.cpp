#include "report/outputs.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>

#include "base/text.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"

namespace manifuzz {
namespace {

bool quiet = false;

/// Terminals' own names for colours, so that every theme is legible.
constexpr std::string_view kRed = "\x1b[31m";
constexpr std::string_view kGreen = "\x1b[32m";
constexpr std::string_view kYellow = "\x1b[33m";
constexpr std::string_view kPlain = "\x1b[0m";

bool stdout_is_coloured = false;
bool stderr_is_coloured = false;

/// Whether that stream is a terminal that can colour and erase; one without a name or named `dumb`
/// cannot.
bool is_able_terminal(int stream) {
  const std::string name = environment("TERM");
  return isatty(stream) == 1 && !name.empty() && name != "dumb";
}

std::string coloured(bool is_coloured, std::string_view colour, std::string_view word) {
  return is_coloured ? fmt::format("{}{}{}", colour, word, kPlain) : std::string(word);
}

/// How much a case has to tell: most where the subject is at fault, least where nobody is, or where
/// its colliders may be missing.
int weight_of(const CorpusCase& known, const IsAtHand& is_at_hand) {
  if (!known.expect || !is_at_hand(known.expect->subject) || !is_at_hand(known.expect->oracle)) {
    return 0;
  }
  const std::string& bucket = known.expect->bucket;
  if (bucket.starts_with("subject/") || bucket.starts_with("both/")) return 3;
  return bucket.starts_with("oracle/") ? 2 : 1;
}

std::string steps_with(const Corpus& corpus, const std::string& program, const std::string& folder,
                       const IsAtHand& is_at_hand) {
  const auto most = std::ranges::max_element(
      corpus.cases, {}, [&](const CorpusCase& known) { return weight_of(known, is_at_hand); });
  std::string text =
      fmt::format("{} holds {}. Look at one, and replay all of them after a change:\n",
                  printable(folder, 200), counted(corpus.cases.size(), "case"));
  text += fmt::format("  {} show {}\n", program, quoted_for_shell(most->path));
  return text + fmt::format("  {} replay {}\n", program, quoted_for_shell(folder));
}

}  // namespace

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void allow_colours() {
  if (!environment("NO_COLOR").empty()) return;
  stdout_is_coloured = is_able_terminal(STDOUT_FILENO);
  stderr_is_coloured = is_able_terminal(STDERR_FILENO);
}

std::string good(std::string_view word) {
  return coloured(stdout_is_coloured, kGreen, word);
}

std::string bad(std::string_view word) {
  return coloured(stdout_is_coloured, kRed, word);
}

std::string fresh(std::string_view word) {
  return coloured(stdout_is_coloured, kYellow, word);
}

void write_complaint(std::string_view what) {
  write_error(fmt::format("{} {}\n", coloured(stderr_is_coloured, kRed, "manifuzz:"), what));
}

void write_complaints(const std::vector<std::string>& all) {
  for (const std::string& what : all) write_complaint(what);
}

void be_quiet() {
  quiet = true;
}

bool is_quiet() {
  return quiet;
}

void write_remark(std::string_view line) {
  if (!quiet) write_error(fmt::format("{}\n", line));
}

ProgressLine::ProgressLine() : is_shown_(!quiet && is_able_terminal(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  show("");
}

void ProgressLine::show(std::string_view text) const {
  if (is_shown_) write_error("\r" + std::string(text) + "\x1b[K");
}

bool leaves_out_tables(std::string_view file) {
  return is_quiet() && !file.empty() && file != "-";
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void Outputs::write(bool is_asked, const std::function<void()>& write_it) {
  if (!is_asked) return;
  try {
    write_it();
  } catch (const UserError& error) {
    add_error(error.what());
  }
}

void Outputs::add_error(const std::string& what) {
  if (what.empty()) return;
  are_written_ = false;
  add_interruption(what);
}

void Outputs::add_interruption(const std::string& what) {
  if (std::ranges::find(errors_, what) != errors_.end()) return;
  write_complaint(what);
  errors_.push_back(what);
}

std::string next_steps(const std::string& program, const std::string& corpus,
                       const IsAtHand& is_at_hand) {
  const std::filesystem::path folder(corpus);
  const Corpus known = read_corpus({&folder, 1});
  const std::string by = quoted_for_shell(program);
  std::string text =
      "manifuzz says which contact manifolds of a 2D collider are wrong, and why.\n\n";
  if (!known.cases.empty()) text += steps_with(known, by, corpus, is_at_hand) + '\n';
  text += "Look for wrong manifolds for ten seconds; findings are printed with file and command:\n";
  text += fmt::format("  {} fuzz --seconds 10\n\n", by);
  text +=
      "Test a collider of your own: put the command that runs it in place of the one in quotes.\n";
  text += fmt::format(
      "  {0} fuzz --subject-command {1} --oracle clip64 --cases 20000\n\n", by,
      quoted_for_shell(fmt::format("{} collide --collider {}", by, usual_oracle_name())));
  return text + fmt::format("For everything else:\n  {} --help\n", by);
}

}  // namespace manifuzz
