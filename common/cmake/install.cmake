# cmake --install installs everything or single components:
#   simulation   headers, and the libraries for a world and the recommended solver: pushback_simulation and engine
#   chapters     the same and the libraries of chapters
#   experiment   the same as simulation and the library for pictures, sheets and plots: pushback
#   exercises    for a student's own folder: the program pushback-exercise, and the headers and libraries with which it compiles and
#                links answers; see tools/classroom/kit.cmake
# The first three are the COMPONENTS of find_package(Pushback).
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/pushback)
set(simulation_targets pushback_settings pushback_simulation engine)
get_property(chapters_targets GLOBAL PROPERTY chapter_libraries)
list(APPEND chapters_targets flat_solver thread_pool)
set(experiment_targets pushback_render pushback_program pushback choosing)
set(components simulation)
if(PUSHBACK_PICTURES)
  list(APPEND components chapters experiment)
endif()

foreach(component IN LISTS components)
  install(TARGETS ${${component}_targets} EXPORT pushback-${component} COMPONENT ${component})
  install(EXPORT pushback-${component} NAMESPACE pushback:: DESTINATION ${package} COMPONENT ${component})
  if(NOT component STREQUAL "simulation")  # an export belongs to one component, so the others install simulation first
    install(CODE [[if(CMAKE_INSTALL_COMPONENT)
      execute_process(COMMAND ${CMAKE_COMMAND} --install "${CMAKE_CURRENT_LIST_DIR}" --prefix "${CMAKE_INSTALL_PREFIX}"
        --component simulation COMMAND_ERROR_IS_FATAL ANY)
    endif()]] COMPONENT ${component})
  endif()
endforeach()
install(DIRECTORY common engine chapters DESTINATION include/pushback COMPONENT simulation FILES_MATCHING PATTERN "*.h" PATTERN exercise EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/package/pushback-config.cmake ${PROJECT_BINARY_DIR}/package/pushback-config-version.cmake
  DESTINATION ${package} COMPONENT simulation)

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/pushback-config.cmake.in @ONLY CONTENT [[
include(CMakeFindDependencyMacro)
set(wanted ${${CMAKE_FIND_PACKAGE_NAME}_FIND_COMPONENTS})
if(NOT wanted)  # all that is installed
  foreach(component chapters experiment)
    if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/pushback-${component}.cmake)
      list(APPEND wanted ${component})
    endif()
  endforeach()
endif()
find_dependency(Eigen3 NO_MODULE)
find_dependency(fmt)
include(${CMAKE_CURRENT_LIST_DIR}/pushback-simulation.cmake)
set(${CMAKE_FIND_PACKAGE_NAME}_simulation_FOUND TRUE)
if("chapters" IN_LIST wanted AND EXISTS ${CMAKE_CURRENT_LIST_DIR}/pushback-chapters.cmake)
  find_dependency(Threads)
  include(${CMAKE_CURRENT_LIST_DIR}/pushback-chapters.cmake)
  set(${CMAKE_FIND_PACKAGE_NAME}_chapters_FOUND TRUE)
endif()
if("experiment" IN_LIST wanted AND EXISTS ${CMAKE_CURRENT_LIST_DIR}/pushback-experiment.cmake)
  find_dependency(CLI11)
  find_dependency(PkgConfig)
  pkg_check_modules(PANGO REQUIRED IMPORTED_TARGET pangocairo pangoft2)
  if("@PUSHBACK_GL_FOUND@" STREQUAL "EGL")
    find_dependency(OpenGL COMPONENTS OpenGL EGL)
  endif()
  include(${CMAKE_CURRENT_LIST_DIR}/pushback-experiment.cmake)
  set(${CMAKE_FIND_PACKAGE_NAME}_experiment_FOUND TRUE)
endif()
foreach(component IN LISTS wanted)
  if(${CMAKE_FIND_PACKAGE_NAME}_FIND_REQUIRED_${component} AND NOT ${CMAKE_FIND_PACKAGE_NAME}_${component}_FOUND)
    set(${CMAKE_FIND_PACKAGE_NAME}_FOUND FALSE)
    set(${CMAKE_FIND_PACKAGE_NAME}_NOT_FOUND_MESSAGE "its component ${component} is not installed: cmake --install BUILD --component ${component}")
  endif()
endforeach()
]])
configure_file(${PROJECT_BINARY_DIR}/pushback-config.cmake.in ${PROJECT_BINARY_DIR}/package/pushback-config.cmake COPYONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/pushback-config-version.cmake COMPATIBILITY SameMinorVersion)
