#include <array>
#include <cerrno>
#include <poll.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/json.hpp"
#include "external/external_collider.hpp"
#include "process/patience.hpp"
#include "process/signals.hpp"

namespace manifuzz {
namespace {

constexpr int kPollMilliseconds = 50;

/// One that it started, which may answer in its place, has no longer.
constexpr double kSecondsAfterDeath = 0.5;

/// A command of words alone: it can take the shell's place, so that it dies with us as the shell
/// would. One that sets variables first, or is several, is left to the shell.
bool is_simple(const std::string& command) {
  const std::string first_word = command.substr(0, command.find(' '));
  return command.find_first_of(";|&(){}!\n") == std::string::npos &&
         first_word.find('=') == std::string::npos;
}

}  // namespace

BatchResult ProgramProcess::ask(std::span<const PairCase> pairs, std::span<Answer> answers,
                                const std::function<bool()>& go_on) {
  Lines lines{.text = {},
              .count = pairs.size(),
              .take =
                  [&](std::size_t i, const JsonView& answer) {
                    answers[i] = read_reported_answer(answer, pairs[i], conventions);
                  },
              .refuse =
                  [&](std::size_t i, const std::string& why) {
                    answers[i] = Lost{Lost::How::malformed, why};
                  }};
  for (const PairCase& pair : pairs) {
    append_program_line(lines.text, pair, scalar);
    lines.text += '\n';
  }
  return ask(lines, go_on);
}

BatchResult ProgramProcess::ask(const Lines& lines, const std::function<bool()>& go_on) {
  // What it wrote unasked belongs to no case: better begin anew.
  if (child_.running() && (!unread_.empty() || wait_readable(child_.from(), 0))) {
    const bool has_more = !unread_.empty() || (read_some() && !unread_.empty());
    stop();
    if (has_more && !lines.may_restart) {
      return {0, BatchEnd::extra_lines, "it answers more often than once a frame"};
    }
  }
  const bool was_running = child_.running();
  if (!was_running && !lines.may_restart) {
    return {0, BatchEnd::exited, "it ended between two frames"};
  }
  if (!was_running) start();
  BatchResult result = exchange(lines, go_on);
  if (was_running && lines.may_restart && result.end == BatchEnd::exited && result.answered == 0) {
    start();  // what it died of may lie before these cases
    result = exchange(lines, go_on);
  }
  if (result.end == BatchEnd::stopped) stop();
  return result;
}

BatchResult ProgramProcess::exchange(const Lines& lines, const std::function<bool()>& go_on) {
  BatchResult result;
  std::string_view unwritten = lines.text;
  Patience patience;
  patience.begin(child_.process());  // with the start, or with the case at work
  bool reads = true;
  bool has_errors = true;
  while (result.answered < lines.count && result.end == BatchEnd::answered) {
    std::array<pollfd, 3> watched{{{child_.from(), POLLIN, 0},
                                   {has_errors ? child_.errors() : -1, POLLIN, 0},
                                   {unwritten.empty() ? -1 : child_.to(), POLLOUT, 0}}};
    poll(watched.data(), watched.size(), kPollMilliseconds);
    if (watched[2].revents != 0) reads = write_some(unwritten);
    const std::size_t before = result.answered;
    const bool was_ready = is_ready();
    const bool open = watched[0].revents == 0 || read_some();
    take_lines(lines, result);
    if (watched[1].revents != 0) has_errors = pass_on_errors();
    if (result.answered > before || is_ready() != was_ready) {
      patience.begin(child_.process());
    }
    if (result.answered > before) error_output_.begin_case();
    if (result.answered == lines.count || result.end != BatchEnd::answered) break;
    const bool has_died = child_.has_ended();  // what it started may keep its pipe open
    const double most = has_died ? kSecondsAfterDeath : is_ready() ? case_seconds : start_seconds;
    const bool is_late = patience.is_over(most);
    if (!open || (is_late && (!reads || has_died))) {
      result.end = BatchEnd::exited;
    } else if (!go_on() || is_out_of_time()) {
      result.end = BatchEnd::stopped;
    } else if (is_late) {
      result.end = BatchEnd::timed_out;
      result.why = fmt::format("no answer in {} s; is every line flushed?", most);
    }
  }
  if (result.end == BatchEnd::answered && !unread_.empty()) {
    result.end = BatchEnd::extra_lines;
    result.why = "more answers than cases";
  }
  return result;
}

bool ProgramProcess::writes_more(double seconds) {
  return child_.running() && wait_readable(child_.from(), seconds) && read_some();
}

std::string ProgramProcess::stop() {
  if (child_.running()) pass_on_errors();
  error_output_.begin_case();
  unread_.clear();
  has_answered_ = false;
  return child_.stop();
}

Lost ProgramProcess::lost_by(const BatchResult& result) {
  const std::string death = stop();
  const std::string& why = death.empty() ? result.why : death;
  if (result.end == BatchEnd::exited) {
    return {Lost::How::crashed, why.empty() ? "closed its output" : why};
  }
  const bool is_late = result.end == BatchEnd::timed_out;
  return {is_late ? Lost::How::timed_out : Lost::How::malformed, result.why};
}

void ProgramProcess::start() {
  stop();
  declaration_.clear();
  child_.start([&](int in, int out) {
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    const std::string line = is_simple(command_) ? "exec " + command_ : command_;
    execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  });
}

/// False where nobody reads it any more.
bool ProgramProcess::write_some(std::string_view& text) {
  const ssize_t written = write(child_.to(), text.data(), text.size());
  if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  if (written >= 0 || errno != EPIPE) return true;
  text = {};  // its answers will end too
  return false;
}

/// False at the end of its output.
bool ProgramProcess::read_some() {
  std::array<char, 1 << 16> buffer;
  const ssize_t count = read(child_.from(), buffer.data(), buffer.size());
  if (count > 0) unread_.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

/// As much as its pipe holds; false at the end.
bool ProgramProcess::pass_on_errors() {
  std::array<char, 1 << 16> buffer;
  const ssize_t count = read(child_.errors(), buffer.data(), buffer.size());
  if (count > 0) error_output_.pass_on({buffer.data(), static_cast<std::size_t>(count)});
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

void ProgramProcess::take_lines(const Lines& lines, BatchResult& result) {
  while (result.answered < lines.count) {
    const std::size_t end = unread_.find('\n');
    if (end == std::string::npos) break;
    const std::string line = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    if (is_blank(line)) continue;
    bool is_answer = line.starts_with('{');  // perhaps one that cannot be read
    try {
      if (line.size() > kLongestCase) throw UserError("longer than 1 MiB");
      const JsonTree tree = parse_json(line);
      is_answer = true;
      const JsonView view(tree);
      if (!has_answered_ && declaration_.empty() && view.is_object() && view.find("declaration")) {
        declaration_ = line;
        continue;
      }
      lines.take(result.answered, view);
    } catch (const UserError& error) {
      if (!is_answer) {
        result.end = BatchEnd::not_json;
        result.why = fmt::format("'{}': {}", printable(line), error.what());
        return;
      }
      lines.refuse(result.answered, error.what());
    }
    ++result.answered;
    has_answered_ = true;
  }
  if (unread_.size() > kLongestCase) {
    result.end = BatchEnd::not_json;
    result.why = "a line longer than 1 MiB";
  }
}

}  // namespace manifuzz
