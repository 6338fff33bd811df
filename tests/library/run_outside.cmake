# Configures, builds and runs the project in `outside` in one of four ways.
#
#     cmake -DWAY=add_subdirectory | FetchContent | find_package | pkg-config -DSLICECAST=FOLDER -DBUILD=FOLDER
#           -DWORK=FOLDER -DGENERATOR=NAME -DCOMPILER=FILE [-DLAUNCHER=FILE] -P run_outside.cmake
#
# SLICECAST is the source tree, BUILD a build of it whose library is built, WORK is emptied first.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${WAY}: ${ARGN}\n${output}")
  endif()
  message(STATUS "${output}")
endfunction()

file(REMOVE_RECURSE ${WORK})
file(COPY ${CMAKE_CURRENT_LIST_DIR}/outside/ DESTINATION ${WORK}/host)
set(options -DWAY=${WAY} -DSLICECAST=${SLICECAST} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Outside
  # What a guest must not need is not there.
  -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_DISABLE_FIND_PACKAGE_SDL2=ON
  # Each part as one file, which takes a third of the time.
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0)
if(LAUNCHER)
  list(APPEND options -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
endif()
if(WAY MATCHES "find_package|pkg-config")
  run(${CMAKE_COMMAND} --install ${BUILD} --component slicecast --prefix ${WORK}/prefix)
  list(APPEND options -DCMAKE_PREFIX_PATH=${WORK}/prefix)
endif()
if(WAY STREQUAL "pkg-config")
  # Without CMake. An installation may be moved.
  file(RENAME ${WORK}/prefix ${WORK}/moved)
  file(GLOB_RECURSE package ${WORK}/moved/slicecast.pc)
  get_filename_component(folder ${package} DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  execute_process(COMMAND pkg-config --cflags --libs slicecast COMMAND_ERROR_IS_FATAL ANY
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE)
  separate_arguments(flags)
  run(${COMPILER} -std=c++20 -I${WORK}/host ${WORK}/host/main.cpp ${flags} -o ${WORK}/outside)
  run(${WORK}/outside)
  file(REMOVE_RECURSE ${WORK})
  return()
endif()
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK}/host -B ${WORK}/build ${options})
run(${CMAKE_COMMAND} --build ${WORK}/build --target outside)
run(${WORK}/build/outside)
file(REMOVE_RECURSE ${WORK})
