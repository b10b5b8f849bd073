# Run by ctest: cmake -D built_tree=... -P build_outside.cmake
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif()
endfunction()

set(prefix ${work_folder}/prefix)
set(outside_build ${work_folder}/build)
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
if(EXISTS ${outside_build}/check_${name})
  run("testing the installed plugin" ${outside_build}/check_${name} ${prefix}/lib/opal/plugins/${name}.so)
endif()

# docs/compare_scorers.md in small: the plugin is found in the folder that it was built into.
if(maps)
  file(REMOVE ${prefix}/lib/opal/plugins/${name}.so ${prefix}/lib/opal/plugins/${name}.jsonld)
  file(WRITE ${work_folder}/two_scorers.jsonld "{ \"@context\": \"urn:opal:v1\", \"@type\": \"opal:Experiment\",
    \"arms\": [ { \"name\": \"beams\" },
      { \"name\": \"mine\", \"overrides\": { \"scorers\": [ { \"@type\": \"acme:LikelihoodField\" } ] }, \"plugins\": \"build/plugins\" } ],
    \"sites\": [ { \"prefix\": \"${maps}/malaga/malaga-demo\" } ] }")
  file(REMOVE_RECURSE ${work_folder}/results)
  run("comparing scorers" ${prefix}/bin/opal ab ${work_folder}/two_scorers.jsonld -o ${work_folder}/results)
  file(STRINGS ${work_folder}/results/results.jsonl right REGEX "\"arm\":\"mine\".*\"success\":1.0.*\"failure\":\"\"")
  list(LENGTH right count)
  if(NOT count EQUAL 5)
    message(FATAL_ERROR "the outside scorer is right in ${count} of 5 queries of malaga-demo, expected 5")
  endif()
endif()
