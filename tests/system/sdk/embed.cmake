include(${CMAKE_CURRENT_LIST_DIR}/build_outside.cmake)
build_outside(${outside_source})
set(map ${work_folder}/malaga-demo.jsonld)
set(log ${maps}/malaga/malaga-demo.log.gz)
run("importing the map" ${opal} map import ${maps}/malaga/malaga-demo.map.yaml -o ${map})
run("embedding the localizer" ${outside_build}/embed ${configs}/malaga.jsonld ${map} ${log})
string(REGEX MATCHALL "localized, x [^\n]*" answers "${output}")
expect("the embedded localizer never says that it is localized:\n${output}" answers)
list(GET answers -1 last)
string(REPLACE "localized, " "" last "${last}")

# In this log every scan is a keyframe, so that the last answer is the one at the end.
run("localizing" ${opal} localize ${configs}/malaga.jsonld ${log} --map ${map} -o ${work_folder}/out)
string(FIND "${output}" "at the end: localized" status)
string(FIND "${output}" "pose: ${last}\n" pose)
expect("the embedded localizer ends with \"${last}\", and opal localize with:\n${output}"
       status GREATER -1 AND pose GREATER -1)
