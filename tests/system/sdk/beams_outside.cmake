# opal:Beams needs nothing that other scorers lack: its sources build outside the tree, and localize as those of the tree do.
include(${CMAKE_CURRENT_LIST_DIR}/build_outside.cmake)
set(copy ${work_folder}/source)
file(COPY ${outside_source}/ DESTINATION ${copy})
file(READ ${outside_source}/CMakeLists.txt add_plugin)
file(WRITE ${copy}/CMakeLists.txt "cmake_minimum_required(VERSION 3.22)
project(score_beams LANGUAGES CXX)
enable_testing()
find_package(opal 0.1 REQUIRED)
${add_plugin}")
build_outside(${copy})

# A type has one plugin: the outside one takes the place of the tree's in a copy of the installed programs.
set(other ${work_folder}/prefix)
file(COPY ${prefix}/bin ${prefix}/lib ${prefix}/share DESTINATION ${other})
file(REMOVE ${other}/lib/opal/plugins/score_beams.so ${other}/lib/opal/plugins/score_beams.jsonld)
run("installing the outside project" ${CMAKE_COMMAND} --install ${outside_build} --prefix ${other})
run("checking the installed plugin" ${other}/bin/opal plugins --check ${other}/lib/opal/plugins/score_beams.so)

foreach(tree IN ITEMS ${prefix} ${other})
  string(MD5 name ${tree})
  run("localizing with ${tree}" ${tree}/bin/opal localize ${configs}/malaga.jsonld ${maps}/malaga/malaga.log.gz
      --queries ${maps}/malaga/malaga.queries.json -o ${work_folder}/${name})
  list(APPEND answers ${work_folder}/${name})
endforeach()
list(POP_FRONT answers of_tree of_outside)
foreach(file IN ITEMS trajectory.tum results.csv)
  run("comparing ${file}" ${CMAKE_COMMAND} -E compare_files ${of_tree}/${file} ${of_outside}/${file})
endforeach()
