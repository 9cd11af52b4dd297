# CMake's toolchain for another machine than this one: the clang that comes with MANIFUZZ_ZIG, for
# MANIFUZZ_TARGET (aarch64-linux-musl, wasm32-wasi, ...). Programs are linked statically.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MANIFUZZ_ZIG MANIFUZZ_TARGET)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

string(REGEX MATCH "^[a-z0-9_]+" CMAKE_SYSTEM_PROCESSOR ${MANIFUZZ_TARGET})
set(CMAKE_CXX_COMPILER ${MANIFUZZ_ZIG} c++ -target ${MANIFUZZ_TARGET})
set(CMAKE_AR ${MANIFUZZ_ZIG})
set(CMAKE_CXX_ARCHIVE_CREATE "<CMAKE_AR> ar qc <TARGET> <LINK_FLAGS> <OBJECTS>")
set(CMAKE_CXX_ARCHIVE_FINISH "<CMAKE_AR> ranlib <TARGET>")

if(MANIFUZZ_TARGET MATCHES wasi)
  set(CMAKE_SYSTEM_NAME Generic)
  # WebAssembly's C++ library has no exceptions: code that throws compiles, and would end there.
  set(CMAKE_CXX_FLAGS_INIT "-fexceptions -Xclang -fignore-exceptions")
  set(CMAKE_EXECUTABLE_SUFFIX .wasm)
else()
  set(CMAKE_SYSTEM_NAME Linux)
endif()
