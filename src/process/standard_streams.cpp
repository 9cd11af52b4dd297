#include "process/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace manifuzz {

void fill_in_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    // The lowest number that is free is this stream's, since those below are there.
    open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace manifuzz
