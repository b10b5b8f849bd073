include(${CMAKE_CURRENT_LIST_DIR}/build_outside.cmake)
build_outside(${outside_source})
count_right_queries(acme:LikelihoodField)
expect("the outside scorer is right in ${right} of 5 queries of malaga-demo, expected 5" right EQUAL 5)
