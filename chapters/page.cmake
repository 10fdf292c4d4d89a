# add_to_page(NAME): builds the chapter's experiment for a page: programs/NAME.wasm, and NAME.js, which loads it.
set(calls description parameters values set choose scene lanes variant steps known now go_to camera grab pull let_go reach shift mishap
    played series reference number column cells sample hash body bodies open begin draw legend hold problem stored matrix iterate
    iteration iterated residuals impulses)
list(TRANSFORM calls REPLACE "(.+)" "_live_\\1")
function(add_to_page name)
  # The stack contains the variables of main and of a step; the other memory grows. -O1 is enough, because the compiler has optimized
  # each object. A second pass over the whole program would take a third of the total time and make a step a tenth faster.
  target_link_options(${name} PRIVATE -O1 -sMODULARIZE=1 -sEXPORT_NAME=createPushbackLive -sENVIRONMENT=web,node -sNODEJS_CATCH_EXIT=0 -sNODEJS_CATCH_REJECTION=0 -sFILESYSTEM=0
    -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=33554432 -sTOTAL_STACK=1048576 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
    -sEXPORTED_RUNTIME_METHODS=UTF8ToString,stringToUTF8,lengthBytesUTF8,stackAlloc,stackSave,stackRestore
    "-sEXPORTED_FUNCTIONS=_main,$<JOIN:${calls},$<COMMA>>")
endfunction()
