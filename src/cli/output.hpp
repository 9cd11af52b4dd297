#pragma once

#include <string>
#include <string_view>

namespace manifuzz {

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

}  // namespace manifuzz
