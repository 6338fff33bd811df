# Third-party libraries, one target each: slicecast_stb, slicecast_rapidjson, slicecast_cli11,
# slicecast_sdl2. None is copied into the project.

# systemHeaders(TARGET FOLDER HEADER): a header-only library in FOLDER of the system's include path.
# A cross compiler must not use that path, so it gets a folder with a link to this one library.
function(systemHeaders target folder header)
  find_path(SLICECAST_INCLUDE_${folder} ${folder}/${header} NO_CMAKE_FIND_ROOT_PATH
    PATHS /usr/include /usr/local/include /opt/homebrew/include /opt/local/include)
  add_library(${target} INTERFACE)
  if(NOT SLICECAST_INCLUDE_${folder})
    message(FATAL_ERROR "${folder}/${header} was not found; tools/setup installs it, or set SLICECAST_INCLUDE_${folder} to the folder that holds ${folder}.")
  endif()
  set(include ${SLICECAST_INCLUDE_${folder}})
  if(CMAKE_CROSSCOMPILING)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/system-headers/${folder})
    file(CREATE_LINK ${include}/${folder} ${PROJECT_BINARY_DIR}/system-headers/${folder}/${folder} SYMBOLIC)
    set(include ${PROJECT_BINARY_DIR}/system-headers/${folder})
  endif()
  target_include_directories(${target} SYSTEM INTERFACE ${include})
endfunction()

systemHeaders(slicecast_stb stb stb_image.h)
systemHeaders(slicecast_rapidjson rapidjson reader.h)
if(NOT EMSCRIPTEN AND NOT SLICECAST_LIBRARY_ONLY)
  systemHeaders(slicecast_cli11 CLI CLI.hpp)
endif()

# SDL2: the system's. For a page, Emscripten's own port, which a current SDK fetches (-sUSE_SDL=2).
# Debian's Emscripten cannot fetch it: there the few files that a page uses are compiled from the
# source that tools/setup has fetched. SDL comes with a configuration for Emscripten.
set(SLICECAST_SDL2_WASM "$ENV{SLICECAST_SDL2_WASM}" CACHE PATH "The source of SDL2; empty for Emscripten's port")
if(NOT SLICECAST_HASHES_ONLY AND NOT SLICECAST_LIBRARY_ONLY)
  add_library(slicecast_sdl2 INTERFACE)
  if(NOT EMSCRIPTEN)
    find_package(Threads REQUIRED)
    find_package(SDL2 REQUIRED)
    target_link_libraries(slicecast_sdl2 INTERFACE SDL2::SDL2)
  elseif(SLICECAST_SDL2_WASM)
    include(SdlSurfaces)
    target_link_libraries(slicecast_sdl2 INTERFACE slicecast_sdl2_surfaces)
  elseif(SLICECAST_EMSCRIPTEN_OF_DEBIAN)
    message(FATAL_ERROR "Debian's Emscripten has no SDL2: run `source tools/setup page` first.")
  else()
    target_compile_options(slicecast_sdl2 INTERFACE -sUSE_SDL=2)
    target_link_options(slicecast_sdl2 INTERFACE -sUSE_SDL=2)
  endif()
endif()
