# What every target is built with.
add_library(pushback_settings INTERFACE)
target_compile_features(pushback_settings INTERFACE cxx_std_20)
target_link_libraries(pushback_settings INTERFACE Eigen3::Eigen fmt::fmt)
# Headers are included as "pushback/common/...": another project may have a common/ of its own.
set(headers ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${headers})
file(CREATE_LINK ${PROJECT_SOURCE_DIR} ${headers}/pushback SYMBOLIC)
# The directory is the system's for other projects: their warnings are for their own code.
if(PROJECT_IS_TOP_LEVEL)
  target_include_directories(pushback_settings INTERFACE $<BUILD_INTERFACE:${headers}> $<INSTALL_INTERFACE:include>)
  set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wsuggest-override $<$<BOOL:${PUSHBACK_WERROR}>:-Werror>)
  target_compile_options(pushback_settings INTERFACE $<BUILD_INTERFACE:${warnings}>)
  # g++ looks for memory that it needs no longer whenever it has taken somewhat more: a tenth of its time. Below 1 GB it need not.
  target_compile_options(pushback_settings INTERFACE $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>>)
else()
  target_include_directories(pushback_settings SYSTEM INTERFACE ${headers})
  add_compile_options(-w)
endif()
# No fused multiply-add: the same source gives the same bits whatever the compiler would like to contract. Solvers are
# templates, compiled where they are used; so this option goes with the headers into the targets of another project.
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

# For a source file with many solvers: g++ stops inlining once that has made a file 40 % longer, and a sweep that is not
# inlined takes twice the time.
add_library(many_solvers INTERFACE)
target_compile_options(many_solvers INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=200>)

# What runs for a moment and is not timed: at -O1 it compiles in three quarters of the time.
function(compile_briefly)  # compile_briefly(TARGET...)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    set_target_properties(${target} PROPERTIES BRIEF ON)
  endforeach()
endfunction()

# Several files as one, where none is likely to be edited: who works on the libraries may want PUSHBACK_TOGETHER=OFF. The
# sanitizers' build and clang-tidy look at each file alone, so a header that is missing is found there.
function(compile_together)  # compile_together(TARGET...)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ${PUSHBACK_TOGETHER} UNITY_BUILD_BATCH_SIZE 7)
endfunction()
