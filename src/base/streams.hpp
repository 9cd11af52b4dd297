#pragma once

#include <string>
#include <string_view>

namespace manifuzz {

/// Writes to the standard error as far as it goes: one that is closed or full stops nothing.
void write_error(std::string_view text);

/// Thrown where nobody reads the output any more: the command ends, quietly.
struct OutputClosed {};

/// The standard output, buffered. Throws UserError where it cannot be written (a full disk), and
/// OutputClosed where its reader is gone. What is not flushed is lost.
class Output {
 public:
  void write(std::string_view text);
  void flush();

 private:
  std::string buffer_;
};

/// Writes all of it to the standard output, as `Output` does.
void write_output(std::string_view text);

/// The same, but a reader that is gone stops nothing: what a command says is in its status too.
void write_to_reader(std::string_view text);

/// Writes to the file of that name, or to the standard output for "-".
void write_data(const std::string& file, std::string_view text);

}  // namespace manifuzz
