# The package `opal` of Python: python/opal of the build, and dist-packages of an installed Opal. Optional: OPAL_HAS_PYTHON
# says whether the system's Python, its headers, numpy and pybind11 are there. Not one that a version switcher puts before
# it: Debian's packages are for that one.
set(OPAL_PYTHON_FOLDER lib/python3/dist-packages)  # what Debian's Python searches below /usr and /usr/local
set(OPAL_HAS_PYTHON FALSE)
if(OPAL_BUILD_PYTHON AND OPAL_SANITIZE)
  message(STATUS "the Python module is left out: a sanitizer would have to be in the interpreter, too")
elseif(OPAL_BUILD_PYTHON)
  set(Python_EXECUTABLE /usr/bin/python3)
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development NumPy)
  if(Python_FOUND)
    find_package(pybind11 2.10 QUIET)
  endif()
  if(Python_FOUND AND pybind11_FOUND)
    set(OPAL_HAS_PYTHON TRUE)
  else()
    message(STATUS "pybind11-dev, python3-dev or python3-numpy not found: the Python module is left out")
  endif()
endif()

# opal_add_python_package(FOLDER [LINKS target...]): the sources in FOLDER as the module opal._opal, with the files of
# FOLDER/package/opal.
function(opal_add_python_package folder)
  cmake_parse_arguments(arg "" "" "LINKS" ${ARGN})
  set(package ${CMAKE_BINARY_DIR}/python/opal)
  set(installed ${OPAL_PYTHON_FOLDER}/opal)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/values/*.cpp)
  add_library(opal_python MODULE ${sources})
  target_link_libraries(opal_python PRIVATE pybind11::module opal::opal opal_tree ${arg_LINKS})
  file(RELATIVE_PATH to_libraries /${installed} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(opal_python PROPERTIES PREFIX "" OUTPUT_NAME _opal SUFFIX .${Python_SOABI}.so
                        LIBRARY_OUTPUT_DIRECTORY ${package} INSTALL_RPATH "$ORIGIN/${to_libraries}")
  target_compile_options(opal_python PRIVATE -O1)  # nothing here computes, and pybind11 is all templates
  opal_one_unit_per_folder(opal_python)
  install(TARGETS opal_python LIBRARY DESTINATION ${installed})

  file(GLOB files CONFIGURE_DEPENDS ${folder}/package/opal/*)
  foreach(file IN LISTS files)
    get_filename_component(name ${file} NAME)
    add_custom_command(OUTPUT ${package}/${name} DEPENDS ${file} VERBATIM
                       COMMAND ${CMAKE_COMMAND} -E copy ${file} ${package}/${name})
    list(APPEND copies ${package}/${name})
  endforeach()
  add_custom_target(opal_python_package ALL DEPENDS ${copies})
  add_dependencies(opal_python opal_python_package)
  install(FILES ${files} DESTINATION ${installed})
endfunction()
