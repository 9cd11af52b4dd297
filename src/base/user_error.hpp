#pragma once

#include <stdexcept>

namespace manifuzz {

/// What a person can put right: bad usage, bad input, a file that cannot be read or written. The
/// text is one printable line: where, what, and what would be right. A command that meets it ends
/// with status 2.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace manifuzz
