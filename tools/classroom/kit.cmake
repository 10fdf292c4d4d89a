# The headers and libraries with which a student's file is compiled and linked are prebuilt. The folder `kit` contains the precompiled
# headers and the command lines, which `exercise` reads.
set(kit ${PROJECT_BINARY_DIR}/exercise)
get_target_property(eigen_folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(TRANSFORM eigen_folders PREPEND -isystem)
set(answer_flags -std=c++20 -O1 -fPIC -ffp-contract=off -I${headers} ${eigen_folders} $<$<STREQUAL:${PUSHBACK_REAL},float>:-DPUSHBACK_FLOAT>
    $<$<BOOL:${PUSHBACK_SANITIZE}>:-fsanitize=address,undefined>)
set(parsed ${kit}/headers.h.gch)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(parsed ${kit}/headers.h.pch)
endif()
file(GENERATE OUTPUT ${kit}/headers.h CONTENT "#include \"pushback/chapters/01_velocity_constraint/any_effect.h\"
#include \"pushback/common/exercise/answer_program.h\"
")
file(GENERATE OUTPUT ${kit}/answer.cpp CONTENT "#include \"pushback/common/exercise/answer_program.h\"
pushback::Numbers pushback::students_numbers(std::size_t check, Random& random) { return play(check, random, student::answer); }
")
function(write_kit folder flags)  # write_kit(FOLDER FLAGS LIBRARY...): writes the command lines, one word per line
  list(JOIN ARGN "\n" libraries)
  file(GENERATE OUTPUT ${folder}/compile.txt CONTENT "${CMAKE_CXX_COMPILER}\n$<JOIN:$<FILTER:${flags},EXCLUDE,^$>,\n>\n")
  file(GENERATE OUTPUT ${folder}/link.txt CONTENT "${CMAKE_CXX_COMPILER}
$<$<BOOL:${PUSHBACK_SANITIZE}>:-fsanitize=address,undefined\n>-Wl,--gc-sections
${libraries}
$<TARGET_LINKER_FILE:fmt::fmt>
")
endfunction()
# The libraries that the checks include, directly or indirectly. The last chapter comes first and the engine after all chapters, because
# a linker reads each library once.
know_sources(common engine chapters)
list(TRANSFORM checks PREPEND tools/classroom/ OUTPUT_VARIABLE files)
included_libraries(needed exercises ${files})
set(answer_libraries answer_program exercises)
get_property(libraries GLOBAL PROPERTY chapter_libraries)
list(PREPEND libraries thread_pool engine)
list(REVERSE libraries)
foreach(library IN LISTS libraries)
  if(library IN_LIST needed)
    list(APPEND answer_libraries ${library})
    sources_of(files ${library})
    included_libraries(more ${library} ${files})
    list(APPEND needed ${more})
  endif()
endforeach()
list(APPEND answer_libraries pushback_simulation)
list(TRANSFORM answer_libraries REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE built)
list(TRANSFORM built REPLACE ".*exercises.*" ${scenes})
write_kit(${kit} "${answer_flags}" ${built})
add_custom_command(OUTPUT ${kit}/headers.parsed
  COMMAND ${CMAKE_CXX_COMPILER} ${answer_flags} -x c++-header ${kit}/headers.h -o ${parsed} -MD -MT ${kit}/headers.parsed -MF ${kit}/headers.d
  COMMAND ${CMAKE_COMMAND} -E touch ${kit}/headers.parsed
  DEPENDS ${kit}/headers.h DEPFILE ${kit}/headers.d VERBATIM COMMAND_EXPAND_LISTS)
add_custom_target(exercise_headers DEPENDS ${kit}/headers.parsed)

# The same for an installed Pushback and a student's own folder. `exercise` replaces @PREFIX@ by the folder in which it is installed.
string(REPLACE -I${headers} -I@PREFIX@/include flags "${answer_flags}")
list(TRANSFORM answer_libraries REPLACE "(.+)" "@PREFIX@/${CMAKE_INSTALL_LIBDIR}/$<TARGET_FILE_NAME:\\1>" OUTPUT_VARIABLE installed)
list(TRANSFORM installed REPLACE ".*TARGET_FILE_NAME:exercises.*" "@PREFIX@/${CMAKE_INSTALL_LIBDIR}/libscenes.a")
list(REMOVE_ITEM answer_libraries exercises)
write_kit(${PROJECT_BINARY_DIR}/package/exercise "${flags}" ${installed})
foreach(folder common engine chapters)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION include/pushback COMPONENT exercises FILES_MATCHING PATTERN "*.h" PATTERN "task.md")
endforeach()
file(GLOB pages CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/chapters/*/*.md ${PROJECT_SOURCE_DIR}/docs/*.md
  ${PROJECT_SOURCE_DIR}/docs/figures/* ${PROJECT_SOURCE_DIR}/renders/*/*.png)  # with the pictures that they show
foreach(page IN LISTS pages)
  get_filename_component(folder ${page} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION share/pushback/pages/${folder} COMPONENT exercises)
endforeach()
install(TARGETS ${answer_libraries} COMPONENT exercises)
install(FILES ${scenes} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT exercises)
install(DIRECTORY ${PROJECT_BINARY_DIR}/package/exercise DESTINATION share/pushback COMPONENT exercises)
install(FILES ${kit}/headers.h ${kit}/answer.cpp DESTINATION share/pushback/exercise COMPONENT exercises)
