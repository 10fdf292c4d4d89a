# Headers of others, parsed once.
#
# Eigen, fmt and the standard library are half of what a small file takes to compile. None of our headers is among them: a
# change of ours parses nothing of this again. ccache has no hits with such headers unless it is told not to mind macros.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache$")
  set(with_headers ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CMAKE_CXX_COMPILER_LAUNCHER})
else()
  set(with_headers ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()
function(parse_once name)  # parse_once(NAME HEADER...): an object library of that name, whose headers others may reuse
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE pushback_settings)
  target_precompile_headers(${name} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <filesystem> <fmt/format.h> <fmt/ranges.h>
    <functional> <map> <memory> <optional> <set> <sstream> <string> <variant> <vector> ${ARGN})
  set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "${with_headers}")
endfunction()
function(reuse_headers name)  # reuse_headers(NAME TARGET...): for those that are compiled
  foreach(target IN LISTS ARGN)
    get_target_property(type ${target} TYPE)
    get_target_property(apart ${target} DISABLE_PRECOMPILE_HEADERS)
    if(type MATCHES "EXECUTABLE|STATIC_LIBRARY" AND NOT apart)
      target_precompile_headers(${target} REUSE_FROM ${name})
      # g++ 12 takes strings of the standard library for ours here, and warns of what they do: the sanitizers watch arrays.
      target_compile_options(${target} PRIVATE
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overread;-Wno-stringop-overflow>")
      set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${with_headers}")
    endif()
  endforeach()
endfunction()
