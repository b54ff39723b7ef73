# One library for a folder, one test program for its mirror below tests/.
# Sources are globbed: a new file needs no edit here.

# parlour_folder_name(<variable> <folder>): "script/dialogue" is named
# script_dialogue wherever a target carries its name.
function(parlour_folder_name variable folder)
  string(REGEX REPLACE "[/.-]" "_" name "${folder}")
  set(${variable} "${name}" PARENT_SCOPE)
endfunction()

# The standard headers that most sources read: half of a source's compile time,
# so a library of many sources compiles them once.
set(PARLOUR_HEADERS
  <algorithm> <array> <charconv> <chrono> <cstdint> <deque> <filesystem>
  <functional> <map> <memory> <optional> <set> <span> <string> <string_view>
  <unordered_map> <utility> <variant> <vector> <tl/expected.hpp>)

# parlour_library(<name> [SHARED] SOURCES ... [PUBLIC ...] [PRIVATE ...])
# Without a source yet it is an INTERFACE library, so that those above it
# can already be built.
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
# the sources become one GoogleTest program test_<folder>, with that target's
# precompiled headers. Each test runs in a process of its own; those that the
# pattern names, in one.
function(parlour_test folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADERS;TOGETHER" "SOURCES;LINK")
  parlour_folder_name(name "${folder}")
  add_executable(test_${name} ${arg_SOURCES})
  target_link_libraries(test_${name} PRIVATE ${arg_LINK} parlour_testing)
  target_precompile_headers(test_${name} REUSE_FROM ${arg_HEADERS})
  if(PARLOUR_SANITIZE)
    # One process for all of a folder: under sanitizers starting it is dear.
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
