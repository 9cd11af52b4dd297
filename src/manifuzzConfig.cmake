include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 CONFIG)
find_dependency(hwy CONFIG)
include(${CMAKE_CURRENT_LIST_DIR}/manifuzzTargets.cmake)
