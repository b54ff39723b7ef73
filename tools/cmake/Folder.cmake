# Functions that make a library from a folder, and a test program from the same
# folder below tests/. Sources are globbed, so a new file needs no edit here.

# parlour_folder_name(<variable> <folder>): the name of a folder in the names of
# targets: script_dialogue for "script/dialogue".
function(parlour_folder_name variable folder)
  string(REGEX REPLACE "[/.-]" "_" name "${folder}")
  set(${variable} "${name}" PARENT_SCOPE)
endfunction()

# Standard headers that most sources include. They take half of a source's
# compile time, so larger libraries precompile them.
set(PARLOUR_HEADERS
  <algorithm> <array> <charconv> <chrono> <cstdint> <deque> <filesystem>
  <functional> <map> <memory> <optional> <set> <span> <string> <string_view>
  <unordered_map> <utility> <variant> <vector> <tl/expected.hpp>)

# parlour_library(<name> [SHARED] SOURCES ... [PUBLIC ...] [PRIVATE ...])
# A library without sources is an INTERFACE library, so that targets which link
# it can be configured.
function(parlour_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg
    "SHARED" "" "SOURCES;PUBLIC;PRIVATE")
  if(arg_SOURCES)
    set(kind STATIC)
    if(arg_SHARED)
      set(kind SHARED)
    endif()
    add_library(${name} ${kind} ${arg_SOURCES})
    target_include_directories(${name} PUBLIC
      "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>")
    target_link_libraries(${name}
      PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} parlour_warnings)
    list(LENGTH arg_SOURCES count)
    if(count GREATER 8)
      target_precompile_headers(${name} PRIVATE ${PARLOUR_HEADERS})
    endif()
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE "${PROJECT_SOURCE_DIR}")
    target_link_libraries(${name} INTERFACE ${arg_PUBLIC})
  endif()
endfunction()

# parlour_test(<folder> SOURCES ... LINK ... HEADERS <target>
#   [TOGETHER <pattern>]):
# makes the GoogleTest program test_<folder> from the sources, with the
# precompiled headers of the target <target>. ctest runs each test in a process
# of its own, and those that match the pattern together in one.
function(parlour_test folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADERS;TOGETHER" "SOURCES;LINK")
  parlour_folder_name(name "${folder}")
  add_executable(test_${name} ${arg_SOURCES})
  target_link_libraries(test_${name} PRIVATE ${arg_LINK} parlour_testing)
  target_precompile_headers(test_${name} REUSE_FROM ${arg_HEADERS})
  if(PARLOUR_SANITIZE)
    # One process for the whole folder: starting one takes long with sanitizers.
    add_test(NAME "${folder}" COMMAND test_${name} --gtest_brief=1
      WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  else()
    if(arg_TOGETHER)
      set(others TEST_FILTER "-${arg_TOGETHER}")
      add_test(NAME "${folder}: ${arg_TOGETHER}"
        COMMAND test_${name} --gtest_brief=1 --gtest_filter=${arg_TOGETHER}
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    endif()
    gtest_discover_tests(test_${name} ${others}
      TEST_PREFIX "${folder}: " DISCOVERY_MODE PRE_TEST
      WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
      DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
