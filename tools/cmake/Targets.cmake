# How the project's folders become targets. A new file in a folder needs no change here or there.

# slicecastPart(NAME USES PART... WITH THIRD_PARTY...): src/NAME/*.cpp, and those in its folders, as
# the library slicecast_NAME. USES names the parts to its right that it includes, WITH the libraries
# that only its own sources see.
function(slicecastPart name)
  cmake_parse_arguments(part "" "" "USES;WITH" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  list(TRANSFORM part_USES PREPEND slicecast_)
  if(sources)
    add_library(slicecast_${name} STATIC ${sources})
    # Before those of a host, whose headers may have the same names.
    target_include_directories(slicecast_${name} BEFORE PUBLIC ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/include)
    target_link_libraries(slicecast_${name} PUBLIC slicecast_flags ${part_USES} PRIVATE ${part_WITH} slicecast_strict)
  else()
    add_library(slicecast_${name} INTERFACE)
    target_include_directories(slicecast_${name} INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/include)
    target_link_libraries(slicecast_${name} INTERFACE slicecast_flags ${part_USES})
  endif()
endfunction()

# slicecastTuned(PART GROUP OPTIONS OPTION... FILES FILE...): compiles these files of a part, but for
# those of an earlier group, as one, with further options.
function(slicecastTuned part group)
  cmake_parse_arguments(tuned "" "" "OPTIONS;FILES" ${ARGN})
  list(TRANSFORM tuned_FILES PREPEND ${PROJECT_SOURCE_DIR}/src/${part}/)
  file(GLOB files CONFIGURE_DEPENDS ${tuned_FILES})
  get_target_property(rest slicecast_${part} SOURCES)
  set(others ${rest})
  list(REMOVE_ITEM others ${files})
  set(files ${rest})
  list(REMOVE_ITEM files ${others})
  set_target_properties(slicecast_${part} PROPERTIES SOURCES "${others}")
  set(target slicecast_${part}_${group})
  add_library(${target} OBJECT ${files})
  get_target_property(uses slicecast_${part} LINK_LIBRARIES)
  target_include_directories(${target} BEFORE PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/include)
  target_link_libraries(${target} PRIVATE ${uses})
  target_compile_options(${target} PRIVATE ${tuned_OPTIONS})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  target_sources(slicecast_${part} PRIVATE $<TARGET_OBJECTS:${target}>)
endfunction()

# slicecastProgram(NAME SOURCES FILE... WITH LIBRARY...): a program for the command line. In a
# WebAssembly build it becomes NAME.js, which Node runs and which reads the machine's own files.
function(slicecastProgram name)
  cmake_parse_arguments(program "" "" "SOURCES;WITH" ${ARGN})
  add_executable(${name} ${program_SOURCES})
  target_link_libraries(${name} PRIVATE ${program_WITH} slicecast_flags)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  if(SLICECAST_SANITIZE)
    # Sanitizers take long to compile: only what a test runs is built with them.
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
  if(EMSCRIPTEN)
    target_link_options(${name} PRIVATE -sENVIRONMENT=node -sNODERAWFS=1 -sEXIT_RUNTIME=1 -sALLOW_MEMORY_GROWTH=1
      # Under Node 18 and later the glue of 3.1.6 would try to fetch a file's path.
      -sWASM_ASYNC_COMPILATION=0 ${slicecastStack})
  endif()
endfunction()

# GoogleTest's header, precompiled for all tests of a build: parsing it takes half of a test's
# compile time.
function(slicecastTestHeader)
  find_package(GTest REQUIRED)
  set(nothing ${PROJECT_BINARY_DIR}/test_header.cpp)
  file(GENERATE OUTPUT ${nothing} CONTENT "")
  add_library(slicecast_test_header OBJECT ${nothing})
  target_link_libraries(slicecast_test_header PRIVATE GTest::gtest slicecast_flags)
  target_precompile_headers(slicecast_test_header PRIVATE <gtest/gtest.h>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # The same header has the same bytes, or the compiler's cache is of no use.
    target_compile_options(slicecast_test_header PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endfunction()

# slicecastTest(NAME [SHARDS COUNT] [LONG] SOURCES FILE... WITH LIBRARY...): a GoogleTest program.
# Shards let a long one run on several cores. LONG ones begin first: whichever begins last keeps the
# other cores waiting.
function(slicecastTest name)
  cmake_parse_arguments(test "LONG" "SHARDS" "SOURCES;WITH" ${ARGN})
  find_package(GTest REQUIRED)
  if(NOT TARGET slicecast_test_header)
    slicecastTestHeader()
  endif()
  add_executable(${name} ${test_SOURCES})
  target_precompile_headers(${name} REUSE_FROM slicecast_test_header)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE SLICECAST_SOURCE_FOLDER="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${test_WITH} GTest::gtest_main slicecast_flags)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  if(NOT CMAKE_UNITY_BUILD)
    # Some files at a time: they share most headers.
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 5)
  endif()
  set(cost 0)
  if(test_LONG)
    set(cost 1)
  endif()
  # tools/test counts the cases from the results that each run leaves behind.
  set(results "GTEST_OUTPUT=json:${PROJECT_BINARY_DIR}/results")
  if(NOT test_SHARDS)
    add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${name} PROPERTIES LABELS gtest COST ${cost}
      ENVIRONMENT "${results}/${name}.json")
    return()
  endif()
  foreach(shard RANGE 1 ${test_SHARDS})
    math(EXPR index "${shard} - 1")
    set(shardName ${name}_${shard}_of_${test_SHARDS})
    add_test(NAME ${shardName} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${shardName} PROPERTIES LABELS gtest COST ${cost}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${test_SHARDS};GTEST_SHARD_INDEX=${index};${results}/${shardName}.json")
  endforeach()
endfunction()

# The stack of a WebAssembly program in bytes, because Emscripten's default changed from 5 MB to 64
# KB. This is the older name of the setting, which all versions accept.
set(slicecastStack -sTOTAL_STACK=1048576)
