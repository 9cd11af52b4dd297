#include "base/new_file.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace manifuzz {

bool make_new_file(const std::filesystem::path& path) {
  const int made = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (made < 0) return false;
  ::close(made);
  return true;
}

}  // namespace manifuzz
