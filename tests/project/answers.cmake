# What students write into the gaps, run and judged as ./course exercise does.
add_executable(exercise_answers exercise_answers.cpp)
target_link_libraries(exercise_answers PRIVATE exercise_commands)
target_compile_definitions(exercise_answers PRIVATE SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_script("exercises in a folder of one's own" own_exercises.sh ${PROJECT_BINARY_DIR})
file(GLOB answers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/tests
  ${PROJECT_SOURCE_DIR}/tests/*/exercise/answers.txt ${PROJECT_SOURCE_DIR}/tests/*/exercise/transfer.txt)
foreach(file IN LISTS answers)
  string(REGEX REPLACE "/.*" "" exercise ${file})
  if(file MATCHES "transfer\\.txt")
    string(APPEND exercise _transfer)
  endif()
  add_test(NAME "exercise ${exercise}: what students write" COMMAND exercise_answers ${exercise})
endforeach()
