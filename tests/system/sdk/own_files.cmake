# A program in /usr/bin has the root folder of the machine where a built one has the sources. Files of others there are not its own.
include(${CMAKE_CURRENT_LIST_DIR}/build_outside.cmake)
set(other ${work_folder}/installed/prefix)
file(COPY ${prefix}/bin ${prefix}/lib ${prefix}/share DESTINATION ${other})
file(WRITE ${work_folder}/configs/malaga.jsonld "{}")
set(demo ${other}/share/opal/maps/malaga/malaga-demo)
run("localizing beside another folder configs" ${other}/bin/opal localize malaga ${demo}.log.gz --map ${demo}.map.yaml
    -o ${work_folder}/out)
