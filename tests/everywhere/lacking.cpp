// What libraries name and a target lacks. Programs here never get there: it ends them.

#include <cstddef>
#include <cstdlib>

#ifdef __wasm__

// WebAssembly's C++ library has no exceptions.
extern "C" void* __cxa_allocate_exception(std::size_t) {
  std::abort();
}
extern "C" void __cxa_throw(void*, void*, void (*)(void*)) {
  std::abort();
}

#elif defined(__linux__) && !defined(__GLIBC__)

// Rust has no library for musl on some processors: the one for glibc opens files by these when a
// program panics.
#define MANIFUZZ_LACKING(name) \
  extern "C" void name() {     \
    std::abort();              \
  }
MANIFUZZ_LACKING(open64)
MANIFUZZ_LACKING(fstat64)
MANIFUZZ_LACKING(lseek64)
MANIFUZZ_LACKING(stat64)
MANIFUZZ_LACKING(mmap64)

#endif
