# Precompiled headers of other projects.
#
# Eigen, fmt and the standard library take half of a small file's compile time. The list below contains none of our headers, so a
# change in ours does not parse it again. ccache has no hits with such headers unless CCACHE_SLOPPINESS makes it ignore macros.
# Headers that HEADER adds may be ours. If only a comment in one of them changes, ccache without CCACHE_DEPEND returns the headers
# as they were parsed before the change. g++ then does not recognise the changed file, and includes it again in spite of
# `#pragma once`.
set(with_headers ${CMAKE_CXX_COMPILER_LAUNCHER})
set(of_headers ${CMAKE_CXX_COMPILER_LAUNCHER})
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache$")
  list(PREPEND with_headers ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros)
  list(PREPEND of_headers ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1)
endif()
# g++ optimizes like the precompiled headers, whatever -O is given, so targets of compile_briefly have their own headers.
function(parse_once whose)  # parse_once(WHOSE HEADER...): makes the object libraries headers_of_WHOSE and headers_of_brief_WHOSE
  foreach(name headers_of_${whose} headers_of_brief_${whose})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE pushback_settings)
    target_precompile_headers(${name} PRIVATE <Eigen/Geometry> <algorithm> <cmath> <filesystem> <fmt/format.h> <fmt/ranges.h>
      <functional> <map> <memory> <optional> <set> <sstream> <string> <variant> <vector> ${ARGN})
    set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "${of_headers}")
  endforeach()
  compile_briefly(headers_of_brief_${whose})
endfunction()
function(reuse_headers whose)  # reuse_headers(WHOSE TARGET...): for those targets that compile sources
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
      # g++ 12 takes strings of the standard library for our code here and warns about them. The sanitizers check arrays instead.
      target_compile_options(${target} PRIVATE
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overread;-Wno-stringop-overflow>")
      set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${with_headers}")
    endif()
  endforeach()
endfunction()
