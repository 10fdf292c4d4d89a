# add_drawing(NAME): the target draw_NAME, which is built only where somebody asks for it, runs the program NAME, which fills
# renders/NAME, where it has changed since it last did. The file drawn/NAME says when that was.
function(add_drawing name)
  set(drawn ${PROJECT_BINARY_DIR}/drawn/${name})
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/drawn)
  add_custom_command(OUTPUT ${drawn} COMMAND ${name} > /dev/null COMMAND ${CMAKE_COMMAND} -E touch ${drawn} DEPENDS ${name}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Drawing renders/${name}/sheet.png")
  add_custom_target(draw_${name} DEPENDS ${drawn})
endfunction()
