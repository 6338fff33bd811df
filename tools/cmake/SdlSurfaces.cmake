# What a page uses of SDL2: a surface that holds the picture, and the names of keys. No window, no
# events, no sound, and no copying between surfaces (SDL_LEAN_AND_MEAN). What these files call besides
# is not reached: tools/check-imports.mjs ends a build that reaches it.
enable_language(C)
add_library(slicecast_sdl2_surfaces STATIC
  ${SLICECAST_SDL2_WASM}/src/SDL_error.c
  ${SLICECAST_SDL2_WASM}/src/SDL_list.c
  ${SLICECAST_SDL2_WASM}/src/atomic/SDL_atomic.c
  ${SLICECAST_SDL2_WASM}/src/atomic/SDL_spinlock.c
  ${SLICECAST_SDL2_WASM}/src/cpuinfo/SDL_cpuinfo.c
  ${SLICECAST_SDL2_WASM}/src/stdlib/SDL_malloc.c
  ${SLICECAST_SDL2_WASM}/src/stdlib/SDL_stdlib.c
  ${SLICECAST_SDL2_WASM}/src/stdlib/SDL_string.c
  ${SLICECAST_SDL2_WASM}/src/video/SDL_RLEaccel.c
  ${SLICECAST_SDL2_WASM}/src/video/SDL_pixels.c
  ${SLICECAST_SDL2_WASM}/src/video/SDL_rect.c
  ${SLICECAST_SDL2_WASM}/src/video/SDL_surface.c)
# Headers as the project names them: SDL2/SDL_surface.h.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/system-headers/sdl2)
file(CREATE_LINK ${SLICECAST_SDL2_WASM}/include ${PROJECT_BINARY_DIR}/system-headers/sdl2/SDL2 SYMBOLIC)
target_include_directories(slicecast_sdl2_surfaces SYSTEM
  INTERFACE ${PROJECT_BINARY_DIR}/system-headers/sdl2 PRIVATE ${SLICECAST_SDL2_WASM}/include)
target_compile_definitions(slicecast_sdl2_surfaces PRIVATE SDL_LEAN_AND_MEAN=1)
target_compile_options(slicecast_sdl2_surfaces PRIVATE -Oz -w)
