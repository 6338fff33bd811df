# Finds the Emscripten on PATH and includes its toolchain file.
find_program(SLICECAST_EMCC emcc REQUIRED)
get_filename_component(SLICECAST_EMSCRIPTEN_ROOT "${SLICECAST_EMCC}" REALPATH)
get_filename_component(SLICECAST_EMSCRIPTEN_ROOT "${SLICECAST_EMSCRIPTEN_ROOT}" DIRECTORY)
if(SLICECAST_EMSCRIPTEN_ROOT STREQUAL "/usr/share/emscripten")
  set(SLICECAST_EMSCRIPTEN_OF_DEBIAN TRUE)
elseif(NOT EXISTS "${SLICECAST_EMSCRIPTEN_ROOT}/cmake/Modules/Platform/Emscripten.cmake")
  # Other packagers put a wrapper on PATH; it knows its root.
  execute_process(COMMAND em-config EMSCRIPTEN_ROOT OUTPUT_VARIABLE SLICECAST_EMSCRIPTEN_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
include("${SLICECAST_EMSCRIPTEN_ROOT}/cmake/Modules/Platform/Emscripten.cmake")

if(SLICECAST_EMSCRIPTEN_OF_DEBIAN)
  # Debian's optimiser loads `acorn` from Debian's folder of Node modules, which a Node from
  # elsewhere does not search.
  set(CMAKE_CXX_LINKER_LAUNCHER "${CMAKE_COMMAND};-E;env;NODE_PATH=/usr/share/nodejs")
endif()
