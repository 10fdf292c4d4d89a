# Tests run briefly, and mostly call code compiled in libraries and programs, so they are compiled briefly. The exceptions compare bits
# with code compiled elsewhere or with stored bits, at the optimization level of the programs, or run for long.
set(as_programs 20_only_what_is_needed 21_detected_once 22_wide 23_threads 25_moment_of_impact determinism flat hard_cases_played hashes
    soak)
list(TRANSFORM as_programs PREPEND test_)
targets_below(tests tests)
set(brief ${tests})
list(FILTER brief INCLUDE REGEX "^test_")
list(REMOVE_ITEM brief ${as_programs})
compile_briefly(${brief})
parse_once(tests ${CMAKE_CURRENT_SOURCE_DIR}/support/catch.h <pushback/chapters/01_velocity_constraint/solver.h>
  <pushback/common/world/measure.h> <pushback/common/world/situations.h>)  # our headers that nearly all include
foreach(headers headers_of_tests headers_of_brief_tests)
  target_link_libraries(${headers} PRIVATE Catch2::Catch2)
endforeach()
reuse_headers(tests ${tests})
