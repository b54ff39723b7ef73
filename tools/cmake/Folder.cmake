# Functions that make a library from a folder, and a test program from the same
# folder below tests/. Sources are globbed, so a new file needs no edit here.

# parlour_folder_name(<variable> <folder>): the name of a folder in the names of
# targets: script_dialogue for "script/dialogue".
function(parlour_folder_name variable folder)
  string(REGEX REPLACE "[/.-]" "_" name "${folder}")
  set(${variable} "${name}" PARENT_SCOPE)
endfunction()

# Standard headers that most sources include. They take half of a source's
# compile time, so they are precompiled.
set(PARLOUR_HEADERS
  <algorithm> <array> <charconv> <chrono> <cstdint> <deque> <filesystem>
  <functional> <map> <memory> <optional> <set> <span> <string> <string_view>
  <unordered_map> <utility> <variant> <vector> <tl/expected.hpp>)

# parlour_precompile(<target> <library> [<header>...]): makes a target whose
# precompiled headers others reuse: those above, and further ones. To compile
# them takes longer than most sources, so libraries share what they can.
function(parlour_precompile target library)
  file(CONFIGURE OUTPUT headers.cpp CONTENT "")
  add_library(${target} OBJECT EXCLUDE_FROM_ALL
    "${CMAKE_CURRENT_BINARY_DIR}/headers.cpp")
  target_link_libraries(${target} PRIVATE ${library} parlour_warnings)
  target_precompile_headers(${target} PRIVATE ${PARLOUR_HEADERS} ${ARGN})
endfunction()
parlour_precompile(parlour_headers tl::expected)

# parlour_library(<name> [SHARED] [HEADERS <target>] SOURCES ... [PUBLIC ...]
#   [PRIVATE ...]): with the precompiled headers of the target <target>. A shared
# library has its own, because it is compiled in another way. A library without sources is an INTERFACE library, so that targets which link
# it can be configured.
function(parlour_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg
    "SHARED" "HEADERS" "SOURCES;PUBLIC;PRIVATE")
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
    if(arg_SHARED)
      target_precompile_headers(${name} PRIVATE ${PARLOUR_HEADERS})
    elseif(arg_HEADERS)
      target_precompile_headers(${name} REUSE_FROM ${arg_HEADERS})
    else()
      target_precompile_headers(${name} REUSE_FROM parlour_headers)
    endif()
    parlour_unite(${name})
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE "${PROJECT_SOURCE_DIR}")
    target_link_libraries(${name} INTERFACE ${arg_PUBLIC})
  endif()
endfunction()

# parlour_test(<folder> SOURCES ... LINK ... HEADERS <target>
#   [TOGETHER <pattern>]):
# makes the GoogleTest program test_<folder> from the sources, with the
# precompiled headers of the target <target>.
function(parlour_test folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADERS;TOGETHER" "SOURCES;LINK")
  parlour_folder_name(name "${folder}")
  add_executable(test_${name} ${arg_SOURCES})
  # gtest_main comes first: libwebrtc_audio_processing has a main() of its own.
  target_link_libraries(test_${name} PRIVATE
    GTest::gtest_main ${arg_LINK} parlour_testing)
  target_precompile_headers(test_${name} REUSE_FROM ${arg_HEADERS})
  if(PARLOUR_UNITE_TESTS)
    parlour_unite(test_${name})
  endif()
  parlour_runs(test_${name} "${folder}" "${arg_TOGETHER}")
endfunction()

# parlour_runs(<program> <folder> <pattern>): how ctest runs the program: the
# tests that match the pattern in one process, all others in two, because to
# start a process takes longer than most tests. With PARLOUR_TESTS_APART each
# of the others has a process and a name in ctest.
function(parlour_runs program folder together)
  set(others "-${together}")
  if(together)
    add_test(NAME "${folder}: ${together}"
      COMMAND ${program} --gtest_filter=${together}
      WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  endif()
  if(PARLOUR_TESTS_APART)
    gtest_discover_tests(${program} TEST_FILTER "${others}"
      TEST_PREFIX "${folder}: " DISCOVERY_MODE PRE_TEST
      WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
      DISCOVERY_TIMEOUT 60)
    return()
  endif()
  foreach(half 0 1)
    math(EXPR number "${half} + 1")
    add_test(NAME "${folder}: half ${number}"
      COMMAND ${program} --gtest_filter=${others}
      WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    set_tests_properties("${folder}: half ${number}" PROPERTIES
      ENVIRONMENT "GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=${half}")
  endforeach()
endfunction()
