# What the scripts beside this one begin with: each is run by ctest as cmake -D prefix=... -P SCRIPT.
set(outside_build ${work_folder}/build)
set(opal ${prefix}/bin/opal)
file(REMOVE_RECURSE ${work_folder})
file(MAKE_DIRECTORY ${work_folder})

# Leaves what the command has printed in `output`.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect what)
  if(NOT (${ARGN}))
    message(FATAL_ERROR "${what}")
  endif()
endfunction()

# The project in `source`, built as its author would; plugins are put through their contract.
function(build_outside source)
  set(flags "")
  if(sanitize)
    set(flags "-fsanitize=${sanitize} -fno-omit-frame-pointer")
  endif()
  run("configuring the outside project" ${CMAKE_COMMAND} -S ${source} -B ${outside_build} -G ${generator}
      -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=${build_type} -D CMAKE_CXX_COMPILER=${compiler}
      -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher} -D CMAKE_CXX_FLAGS=${flags} -D OPAL_SANITIZE=${sanitize})
  run("building the outside project" ${CMAKE_COMMAND} --build ${outside_build})
  run("testing the outside project" ${CMAKE_CTEST_COMMAND} --test-dir ${outside_build} --output-on-failure)
endfunction()

# docs/compare_scorers.md in small: in `right`, how many of the 5 queries of malaga-demo the scorer is right in. The plugin is
# found in the folder that it was built into.
function(count_right_queries scorer)
  file(WRITE ${work_folder}/two_scorers.jsonld "{ \"@context\": \"urn:opal:v1\", \"@type\": \"opal:Experiment\",
    \"arms\": [ { \"name\": \"beams\" },
      { \"name\": \"mine\", \"overrides\": { \"scorers\": [ { \"@type\": \"${scorer}\" } ] }, \"plugins\": \"build/plugins\" } ],
    \"sites\": [ { \"prefix\": \"${maps}/malaga/malaga-demo\" } ] }")
  run("comparing scorers" ${opal} ab ${work_folder}/two_scorers.jsonld -o ${work_folder}/results)
  file(STRINGS ${work_folder}/results/results.jsonl lines REGEX "\"arm\":\"mine\".*\"success\":1.0.*\"failure\":\"\"")
  list(LENGTH lines count)
  set(right ${count} PARENT_SCOPE)
endfunction()
