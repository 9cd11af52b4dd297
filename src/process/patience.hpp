#pragma once

#include <optional>
#include <sys/types.h>

#include "process/interruption.hpp"

namespace manifuzz {

/// How long a process has been at something, other work of the machine aside: what it spent waiting
/// for a processor does not count, so that a busy machine makes nobody late.
class Patience {
 public:
  /// From here on, with this process.
  void begin(pid_t process);
  /// Whether it has been at it longer than so many seconds; whatever the machine does, once ten
  /// times as many have passed.
  bool is_over(double seconds_max);

 private:
  pid_t process_ = 0;
  Clock::time_point began_at_{};
  /// Known from the first question on: most who begin are done before it.
  std::optional<double> waited_before_{};
};

/// How long all threads of a process have waited for a processor, in seconds; 0 where the system
/// does not say.
double seconds_waited(pid_t process);

}  // namespace manifuzz
