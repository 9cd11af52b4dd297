#include "process/shared_memory.hpp"

#include <new>
#include <sys/mman.h>

namespace manifuzz {

SharedMemory::SharedMemory(std::size_t bytes)
    : data_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
      bytes_(bytes) {
  if (data_ == MAP_FAILED) throw std::bad_alloc();
}

SharedMemory::~SharedMemory() {
  munmap(data_, bytes_);
}

}  // namespace manifuzz
