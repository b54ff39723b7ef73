# Compiles several sources of a target as one, which takes less than half
# of the time: most of it goes to headers and templates that they have in common.
# Python chooses the pieces (unite.py); without it each source is compiled alone.

set(PARLOUR_UNITE 0 CACHE STRING
  "So many sources at most are compiled as one; 0: each by itself")
option(PARLOUR_UNITE_TESTS "Those of tests as well" OFF)
find_package(Python3 COMPONENTS Interpreter QUIET)

# parlour_unite(<target>): after this, a source that gets compile options or
# definitions of its own is still compiled alone.
function(parlour_unite target)
  if(NOT PARLOUR_UNITE OR NOT Python3_FOUND)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY parlour_united ${target})
  # g++ warns of what stands on types of an unnamed namespace, but not in the file
  # that it was told to compile, where it is welcome.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# parlour_choose_pieces(): chooses for all targets that asked for it, when they
# are all known: one process for each target took a minute.
function(parlour_choose_pieces)
  get_property(targets GLOBAL PROPERTY parlour_united)
  set(list "")
  foreach(target IN LISTS targets)
    get_target_property(folder ${target} SOURCE_DIR)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${folder}")
      string(APPEND list "${target} ${source}\n")
      # A name that a source gets may need other pieces.
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    endforeach()
  endforeach()
  if(NOT list)
    return()
  endif()
  set(chooser "${PROJECT_SOURCE_DIR}/tools/cmake/unite.py")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${chooser}")
  file(WRITE "${PROJECT_BINARY_DIR}/united.txt" "${list}")
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -B "${chooser}" ${PARLOUR_UNITE}
      "${PROJECT_BINARY_DIR}/united.txt"
    OUTPUT_VARIABLE lines OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" lines "${lines}")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "^([^ ]+) ([0-9]+) (.*)$" line "${line}")
    set_source_files_properties("${CMAKE_MATCH_3}"
      TARGET_DIRECTORY ${CMAKE_MATCH_1}
      PROPERTIES UNITY_GROUP "${CMAKE_MATCH_1}_${CMAKE_MATCH_2}")
  endforeach()
endfunction()
