#include "oracle/external/conversation.hpp"

#include <array>
#include <cerrno>
#include <poll.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json_tree.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "exchange/json.hpp"

namespace manifuzz {
namespace {

constexpr int kPollMilliseconds = 50;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Answer converted(Answer answer, const Dialect& dialect) {
  if (auto* const given = std::get_if<PartialManifold>(&answer)) {
    given->has_midpoints = dialect.has_midpoints;
    if (dialect.normal_from_b) given->manifold.normal = -given->manifold.normal;
    order_points(given->manifold);
  }
  return answer;
}

/// An answer that is JSON but no manifold loses its case alone.
Answer answer_in(const JsonTree& tree, const PairCase& pair, const Dialect& dialect) {
  try {
    return converted(read_outside_answer(JsonView(tree), pair), dialect);
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

Conversation::Talk Conversation::ask(std::span<const PairCase> pairs, std::span<Answer> answers,
                                     const Dialect& dialect, const Patience& patience,
                                     const std::function<bool()>& go_on) {
  Talk talk;
  // What it said unasked belongs to no case: better begin anew.
  if (child_.running() && (!unread_.empty() || wait_readable(child_.from(), 0))) stop();
  if (!child_.running()) start();
  std::string lines;
  for (const PairCase& pair : pairs) {
    append_case_line(lines, pair);
    lines += '\n';
  }
  std::string_view unwritten = lines;
  Clock::time_point answered_at = Clock::now();
  while (talk.answered < pairs.size() && talk.end == End::done) {
    std::array<pollfd, 2> watched{{{child_.from(), POLLIN, 0}, {child_.to(), POLLOUT, 0}}};
    poll(watched.data(), unwritten.empty() ? 1 : 2, kPollMilliseconds);
    if (!unwritten.empty() && watched[1].revents != 0) write_some(unwritten);
    const std::size_t before = talk.answered;
    const bool open = watched[0].revents == 0 || read_some();
    take_lines(pairs, answers, dialect, talk);
    if (talk.answered > before) answered_at = Clock::now();
    if (talk.answered == pairs.size() || talk.end != End::done) break;
    const double most = has_answered_ ? patience.case_seconds : patience.start_seconds;
    if (!open) {
      talk.end = End::died;
    } else if (!go_on()) {
      talk.end = End::stopped;
    } else if (seconds_since(answered_at) > most) {
      talk.end = End::silent;
      talk.why = fmt::format("no answer in {} s; is every line flushed?", most);
    }
  }
  if (talk.end == End::done && !unread_.empty()) {
    talk.end = End::extra_lines;
    talk.why = "more answers than cases";
  }
  return talk;
}

bool Conversation::says_more(double seconds) {
  return child_.running() && wait_readable(child_.from(), seconds) && read_some();
}

std::string Conversation::stop() {
  unread_.clear();
  has_answered_ = false;
  return child_.stop();
}

void Conversation::start() {
  stop();
  declared_.clear();
  child_.start([&](int in, int out) {
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    const std::string line = is_simple(command_) ? "exec " + command_ : command_;
    execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  });
}

void Conversation::write_some(std::string_view& text) {
  const ssize_t written = write(child_.to(), text.data(), text.size());
  if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  if (written < 0 && errno == EPIPE) text = {};  // its answers will end too
}

/// False at the end of its output.
bool Conversation::read_some() {
  std::array<char, 1 << 16> buffer;
  const ssize_t count = read(child_.from(), buffer.data(), buffer.size());
  if (count > 0) unread_.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

bool Conversation::is_next_line(std::string& line) {
  const std::size_t end = unread_.find('\n');
  if (end == std::string::npos) return false;
  line.assign(unread_, 0, end);
  unread_.erase(0, end + 1);
  return true;
}

void Conversation::take_lines(std::span<const PairCase> pairs, std::span<Answer> answers,
                              const Dialect& dialect, Talk& talk) {
  std::string line;
  while (talk.answered < pairs.size() && is_next_line(line)) {
    if (is_blank(line)) continue;
    try {
      if (line.size() > kLongestCase) throw UserError("longer than 1 MiB");
      const JsonTree tree = parse_json(line);
      if (!has_answered_ && declared_.empty() && tree.find(0, "declaration")) {
        declared_ = line;
        continue;
      }
      answers[talk.answered] = answer_in(tree, pairs[talk.answered], dialect);
      ++talk.answered;
      has_answered_ = true;
    } catch (const UserError& error) {
      if (line.starts_with('{')) {  // an answer still, if none that can be read
        answers[talk.answered++] = Lost{Lost::How::malformed, error.what()};
        has_answered_ = true;
        continue;
      }
      talk.end = End::not_json;
      talk.why = fmt::format("'{}': {}", printable(line), error.what());
      return;
    }
  }
  if (unread_.size() > kLongestCase) {
    talk.end = End::not_json;
    talk.why = "a line longer than 1 MiB";
  }
}

}  // namespace manifuzz
