# The folders that make up the library: what others may use, and what is installed.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Headers include each other from src/, which is no name for others to find them by: they get
# copies, <manifuzz/geometry/vector.hpp> and so on, written when CMake runs.
set(manifuzz_include ${PROJECT_BINARY_DIR}/include)

# clang counts -Wsign-conversion to -Wconversion; indices are ints here, which need not worry others.
set(manifuzz_quiet [[
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wsign-conversion"
#endif
]])
set(manifuzz_as_before [[

#ifdef __clang__
#pragma clang diagnostic pop
#endif
]])

# manifuzz_public_header(header): the copy of a header of this folder.
function(manifuzz_public_header header)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/src ${CMAKE_CURRENT_SOURCE_DIR})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  file(READ ${header} text)
  string(REGEX REPLACE "#include \"([a-z]+/)" "#include \"manifuzz/\\1" text "${text}")
  string(REPLACE "#pragma once\n" "#pragma once\n${manifuzz_quiet}" text "${text}${manifuzz_as_before}")
  file(CONFIGURE OUTPUT ${manifuzz_include}/manifuzz/${folder}/${header} CONTENT "${text}" @ONLY)
endfunction()

# What their sources include of Eigen and of C++, parsed once a build.
if(MANIFUZZ_HARNESS)
  add_library(manifuzz_headers_of_library OBJECT base/common_headers.cpp)
  set_target_properties(manifuzz_headers_of_library PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
  target_link_libraries(manifuzz_headers_of_library PRIVATE manifuzz_options Eigen3::Eigen)
  target_precompile_headers(manifuzz_headers_of_library PRIVATE
    <algorithm> <array> <optional> <span> <vector> <Eigen/Core>)
endif()

# manifuzz_public_library(name HEADERS file... [SOURCES file...] LINKS target...): a folder of the
# library, manifuzz::name to others. HEADERS are the public ones, and those that they include.
function(manifuzz_public_library name)
  cmake_parse_arguments(PARSE_ARGV 1 LIB "" "" "HEADERS;SOURCES;LINKS")
  set(target manifuzz_${name})
  if(LIB_SOURCES)
    set(kind STATIC)
    set(scope PUBLIC)
  else()
    set(kind INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(${target} ${kind} ${LIB_SOURCES})
  add_library(manifuzz::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  foreach(header IN LISTS LIB_HEADERS)
    manifuzz_public_header(${header})
  endforeach()
  list(TRANSFORM LIB_HEADERS PREPEND ${manifuzz_include}/manifuzz/${name}/)
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${manifuzz_include} FILES ${LIB_HEADERS})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_link_libraries(${target} ${scope} ${LIB_LINKS})
  if(LIB_SOURCES)
    # Whoever uses it may be a shared library, whose own symbols these are not.
    set_target_properties(${target} PROPERTIES
      POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
    # Fast code is compiled alone: what it is compiled together with changes what is inlined.
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:manifuzz_options>)
    if(MANIFUZZ_HARNESS)
      target_precompile_headers(${target} REUSE_FROM manifuzz_headers_of_library)
    endif()
  endif()
endfunction()

# manifuzz_use_highway(target [BUT instruction_set...]): vector code of its own. Highway 1.0.3 does not
# compile where the compiler may use all that AVX3_DL has, as with -march=native on newer processors: it
# forgets that target among those to dispatch to. Nothing here gains by it, nor by SSSE3 over SSE2, and
# each target is the vector code compiled once more.
function(manifuzz_use_highway target)
  cmake_parse_arguments(PARSE_ARGV 1 HIGHWAY "" "" "BUT")
  list(TRANSFORM HIGHWAY_BUT PREPEND HWY_)
  list(JOIN HIGHWAY_BUT "|" but)
  target_compile_definitions(${target} PRIVATE
    "HWY_DISABLED_TARGETS=(HWY_AVX3_DL|HWY_SSSE3$<$<BOOL:${but}>:|${but}>)")
  target_link_libraries(${target} PRIVATE hwy::hwy)
endfunction()

# manifuzz_lay_out_by_hand(source...): g++ 12 must vectorise nothing in these, for it fuses what it does
# (vfmaddsub) in spite of -ffp-contract=off. Precompiled headers would undo that: where highway.h ends
# a target, g++ goes back to the options that those were compiled with.
function(manifuzz_lay_out_by_hand)
  set_source_files_properties(${ARGV} PROPERTIES
    COMPILE_OPTIONS -fno-tree-vectorize SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# manifuzz_pkg_config(name): what pkg-config says of a folder of the library, manifuzz-name, wherever the
# installation was moved.
function(manifuzz_pkg_config name)
  set(target manifuzz_${name})
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH to_prefix /${folder} /)
  string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
  get_target_property(links ${target} INTERFACE_LINK_LIBRARIES)
  list(FILTER links INCLUDE REGEX "^(manifuzz_|Eigen3::Eigen$)")
  list(TRANSFORM links REPLACE "^manifuzz_" "manifuzz-")
  list(TRANSFORM links REPLACE "^Eigen3::Eigen$" "eigen3")
  list(JOIN links ", " requires)
  get_target_property(kind ${target} TYPE)
  set(libs "")
  if(kind STREQUAL "STATIC_LIBRARY")
    set(libs "Libs: -L\${libdir} -l${target}\n")
    # A static library: whoever links it links Highway.
    string(APPEND requires ", libhwy")
  endif()
  set(options "")
  if(name STREQUAL "geometry")
    set(options " -ffp-contract=off")
  endif()
  set(file ${PROJECT_BINARY_DIR}/pkgconfig/manifuzz-${name}.pc)
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT
"prefix=\${pcfiledir}/${to_prefix}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: manifuzz-${name}
Description: ${PROJECT_DESCRIPTION}; its part ${name}
Version: ${PROJECT_VERSION}
Requires: ${requires}
${libs}Cflags: -I\${includedir}${options}
")
  install(FILES ${file} DESTINATION ${folder} COMPONENT library)
endfunction()

# manifuzz_install(name...): these libraries, their headers, the CMake package and a file for pkg-config
# each, as the component library; the licence is a component of its own, since packages have it elsewhere.
function(manifuzz_install)
  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/manifuzz)
  list(TRANSFORM ARGV PREPEND manifuzz_ OUTPUT_VARIABLE targets)
  install(TARGETS ${targets} EXPORT manifuzzTargets
    ARCHIVE COMPONENT library
    FILE_SET HEADERS COMPONENT library
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT manifuzzTargets NAMESPACE manifuzz:: DESTINATION ${package} COMPONENT library)
  write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/manifuzzConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES manifuzzConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/manifuzzConfigVersion.cmake
    DESTINATION ${package} COMPONENT library)
  foreach(name IN LISTS ARGV)
    manifuzz_pkg_config(${name})
  endforeach()
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
endfunction()
