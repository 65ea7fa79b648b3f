# Two interface targets carry the compiler flags, so that a host that embeds the library is not forced to share them.
#   pinball_warnings  for every translation unit of this project
#   pinball_codegen   instruction set and floating-point contract of the kernels

add_library(pinball_warnings INTERFACE)
target_compile_options(pinball_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wunused)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of its own AVX-512 header inlined into our code (GCC bug 105593).
  target_compile_options(pinball_warnings INTERFACE -Wno-maybe-uninitialized -Wno-uninitialized)
endif()
if(PINBALL_WERROR)
  target_compile_options(pinball_warnings INTERFACE -Werror)
endif()

add_library(pinball_codegen INTERFACE)
# No -ffast-math: NaN and infinity must stay visible, and sums keep their order.
target_compile_options(pinball_codegen INTERFACE -fno-math-errno -fno-trapping-math -ffp-contract=fast)
if(PINBALL_SIMD STREQUAL "scalar")
  target_compile_options(pinball_codegen INTERFACE -fno-tree-vectorize -fno-tree-slp-vectorize)
  target_compile_definitions(pinball_codegen INTERFACE PINBALL_SIMD_WIDTH_BYTES=0)
elseif(PINBALL_SIMD STREQUAL "avx2")
  target_compile_options(pinball_codegen INTERFACE -march=haswell)
elseif(PINBALL_NATIVE)
  target_compile_options(pinball_codegen INTERFACE -march=native)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(pinball_codegen INTERFACE -mprefer-vector-width=512)
  endif()
endif()
if(PINBALL_SANITIZE)
  target_compile_options(pinball_codegen INTERFACE -fsanitize=${PINBALL_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(pinball_codegen INTERFACE -fsanitize=${PINBALL_SANITIZE})
endif()
