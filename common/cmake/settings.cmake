# The settings of all targets.
add_library(pushback_settings INTERFACE)
target_compile_features(pushback_settings INTERFACE cxx_std_20)
target_link_libraries(pushback_settings INTERFACE Eigen3::Eigen fmt::fmt)
# Headers are included as "pushback/common/...", because another project may have its own common/.
set(headers ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${headers})
file(CREATE_LINK ${PROJECT_SOURCE_DIR} ${headers}/pushback SYMBOLIC)
# Other projects include the directory as a system directory, so that their warnings are only for their own code.
if(PROJECT_IS_TOP_LEVEL)
  target_include_directories(pushback_settings INTERFACE $<BUILD_INTERFACE:${headers}> $<INSTALL_INTERFACE:include>)
  set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wsuggest-override $<$<BOOL:${PUSHBACK_WERROR}>:-Werror>)
  target_compile_options(pushback_settings INTERFACE $<BUILD_INTERFACE:${warnings}>)
  # Of files compiled as one, clang++ says that a variable shadows one of another file. g++ and clang-tidy look for shadows.
  if(PUSHBACK_TOGETHER AND CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(pushback_settings INTERFACE $<BUILD_INTERFACE:-Wno-shadow>)
  endif()
  # g++'s garbage collection takes a tenth of its time, and is unnecessary below 1 GB.
  target_compile_options(pushback_settings INTERFACE $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>>)
else()
  target_include_directories(pushback_settings SYSTEM INTERFACE ${headers})
  add_compile_options(-w)
endif()
# No fused multiply-add, so that the same source gives the same bits whatever a compiler would contract. Solvers are templates and
# are compiled in the targets that use them, so this option goes with the headers into the targets of another project.
target_compile_options(pushback_settings INTERFACE -ffp-contract=off)
if(PUSHBACK_REAL STREQUAL "float")
  target_compile_definitions(pushback_settings INTERFACE PUSHBACK_FLOAT)
elseif(NOT PUSHBACK_REAL STREQUAL "double")
  message(FATAL_ERROR "PUSHBACK_REAL is '${PUSHBACK_REAL}': double or float is needed")
endif()
if(PUSHBACK_SANITIZE)
  target_compile_options(pushback_settings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(pushback_settings INTERFACE -fsanitize=address,undefined)
endif()

# For a source file with many solvers. g++ stops inlining once that has made a file 40 % longer, and a sweep that is not inlined
# takes twice as long.
add_library(many_solvers INTERFACE)
target_compile_options(many_solvers INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=200>)

# For code that runs briefly and is not timed. At -O1 it compiles in three quarters of the time.
function(compile_briefly)  # compile_briefly(TARGET...)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    set_target_properties(${target} PROPERTIES BRIEF ON)
  endforeach()
endfunction()

# Compiles several files as one, if they are unlikely to be edited. If you work on the libraries, you may want PUSHBACK_TOGETHER=OFF.
# clang-tidy and the check of definitions compile each file separately, so they find missing headers.
function(compile_together)  # compile_together(TARGET...)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ${PUSHBACK_TOGETHER} UNITY_BUILD_BATCH_SIZE 7)
endfunction()
