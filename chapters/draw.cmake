# add_drawing(NAME): adds the target draw_NAME, which is not built by default. If the program NAME has changed since its last run, the
# target runs it to fill renders/NAME. The time stamp of drawn/NAME records that run.
function(add_drawing name)
  set(drawn ${PROJECT_BINARY_DIR}/drawn/${name})
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/drawn)
  add_custom_command(OUTPUT ${drawn} COMMAND ${name} > /dev/null COMMAND ${CMAKE_COMMAND} -E touch ${drawn} DEPENDS ${name}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Drawing renders/${name}/sheet.png")
  add_custom_target(draw_${name} DEPENDS ${drawn})
endfunction()
