# Compiler settings for all targets: language standard, warnings, optimisation,
# sanitizers. Uses ccache and lld if they are installed.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
# -g1 keeps line numbers in stack traces at a fraction of -g's cost.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O0 -g1 -D_GLIBCXX_ASSERTIONS")

# For all alike, also those that need it only by a library: g++ reuses precompiled
# headers only where this agrees.
add_compile_options(-pthread)

# g++ collects its garbage again and again from 128 MB on, a tenth of the time.
add_compile_options($<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:--param=ggc-min-heapsize=600000>)

# What one clone has compiled, another one need not compile again.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 "${CCACHE}")
endif()
find_program(LLD ld.lld)
if(LLD)
  add_link_options(-fuse-ld=lld)
endif()

# Null and misaligned pointers are not looked for at each access, which is a third
# of the code: the first ends the process anyway, the second is harmless here.
# Checked types of functions are too much for clang 14's assembler. What is optimised
# a little is tested in half of the time.
if(PARLOUR_SANITIZE STREQUAL "address")
  add_compile_options(-O1 -fsanitize=address,undefined
    -fno-sanitize=alignment,function,null,vptr
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  # By which sources know that memory is watched; g++ defines it itself.
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    add_compile_definitions(__SANITIZE_ADDRESS__=1)
  endif()
elseif(PARLOUR_SANITIZE STREQUAL "thread")
  add_compile_options(-fsanitize=thread -O1 -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
elseif(PARLOUR_SANITIZE)
  message(FATAL_ERROR
    "PARLOUR_SANITIZE is address, thread or OFF, not '${PARLOUR_SANITIZE}'")
endif()

# clang++ only: coverage instrumentation for libFuzzer in every library. The
# preset fuzz-plain has neither sanitizers nor traced comparisons and runs many
# more inputs in the same time. It still finds failed assertions, crashes, hangs
# and unlimited memory.
if(PARLOUR_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
  if(NOT PARLOUR_SANITIZE)
    add_compile_options(-O2 -fno-sanitize-coverage=trace-cmp)
  endif()
endif()

add_library(parlour_warnings INTERFACE)
target_compile_options(parlour_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  -Wnon-virtual-dtor -Woverloaded-virtual
  # g++ 12 gives false warnings inside std::string and std::variant at -O2.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>
  # The same where a literal is joined to a std::string: it takes the 32 bytes
  # of the object for the whole buffer. From g++ 13 on it does not.
  $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds>
  $<$<BOOL:${PARLOUR_WARNINGS_AS_ERRORS}>:-Werror>)

# parlour_optimise_less(<target>): of what waits for people, files or networks;
# it is compiled in three quarters of the time.
function(parlour_optimise_less target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
