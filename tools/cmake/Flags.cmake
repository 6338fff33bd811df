# Compiler flags of every target: the target `slicecast_flags`. If only the library is built, flags
# and build type are the user's; only flags that affect the pictures are added.
set(optimise -O2)
option(SLICECAST_WERROR "Warnings are errors" OFF)
set(warnings -Wall -Wextra -Wpedantic -Wshadow)
if(SLICECAST_WERROR)
  list(APPEND warnings -Werror)
endif()
if(SLICECAST_LIBRARY_ONLY)
  set(optimise "")
  set(warnings "")
endif()
set(SLICECAST_OPTIMISE "${optimise}" CACHE STRING "Optimisation level of the compiler")
set(SLICECAST_MARCH "" CACHE STRING "Instruction set; used on x86-64 only")
option(SLICECAST_ASSERTS "Keep assert()" ON)
option(SLICECAST_SANITIZE "Stop at the first undefined behaviour (clang)" OFF)
option(SLICECAST_WASM_SIMD "WebAssembly with SIMD" ON)

if(NOT SLICECAST_LIBRARY_ONLY)
  # Every flag is listed here, so no build type adds its own.
  set(CMAKE_BUILD_TYPE "" CACHE STRING "Not used: see SLICECAST_OPTIMISE" FORCE)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  find_program(SLICECAST_CCACHE ccache)
  if(SLICECAST_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${SLICECAST_CCACHE}")
  endif()
endif()

add_library(slicecast_flags INTERFACE)
target_compile_features(slicecast_flags INTERFACE cxx_std_20)
target_compile_options(slicecast_flags INTERFACE
  ${SLICECAST_OPTIMISE}
  ${warnings}
  # Pictures and states have the same bytes from every compiler: no fused multiply-add. errno of
  # sqrt is never read.
  -ffp-contract=off -fno-math-errno)
if(warnings AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 at -O3 takes "text" + std::string for a copy onto itself (its bug 105651).
  target_compile_options(slicecast_flags INTERFACE -Wno-restrict)
endif()
if(warnings AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_UNITY_BUILD)
  # In a unity build the .cpp files are included, and g++ takes a struct of one for that of a header.
  target_compile_options(slicecast_flags INTERFACE -Wno-subobject-linkage)
endif()
if(SLICECAST_MARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  target_compile_options(slicecast_flags INTERFACE -march=${SLICECAST_MARCH})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ 12 fuses a multiplication with an alternating addition and subtraction (vfmaddsub)
    # although -ffp-contract=off forbids it.
    target_compile_options(slicecast_flags INTERFACE -mno-fma)
  endif()
endif()
if(NOT SLICECAST_ASSERTS)
  target_compile_definitions(slicecast_flags INTERFACE NDEBUG)
endif()
if(SLICECAST_SANITIZE)
  # float-cast-overflow and float-divide-by-zero are not part of "undefined"; clang alone sees the
  # first.
  set(sanitizers -fsanitize=address,undefined,float-cast-overflow,float-divide-by-zero)
  target_compile_options(slicecast_flags INTERFACE ${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1
    -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/tools/cmake/sanitizer-ignore.txt)
  target_link_options(slicecast_flags INTERFACE ${sanitizers})
  # The fuzzers (tests/fuzz) see which ways through the code an input takes.
  target_compile_options(slicecast_flags INTERFACE -fsanitize=fuzzer-no-link)
  # Long random tests take a tenth of their usual amount here.
  target_compile_definitions(slicecast_flags INTERFACE SLICECAST_SANITIZED=1)
endif()
if(EMSCRIPTEN)
  # What a page loads is kept small: optimised as a whole when it is linked, and with a small
  # allocator. One thread needs no guards about its statics.
  target_compile_options(slicecast_flags INTERFACE -flto -fno-exceptions -fno-rtti -fno-threadsafe-statics)
  target_link_options(slicecast_flags INTERFACE ${SLICECAST_OPTIMISE} -flto -fno-exceptions -sMALLOC=emmalloc)
  if(SLICECAST_WASM_SIMD)
    # Browsers that have SIMD have the other two as well.
    target_compile_options(slicecast_flags INTERFACE -msimd128 -mnontrapping-fptoint -msign-ext)
  else()
    # Older browsers have none of what compilers have come to take for granted.
    target_compile_options(slicecast_flags INTERFACE -mcpu=mvp)
  endif()
endif()

# Additional warnings for the product's sources: no number loses bits silently. Not for tests, which
# compare and index a lot.
add_library(slicecast_strict INTERFACE)
if(NOT SLICECAST_LIBRARY_ONLY)
  target_compile_options(slicecast_strict INTERFACE -Wconversion -Wno-sign-conversion)
endif()

# For parts that run once: smaller code lets the page load sooner.
add_library(slicecast_small INTERFACE)
if(EMSCRIPTEN)
  target_compile_options(slicecast_small INTERFACE -Oz)
endif()
