# The baseline plays one challenge in a small room, and its answer becomes a column.
file(REMOVE_RECURSE ${OUT})
execute_process(COMMAND ${OPAL} experiment thesis3 --map ${MAP} -o ${OUT} --config default --only B1 --seeds 1 --duration 15 --baseline ${BASELINE}
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "opal experiment failed")
endif()
file(STRINGS ${OUT}/runs.csv row REGEX "^particle_filter,B1,1,")
if(NOT row)
  message(FATAL_ERROR "no row of the particle filter in ${OUT}/runs.csv")
endif()
