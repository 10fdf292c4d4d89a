# Headers of others, parsed once.
#
# Eigen, fmt and the standard library are half of what a small file takes to compile. None of our headers is among them: a
# change of ours parses nothing of this again. ccache has no hits with such headers unless it is told not to mind macros.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache$")
  set(with_headers ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CMAKE_CXX_COMPILER_LAUNCHER})
else()
  set(with_headers ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()
# g++ optimizes as the headers were, whatever -O stands beside them: what is compiled briefly has headers of its own.
function(parse_once whose)  # parse_once(WHOSE HEADER...): object libraries, headers_of_WHOSE and headers_of_brief_WHOSE, to be reused
  foreach(name headers_of_${whose} headers_of_brief_${whose})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE pushback_settings)
    target_precompile_headers(${name} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <filesystem> <fmt/format.h> <fmt/ranges.h>
      <functional> <map> <memory> <optional> <set> <sstream> <string> <variant> <vector> ${ARGN})
    set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "${with_headers}")
  endforeach()
  compile_briefly(headers_of_brief_${whose})
endfunction()
function(reuse_headers whose)  # reuse_headers(WHOSE TARGET...): for those that are compiled
  foreach(target IN LISTS ARGN)
    get_target_property(type ${target} TYPE)
    get_target_property(apart ${target} DISABLE_PRECOMPILE_HEADERS)
    get_target_property(brief ${target} BRIEF)
    set(headers headers_of_${whose})
    if(brief)
      set(headers headers_of_brief_${whose})
    endif()
    if(type MATCHES "EXECUTABLE|STATIC_LIBRARY" AND NOT apart)
      target_precompile_headers(${target} REUSE_FROM ${headers})
      # g++ 12 takes strings of the standard library for ours here, and warns of what they do: the sanitizers watch arrays.
      target_compile_options(${target} PRIVATE
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overread;-Wno-stringop-overflow>")
      set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${with_headers}")
    endif()
  endforeach()
endfunction()
