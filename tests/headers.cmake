# Tests that drive what libraries and programs have compiled, or that run for a moment: at -O1 they compile in two thirds of the
# time. Not among them: tests that assert bits, which are those of the programs' own level, and tests that run for long.
set(brief 00_naive_impulses 01_velocity_constraint 02_clamping 03_baumgarte 04_slop 05_restitution 06_friction 09_impacts 10_position_correction
    13_joints 14_joints_under_load 15_limits_motors_springs bodies broad_phase collision command_line exercise_command exercise_runs exercises
    frozen grading hard_cases hard_cases_table hulls images kept_picture laws links own_tasks page_exercises pages parameters problem_export
    quantile render scenes student study)
list(TRANSFORM brief PREPEND test_)
targets_below(tests tests)
list(REMOVE_ITEM tests ${brief})
foreach(headers headers_of_tests headers_of_brief_tests)
  parse_once(${headers} ${CMAKE_CURRENT_SOURCE_DIR}/support/catch.h <pushback/chapters/01_velocity_constraint/solver.h>
    <pushback/common/world/measure.h> <pushback/common/world/situations.h>)  # ours, which nearly all include
  target_link_libraries(${headers} PRIVATE Catch2::Catch2)
endforeach()
foreach(target IN LISTS brief ITEMS headers_of_brief_tests)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endforeach()
reuse_headers(headers_of_tests ${tests})
reuse_headers(headers_of_brief_tests ${brief})
