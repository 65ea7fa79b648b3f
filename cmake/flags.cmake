# Two interface targets carry the compiler flags, so that a host that embeds the library is not forced to share them.
#   pinball_warnings  for every translation unit of this project: warnings, and where includes of the tree begin
#   pinball_codegen   instruction set and floating-point contract of the kernels
include(CheckCXXCompilerFlag)

add_library(pinball_warnings INTERFACE)
target_include_directories(pinball_warnings INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(pinball_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wunused)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of its own AVX-512 header inlined into our code (GCC bug 105593).
  target_compile_options(pinball_warnings INTERFACE -Wno-maybe-uninitialized -Wno-uninitialized)
endif()
if(PINBALL_WERROR)
  target_compile_options(pinball_warnings INTERFACE -Werror)
endif()

set(features contact boundary_conditions plasticity erosion bulk_viscosity hourglass resting)
foreach(feature IN LISTS PINBALL_WITHOUT)
  if(NOT feature IN_LIST features)
    message(FATAL_ERROR "PINBALL_WITHOUT has \"${feature}\"; it may have: ${features}")
  endif()
endforeach()

set(known_instruction_sets native avx2 scalar)
if(NOT PINBALL_SIMD IN_LIST known_instruction_sets)
  message(FATAL_ERROR "PINBALL_SIMD is \"${PINBALL_SIMD}\"; it must be one of: ${known_instruction_sets}")
endif()

add_library(pinball_codegen INTERFACE)
# The same in every build, so that builds differ in the instruction set alone.
# No -ffast-math: NaN and infinity must stay visible, and sums keep their order.
target_compile_options(pinball_codegen INTERFACE -fno-math-errno -fno-trapping-math)
target_compile_options(pinball_codegen INTERFACE -ffp-contract=$<IF:$<BOOL:${PINBALL_CONTRACT}>,fast,off>)

if(PINBALL_WITHOUT)
  list(JOIN PINBALL_WITHOUT "," left_out)
  target_compile_definitions(pinball_codegen INTERFACE PINBALL_WITHOUT="${left_out}")
endif()

# Compilers split 512-bit vectors in two for some processors unless told that they are wanted.
check_cxx_compiler_flag(-mprefer-vector-width=512 PINBALL_HAS_PREFER_VECTOR_WIDTH)

if(PINBALL_SIMD STREQUAL "avx2")
  target_compile_options(pinball_codegen INTERFACE -march=haswell)
elseif(PINBALL_NATIVE)
  target_compile_options(pinball_codegen INTERFACE -march=native)
  if(PINBALL_HAS_PREFER_VECTOR_WIDTH)
    target_compile_options(pinball_codegen INTERFACE -mprefer-vector-width=512)
  endif()
endif()
if(PINBALL_SIMD STREQUAL "scalar")
  # One lane per kernel call and no vectorizer of the compiler. The processor's other instructions (fused multiply-add)
  # stay, so that a comparison with this build shows the vectors and nothing else.
  target_compile_definitions(pinball_codegen INTERFACE PINBALL_SIMD_WIDTH_BYTES=0)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(pinball_codegen INTERFACE -fno-vectorize -fno-slp-vectorize)
  else()
    target_compile_options(pinball_codegen INTERFACE -fno-tree-vectorize -fno-tree-slp-vectorize)
  endif()
endif()

if(PINBALL_SANITIZE)
  # The first finding ends the program, so that a test cannot pass over it.
  target_compile_options(pinball_codegen INTERFACE -fsanitize=${PINBALL_SANITIZE} -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND PINBALL_SANITIZE MATCHES "address")
    # With these checks of the hundreds of temporaries in a kernel over packs GCC 12 needs minutes for one
    # kernel, without them 3 s: scopes of locals, and null, alignment and size at each member access.
    target_compile_options(pinball_codegen INTERFACE -fno-sanitize-address-use-after-scope
                           -fno-sanitize=null,alignment,object-size)
  endif()
  target_link_options(pinball_codegen INTERFACE -fsanitize=${PINBALL_SANITIZE})
endif()
