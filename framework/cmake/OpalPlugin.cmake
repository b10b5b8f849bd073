# opal_add_plugin(NAME source... [LIBRARIES target...])
# One shared library, NAME.so, with its description NAME.jsonld (from plugin.jsonld) beside it. In this tree it lands in the build's plugin
# folder and is run through the contract tests; outside, in ${CMAKE_BINARY_DIR}/plugins.
function(opal_add_plugin name)
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  add_library(${name}_plugin MODULE ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name}_plugin PRIVATE opal::opal ${arg_LIBRARIES})
  set_target_properties(${name}_plugin PROPERTIES
    OUTPUT_NAME ${name} PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
  # clang does not link its sanitizer runtime into shared libraries, so symbols stay open there.
  if(NOT (CMAKE_CXX_COMPILER_ID MATCHES Clang AND OPAL_SANITIZE))
    target_link_options(${name}_plugin PRIVATE -Wl,--no-undefined)
  endif()
  add_custom_command(TARGET ${name}_plugin POST_BUILD COMMAND ${CMAKE_COMMAND} -E copy_if_different
    ${CMAKE_CURRENT_SOURCE_DIR}/plugin.jsonld ${CMAKE_BINARY_DIR}/plugins/${name}.jsonld)
  if(PROJECT_NAME STREQUAL "opal")
    install(TARGETS ${name}_plugin LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/opal/plugins)
    install(FILES plugin.jsonld DESTINATION ${CMAKE_INSTALL_LIBDIR}/opal/plugins RENAME ${name}.jsonld)
    set_property(GLOBAL APPEND PROPERTY OPAL_PLUGINS ${name})
  endif()
endfunction()
