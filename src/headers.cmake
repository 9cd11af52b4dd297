# Headers of other projects that most sources include, parsed once a build.

set(manifuzz_common_packages Eigen3::Eigen fmt::fmt Boost::headers PkgConfig::GMP nlohmann_json::nlohmann_json)

# manifuzz_precompile(name header...): precompiles them, as a target whose headers others take.
function(manifuzz_precompile name)
  add_library(manifuzz_${name} OBJECT ${PROJECT_SOURCE_DIR}/src/base/common_headers.cpp)
  target_link_libraries(manifuzz_${name} PRIVATE manifuzz_options ${manifuzz_common_packages})
  target_compile_options(manifuzz_${name} PRIVATE -pthread)
  target_precompile_headers(manifuzz_${name} PRIVATE ${ARGN})
endfunction()

# manifuzz_take_headers(target name): takes them for every source of a target, which must be
# optimised as much: g++ 12 ends by a fault else.
function(manifuzz_take_headers target name)
  target_precompile_headers(${target} REUSE_FROM manifuzz_${name})
  # They are valid only where the macros that they look at are the same: librsvg's flags have
  # -pthread, which defines one.
  target_compile_options(${target} PRIVATE -pthread)
  foreach(package fmt::fmt Boost::headers)
    target_compile_definitions(${target} PRIVATE
      $<TARGET_PROPERTY:${package},INTERFACE_COMPILE_DEFINITIONS>)
  endforeach()
  target_include_directories(${target} SYSTEM PRIVATE
    $<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()
