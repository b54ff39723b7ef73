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
  get_target_property(sources ${target} SOURCES)
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/tools/cmake/unite.py"
      ${PARLOUR_UNITE} ${sources}
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    OUTPUT_VARIABLE lines OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" lines "${lines}")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "^([0-9]+) (.*)$" line "${line}")
    set_source_files_properties("${CMAKE_MATCH_2}" PROPERTIES
      UNITY_GROUP "${target}_${CMAKE_MATCH_1}")
  endforeach()
  # g++ warns of what stands on types of an unnamed namespace, but not in the file
  # that it was told to compile, where it is welcome.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A name that a source gets may need other pieces.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${sources} "${PROJECT_SOURCE_DIR}/tools/cmake/unite.py")
endfunction()
