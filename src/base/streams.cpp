#include "base/streams.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

#include "base/file.hpp"
#include "base/user_error.hpp"

namespace manifuzz {

void write_error(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void Output::write(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  buffer_ += text;
  if (buffer_.size() >= enough) flush();
}

void Output::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) throw OutputClosed();
    if (written < 0)
      throw UserError(std::string("stdout: cannot write it: ") + std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void write_output(std::string_view text) {
  Output out;
  out.write(text);
  out.flush();
}

void write_to_reader(std::string_view text) {
  try {
    write_output(text);
  } catch (const OutputClosed&) {
  }
}

void write_data(const std::string& file, std::string_view text) {
  file == "-" ? write_to_reader(text) : write_file(file, text);
}

}  // namespace manifuzz
