# Run by ctest: cmake -D built_tree=... -D prefix=... -P install_tree.cmake
file(REMOVE_RECURSE ${prefix})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${built_tree} --prefix ${prefix}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "installing the built tree failed; is all of it built?\n${output}")
endif()
