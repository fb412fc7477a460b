# Build options and the compile flags that every target shares.
option(DAPPLE_BUILD_TESTS "Build the test suite" ON)
option(DAPPLE_BUILD_BENCH "Build the benchmarks" OFF)
option(DAPPLE_BUILD_FUZZERS "Build the fuzz targets (clang only)" OFF)
option(DAPPLE_ROOT_LINKS "Link the programs into the source folder" OFF)
option(DAPPLE_WERROR "Treat warnings as errors" OFF)
option(DAPPLE_ASSIMP "Import FBX, COLLADA, 3DS and others through assimp where it is found" ON)
set(DAPPLE_SANITIZE "" CACHE STRING "Sanitizers to build with, for example address,undefined")

# Release is -O3 with both compilers. There is no -march: one binary serves every x86-64, and the
# kernels choose their instruction set when the program starts.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Before any folder asks where things go.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# Link-time optimisation could move code of one instruction set into a function of another.
set(CMAKE_INTERPROCEDURAL_OPTIMIZATION OFF)

add_library(dapple_flags INTERFACE)
# Contraction to fused multiply-add would make the bits depend on the processor and compiler.
target_compile_options(dapple_flags INTERFACE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wshadow)
if(DAPPLE_WERROR)
  target_compile_options(dapple_flags INTERFACE -Werror)
endif()
if(DAPPLE_BUILD_FUZZERS)
  # The library reports to the fuzzer which branches an input takes; its errors are never survived.
  target_compile_options(dapple_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(dapple_flags INTERFACE -fsanitize=address,undefined)
endif()
if(DAPPLE_SANITIZE)
  target_compile_options(dapple_flags INTERFACE -fsanitize=${DAPPLE_SANITIZE}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(dapple_flags INTERFACE -fsanitize=${DAPPLE_SANITIZE})
endif()
