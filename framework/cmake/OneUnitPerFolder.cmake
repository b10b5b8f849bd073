# Compiling a folder as one unit costs a third to a fifth of the CPU time of compiling its files one by one: headers and
# templates are read once. Names in anonymous namespaces must then differ within a folder. Each file still includes what it
# uses: the linter and the preset debug compile file by file.
option(OPAL_ONE_UNIT_PER_FOLDER "compile all sources of a folder together" ON)

# opal_one_unit_per_folder(TARGET): the sources of TARGET, a unit per folder.
function(opal_one_unit_per_folder target)
  if(NOT OPAL_ONE_UNIT_PER_FOLDER)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source MATCHES "\\.cpp$")
      get_filename_component(folder ${source} DIRECTORY)
      string(MAKE_C_IDENTIFIER "${target}_${folder}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  # Types of a source's anonymous namespace stay in that source, though it is read from another file.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
