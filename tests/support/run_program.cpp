#include "support/run_program.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <pty.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace manifuzz::test {
namespace {

void check(bool done, const char* doing) {
  if (!done) throw std::system_error(errno, std::generic_category(), doing);
}

/// A file without a name, so that nobody has to read while the other writes.
class ScratchFile {
 public:
  ScratchFile() : descriptor_(memfd_create("scratch", MFD_CLOEXEC)) {
    check(descriptor_ >= 0, "memfd_create");
  }
  ~ScratchFile() { close(descriptor_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  int descriptor() const { return descriptor_; }

  void fill(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = write(descriptor_, text.data(), text.size());
      check(written >= 0, "write");
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    rewind();
  }

  std::string content() {
    rewind();
    std::string text;
    char chunk[4096];
    while (true) {
      const ssize_t count = read(descriptor_, chunk, sizeof chunk);
      check(count >= 0, "read");
      if (count == 0) return text;
      text.append(chunk, static_cast<std::size_t>(count));
    }
  }

 private:
  void rewind() { check(lseek(descriptor_, 0, SEEK_SET) == 0, "lseek"); }

  int descriptor_;
};

/// This environment without what a GitHub workflow sets: tests that run in one must not write to
/// its summary. `env` in front of a command sets what a test wants.
std::vector<char*> plain_environment() {
  std::vector<char*> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (!std::string_view(*variable).starts_with("GITHUB_")) variables.push_back(*variable);
  }
  variables.push_back(nullptr);
  return variables;
}

/// Starts a command (looked up in PATH unless it has a slash) on these descriptors.
pid_t start(const std::vector<std::string>& command, int in, int out, int err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::vector<char*> variables = plain_environment();
  pid_t child = 0;
  errno = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), variables.data());
  posix_spawn_file_actions_destroy(&actions);
  check(errno == 0, arguments[0]);
  return child;
}

/// Waits for a child: its exit status, or 128 + the signal that ended it.
int status_of(pid_t child) {
  int status = 0;
  check(waitpid(child, &status, 0) == child, "waitpid");
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Outcome run_program(const std::vector<std::string>& command, std::string_view input) {
  ScratchFile in;
  ScratchFile out;
  ScratchFile err;
  in.fill(input);
  const int status = status_of(start(command, in.descriptor(), out.descriptor(), err.descriptor()));
  return {status, out.content(), err.content()};
}

Outcome run_on_terminal(const std::vector<std::string>& command) {
  int screen = 0;
  int line = 0;
  check(openpty(&screen, &line, nullptr, nullptr, nullptr) == 0, "openpty");
  fcntl(screen, F_SETFD, FD_CLOEXEC);
  const pid_t child = start(command, line, line, line);
  close(line);
  Outcome outcome;
  char chunk[4096];
  // The read fails when the last program on the terminal has ended.
  for (ssize_t count = 0; (count = read(screen, chunk, sizeof chunk)) > 0;) {
    outcome.out.append(chunk, static_cast<std::size_t>(count));
  }
  close(screen);
  outcome.status = status_of(child);
  return outcome;
}

Outcome run_manifuzz(const std::vector<std::string>& arguments, std::string_view input) {
  return run_program(with({manifuzz_path()}, arguments), input);
}

std::string manifuzz_path() {
  return MANIFUZZ_PROGRAM;
}

std::vector<std::string> with(std::vector<std::string> command,
                              const std::vector<std::string>& more) {
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) throw std::invalid_argument("the last line has no end");
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

bool is_one_clear_line(std::string_view text) {
  if (text.size() < 2 || text.back() != '\n') return false;
  text.remove_suffix(1);
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace manifuzz::test
