#include <array>
#include <cerrno>
#include <poll.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/json.hpp"
#include "oracle/external/external_collider.hpp"

namespace manifuzz {
namespace {

constexpr int kPollMilliseconds = 50;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// An answer that is JSON but no manifold loses its case alone.
Answer answer_in(const JsonView& object, const PairCase& pair, const Conventions& conventions) {
  try {
    return read_reported_answer(object, pair, conventions);
  } catch (const UserError& error) {
    return Lost{Lost::How::malformed, error.what()};
  }
}

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
  BatchResult result;
  // What it wrote unasked belongs to no case: better begin anew.
  if (child_.running() && (!unread_.empty() || wait_readable(child_.from(), 0))) stop();
  if (!child_.running()) start();
  std::string lines;
  for (const PairCase& pair : pairs) {
    append_case_line(lines, pair);
    lines += '\n';
  }
  std::string_view unwritten = lines;
  Clock::time_point answered_at = Clock::now();
  while (result.answered < pairs.size() && result.end == BatchEnd::answered) {
    std::array<pollfd, 2> watched{{{child_.from(), POLLIN, 0}, {child_.to(), POLLOUT, 0}}};
    poll(watched.data(), unwritten.empty() ? 1 : 2, kPollMilliseconds);
    if (!unwritten.empty() && watched[1].revents != 0) write_some(unwritten);
    const std::size_t before = result.answered;
    const bool open = watched[0].revents == 0 || read_some();
    take_lines(pairs, answers, result);
    if (result.answered > before) answered_at = Clock::now();
    if (result.answered == pairs.size() || result.end != BatchEnd::answered) break;
    const double most = has_answered_ ? limits.case_seconds : limits.start_seconds;
    if (!open) {
      result.end = BatchEnd::exited;
    } else if (!go_on()) {
      result.end = BatchEnd::stopped;
    } else if (seconds_since(answered_at) > most) {
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
  unread_.clear();
  has_answered_ = false;
  return child_.stop();
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

void ProgramProcess::write_some(std::string_view& text) {
  const ssize_t written = write(child_.to(), text.data(), text.size());
  if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  if (written < 0 && errno == EPIPE) text = {};  // its answers will end too
}

/// False at the end of its output.
bool ProgramProcess::read_some() {
  std::array<char, 1 << 16> buffer;
  const ssize_t count = read(child_.from(), buffer.data(), buffer.size());
  if (count > 0) unread_.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

bool ProgramProcess::is_next_line(std::string& line) {
  const std::size_t end = unread_.find('\n');
  if (end == std::string::npos) return false;
  line.assign(unread_, 0, end);
  unread_.erase(0, end + 1);
  return true;
}

void ProgramProcess::take_lines(std::span<const PairCase> pairs, std::span<Answer> answers,
                                BatchResult& result) {
  std::string line;
  while (result.answered < pairs.size() && is_next_line(line)) {
    if (is_blank(line)) continue;
    try {
      if (line.size() > kLongestCase) throw UserError("longer than 1 MiB");
      const JsonTree tree = parse_json(line);
      const JsonView view(tree);
      if (!has_answered_ && declaration_.empty() && view.is_object() && view.find("declaration")) {
        declaration_ = line;
        continue;
      }
      answers[result.answered] = answer_in(view, pairs[result.answered], conventions);
      ++result.answered;
      has_answered_ = true;
    } catch (const UserError& error) {
      if (line.starts_with('{')) {  // an answer still, if none that can be read
        answers[result.answered++] = Lost{Lost::How::malformed, error.what()};
        has_answered_ = true;
        continue;
      }
      result.end = BatchEnd::not_json;
      result.why = fmt::format("'{}': {}", printable(line), error.what());
      return;
    }
  }
  if (unread_.size() > kLongestCase) {
    result.end = BatchEnd::not_json;
    result.why = "a line longer than 1 MiB";
  }
}

}  // namespace manifuzz
