# The pages that the program writes: a page's modules become one script (esbuild), and that script, the style and the markup
# become a C++ source, so that the program needs no file beside it.
find_program(ESBUILD esbuild REQUIRED)
find_path(DYGRAPHS_FOLDER dygraph.min.js PATHS /usr/share/javascript/dygraphs NO_DEFAULT_PATH REQUIRED)
find_path(D3_FOLDER d3-axis/package.json PATHS /usr/share/nodejs NO_DEFAULT_PATH REQUIRED)

# opal_embed_page(ROOM LIBRARY HEADER [NAME FILE]...): the modules of ROOM/page with what its bundle.sh finds in LIBRARY, and
# files of ROOM/page, as the constants NAME that HEADER declares; the script is the FILE page.js. Sets ROOM_assets.
function(opal_embed_page room library header)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/${room}/page)
  file(GLOB modules CONFIGURE_DEPENDS ${folder}/*.js ${library}/*.js)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${room}_page.js)
  add_custom_command(OUTPUT ${script} COMMAND sh ${folder}/bundle.sh ${script} ${library}
    DEPENDS ${modules} ${folder}/bundle.sh VERBATIM COMMENT "Bundling the modules of ${room}/page")
  while(ARGN)
    list(POP_FRONT ARGN name file)
    list(APPEND names ${name})
    list(APPEND files ${folder}/${file})
  endwhile()
  list(TRANSFORM files REPLACE ".*/page.js$" ${script})
  list(JOIN names "$<SEMICOLON>" all_names)
  list(JOIN files "$<SEMICOLON>" all_files)
  set(assets ${CMAKE_CURRENT_BINARY_DIR}/${room}_page_assets.cpp)
  set(embed ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedFiles.cmake)
  add_custom_command(OUTPUT ${assets}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${assets} -DHEADER=${header} "-DNAMES=${all_names}" "-DFILES=${all_files}" -P ${embed}
    DEPENDS ${files} ${embed} VERBATIM COMMENT "Embedding ${room}/page")
  # A page is longer than the string literals that every compiler must take; gcc and clang take it.
  set_source_files_properties(${assets} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
  set(${room}_assets ${assets} PARENT_SCOPE)
endfunction()
