# opal_add_plugin(NAME source... [LIBRARIES target...])
#
# One shared library, NAME.so, with its description NAME.jsonld (made from plugin.jsonld beside the CMakeLists.txt) in
# ${CMAKE_BINARY_DIR}/plugins; both are installed into lib/opal/plugins. The target is called NAME_plugin.
# The plugin is put through the contract tests: in Opal's own tree by tests/plugin/contract, elsewhere by a test
# NAME_keeps_its_contract, if the project calls enable_testing() first.
function(opal_add_plugin name)
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  if(NOT arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "opal_add_plugin(${name}): no source files")
  endif()
  set(description ${CMAKE_CURRENT_SOURCE_DIR}/plugin.jsonld)
  if(NOT EXISTS ${description})
    message(FATAL_ERROR "opal_add_plugin(${name}): ${description} is missing; every plugin describes its types there")
  endif()
  include(GNUInstallDirs)
  set(folder ${CMAKE_BINARY_DIR}/plugins)

  add_library(${name}_plugin MODULE ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name}_plugin PRIVATE opal::opal ${arg_LIBRARIES})
  set_target_properties(${name}_plugin PROPERTIES
    OUTPUT_NAME ${name} PREFIX "" SUFFIX ".so" LIBRARY_OUTPUT_DIRECTORY ${folder}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    INSTALL_RPATH "$ORIGIN/../.."
    CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  if(TARGET opal_headers)  # in Opal's own tree
    target_link_libraries(${name}_plugin PRIVATE fmt::fmt)
    target_precompile_headers(${name}_plugin REUSE_FROM opal_headers)
    opal_one_unit_per_folder(${name}_plugin)
  endif()
  # An undefined symbol shows when the plugin is linked, not when a robot loads it. clang does not link its sanitizer
  # runtime into shared libraries, so symbols stay open there.
  if(NOT (CMAKE_CXX_COMPILER_ID MATCHES Clang AND OPAL_SANITIZE))
    target_link_options(${name}_plugin PRIVATE -Wl,--no-undefined)
  endif()

  # Linking depends on the description, so that a change of it alone is copied too.
  set_property(TARGET ${name}_plugin APPEND PROPERTY LINK_DEPENDS ${description})
  add_custom_command(TARGET ${name}_plugin POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${description} ${folder}/${name}.jsonld)

  install(TARGETS ${name}_plugin LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/opal/plugins)
  install(FILES ${description} DESTINATION ${CMAKE_INSTALL_LIBDIR}/opal/plugins RENAME ${name}.jsonld)
  set_property(GLOBAL APPEND PROPERTY OPAL_PLUGINS ${name}_plugin)
  if(TARGET opal::app)
    add_test(NAME ${name}_keeps_its_contract COMMAND opal::app plugins --check $<TARGET_FILE:${name}_plugin>)
  endif()
endfunction()
