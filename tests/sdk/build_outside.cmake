# Run by ctest: cmake -D built_tree=... -P build_outside.cmake
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif()
endfunction()

set(prefix ${work_folder}/prefix)
set(outside_build ${work_folder}/posts)
file(REMOVE_RECURSE ${prefix} ${outside_build})
set(flags "")
if(sanitize)
  set(flags "-fsanitize=${sanitize} -fno-omit-frame-pointer")
endif()

run("installing the built tree (is all of it built?)" ${CMAKE_COMMAND} --install ${built_tree} --prefix ${prefix})
run("configuring the outside project" ${CMAKE_COMMAND} -S ${outside_source} -B ${outside_build} -G ${generator}
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=${build_type} -D CMAKE_CXX_COMPILER=${compiler}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher} -D CMAKE_CXX_FLAGS=${flags} -D OPAL_SANITIZE=${sanitize})
run("building the outside project" ${CMAKE_COMMAND} --build ${outside_build})
run("testing the outside project" ${CMAKE_CTEST_COMMAND} --test-dir ${outside_build} --output-on-failure)
run("installing the outside project" ${CMAKE_COMMAND} --install ${outside_build} --prefix ${prefix})
run("testing the installed plugin" ${outside_build}/check_posts ${prefix}/lib/opal/plugins/posts.so)
