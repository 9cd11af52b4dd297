# What `cpack` makes of a build of all: two packages for Debian, one of the program, one of the library.

include(GNUInstallDirs)

set(debian_files ${PROJECT_BINARY_DIR}/packages)

# The version's day, as its heading in CHANGELOG.md has it; results do not depend on the clock.
file(STRINGS ${PROJECT_SOURCE_DIR}/CHANGELOG.md released REGEX "^## \\[${PROJECT_VERSION}\\] - ")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" released "${released}")
if(NOT released)
  set(released 2026-11-27)  # a build between releases
endif()
execute_process(COMMAND date --utc --rfc-email --date=${released}
  OUTPUT_VARIABLE released_on OUTPUT_STRIP_TRAILING_WHITESPACE)

set(MANIFUZZ_CONTACT "The manifuzz authors <manifuzz@users.noreply.github.com>" CACHE STRING
  "Whom packages name as their maintainer, \"NAME <ADDRESS>\"")
set(CPACK_PACKAGE_CONTACT ${MANIFUZZ_CONTACT})
set(debian_copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nFiles: *\n")
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" unused "${license}")
string(APPEND debian_copyright "Copyright: ${CMAKE_MATCH_1}\nLicense: Expat\n")
string(REGEX REPLACE "^.*(Permission is hereby)" "\\1" license "${license}")
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n" "\n " license " ${license}")
string(STRIP "${license}" license)
file(CONFIGURE OUTPUT ${debian_files}/copyright CONTENT "${debian_copyright} ${license}\n" @ONLY)

# manifuzz_debian(component package): the files that every package of Debian's has.
function(manifuzz_debian component package)
  file(CONFIGURE OUTPUT ${debian_files}/${package}/changelog.Debian @ONLY CONTENT
"${package} (${PROJECT_VERSION}-1) unstable; urgency=medium

  * Version ${PROJECT_VERSION}; CHANGELOG.md of the sources has its changes.

 -- ${CPACK_PACKAGE_CONTACT}  ${released_on}
")
  execute_process(COMMAND gzip -9 -n -k -f ${debian_files}/${package}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${debian_files}/copyright ${debian_files}/${package}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component}_of_debian EXCLUDE_FROM_ALL)
endfunction()

manifuzz_debian(program manifuzz)
manifuzz_debian(library libmanifuzz-dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME manifuzz)
set(CPACK_PACKAGE_VENDOR manifuzz)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "contact points of 2D shapes by clipping, and a fuzzer of colliders")
set(CPACK_PACKAGE_DIRECTORY ${debian_files})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program program_of_debian library library_of_debian)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME manifuzz)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "It compares the contact manifolds that two colliders give for random pairs
of convex shapes, judges in exact arithmetic which of them is right, and
shrinks what is wrong to a small case. Box2D and Chipmunk are built in;
programs and shared libraries from outside are asked as well.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libmanifuzz-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libhwy-dev")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "A C++20 library for 2D collision: contact manifolds of convex shapes by
clipping, one pair at a time or many in the lanes of vector instructions,
and of whole scenes step by step. It gives the same bits on every machine.
Headers, static libraries, a CMake package and files for pkg-config.")

# What is packed need be built, nothing else; the target manifuzz_packages builds it, then packs.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
add_custom_target(manifuzz_packages COMMAND ${CMAKE_CPACK_COMMAND} USES_TERMINAL VERBATIM
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
add_dependencies(manifuzz_packages manifuzz manifuzz-measure manifuzz_pages
  manifuzz_geometry manifuzz_kernel manifuzz_afresh manifuzz_scene)

include(CPack)
cpack_add_component_group(program)
cpack_add_component_group(library)
foreach(component program library)
  cpack_add_component(${component} GROUP ${component} DESCRIPTION "${CPACK_COMPONENT_${component}_DESCRIPTION}")
  cpack_add_component(${component}_of_debian GROUP ${component})
endforeach()
