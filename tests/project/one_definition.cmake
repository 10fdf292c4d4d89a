# Not built by default; ./course check links it with the preset odr. It links the objects themselves, because the linker takes from an
# archive only the objects that are needed.
add_executable(one_definition EXCLUDE_FROM_ALL one_definition.cpp)
foreach(folder common engine chapters tools)
  targets_below(targets ${folder})
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(by_hand ${target} LINKED_BY_HAND)
    if(type STREQUAL "STATIC_LIBRARY" AND NOT by_hand AND NOT target MATCHES "^(answer_program|peer_)")
      target_link_libraries(one_definition PRIVATE ${target})
      target_sources(one_definition PRIVATE $<TARGET_OBJECTS:${target}>)
    endif()
  endforeach()
endforeach()
