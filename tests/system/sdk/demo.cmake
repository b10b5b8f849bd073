# Run by ctest: cmake -D prefix=... -D work_folder=... -P demo.cmake
# The demo of an installed Opal, in a folder of its own, and what is installed beside the program.
file(REMOVE_RECURSE ${work_folder})
file(MAKE_DIRECTORY ${work_folder})
execute_process(COMMAND ${prefix}/bin/opal demo WORKING_DIRECTORY ${work_folder}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "opal demo ended with ${result}:\n${output}")
endif()
foreach(file map.svg malaga.jsonld events.jsonl results.csv picture.png view.html)
  if(NOT EXISTS ${work_folder}/opal-demo/${file})
    message(FATAL_ERROR "opal demo wrote no ${file}:\n${output}")
  endif()
endforeach()
if(NOT output MATCHES "localized after [0-9.]+ m")
  message(FATAL_ERROR "opal demo does not say when the robot was localized:\n${output}")
endif()

foreach(file README.md docs/start.md docs/images docs/examples/embed/main.cpp configs/default.jsonld maps/gemini.jsonld
             maps/malaga/malaga.log.gz maps/malaga/NOTICE maps/context/opal.jsonld)
  if(NOT EXISTS ${prefix}/share/opal/${file})
    message(FATAL_ERROR "share/opal/${file} is not installed")
  endif()
endforeach()
file(READ ${prefix}/share/opal/docs/start.md page)
if(page MATCHES "maps/malaga/malaga.map.yaml" AND NOT EXISTS ${prefix}/share/opal/maps/malaga/malaga.map.yaml)
  message(FATAL_ERROR "the page start.md names maps/malaga/malaga.map.yaml, which is not installed beside it")
endif()
