# The page of `opal view`: its modules become one script (esbuild), and index.html, style.css and that script become a C++
# source, so that the program needs no file beside it. Sets `page_assets`.
find_program(ESBUILD esbuild REQUIRED)
find_path(DYGRAPHS_FOLDER dygraph.min.js PATHS /usr/share/javascript/dygraphs NO_DEFAULT_PATH REQUIRED)

set(page_folder ${CMAKE_CURRENT_SOURCE_DIR}/viewer/page)
file(GLOB page_modules CONFIGURE_DEPENDS ${page_folder}/*.js)
set(page_script ${CMAKE_CURRENT_BINARY_DIR}/page.js)
add_custom_command(OUTPUT ${page_script}
  COMMAND sh ${page_folder}/bundle.sh ${page_script} ${DYGRAPHS_FOLDER}
  DEPENDS ${page_modules} ${page_folder}/bundle.sh VERBATIM COMMENT "Bundling the page's modules")

set(page_assets ${CMAKE_CURRENT_BINARY_DIR}/page_assets.cpp)
set(embed_script ${CMAKE_CURRENT_LIST_DIR}/EmbedFiles.cmake)
add_custom_command(OUTPUT ${page_assets}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${page_assets} -DHEADER=viewer/html/page_assets.hpp
          "-DNAMES=kPageIndex$<SEMICOLON>kPageStyle$<SEMICOLON>kPageScript"
          "-DFILES=${page_folder}/index.html$<SEMICOLON>${page_folder}/style.css$<SEMICOLON>${page_script}" -P ${embed_script}
  DEPENDS ${page_folder}/index.html ${page_folder}/style.css ${page_script} ${embed_script}
  VERBATIM COMMENT "Embedding the page")
