# Two interface targets carry the compiler flags, so that a host that embeds the library is not forced to share them.
#   pinball_warnings  for every translation unit of this project: warnings, where includes of the tree begin, and what makes
#                     the compiler itself faster
#   pinball_codegen   instruction set and floating-point contract of the kernels
# The options are those of the host's compiler; what a device's takes stands at the end.
include(CheckCXXCompilerFlag)

# Interface options of a target for C and C++ alone.
function(pinball_options target)
  foreach(option IN LISTS ARGN)
    target_compile_options(${target} INTERFACE "$<$<NOT:$<COMPILE_LANGUAGE:CUDA,HIP>>:${option}>")
  endforeach()
endfunction()

add_library(pinball_warnings INTERFACE)
target_include_directories(pinball_warnings INTERFACE ${PROJECT_SOURCE_DIR})
pinball_options(pinball_warnings -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wunused)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # It looks for memory that it can use again when it has 1 GB, not 128 MB: a tenth less time, a fifth more memory.
  pinball_options(pinball_warnings --param=ggc-min-heapsize=1000000)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of its own AVX-512 header inlined into our code (GCC bug 105593).
  pinball_options(pinball_warnings -Wno-maybe-uninitialized -Wno-uninitialized)
endif()
if(PINBALL_WERROR)
  pinball_options(pinball_warnings -Werror)
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
pinball_options(pinball_codegen -fno-math-errno -fno-trapping-math)
pinball_options(pinball_codegen -ffp-contract=$<IF:$<BOOL:${PINBALL_CONTRACT}>,fast,off>)

if(PINBALL_WITHOUT)
  list(JOIN PINBALL_WITHOUT "," left_out)
  target_compile_definitions(pinball_codegen INTERFACE PINBALL_WITHOUT="${left_out}")
endif()

# Compilers split 512-bit vectors in two for some processors unless told that they are wanted.
check_cxx_compiler_flag(-mprefer-vector-width=512 PINBALL_HAS_PREFER_VECTOR_WIDTH)

if(PINBALL_SIMD STREQUAL "avx2")
  pinball_options(pinball_codegen -march=haswell)
elseif(PINBALL_NATIVE)
  pinball_options(pinball_codegen -march=native)
  if(PINBALL_HAS_PREFER_VECTOR_WIDTH)
    pinball_options(pinball_codegen -mprefer-vector-width=512)
  endif()
endif()
if(PINBALL_SIMD STREQUAL "scalar")
  # One lane per kernel call and no vectorizer of the compiler. The processor's other instructions (fused multiply-add)
  # stay, so that a comparison with this build shows the vectors and nothing else.
  target_compile_definitions(pinball_codegen INTERFACE PINBALL_SIMD_WIDTH_BYTES=0)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    pinball_options(pinball_codegen -fno-vectorize -fno-slp-vectorize)
  else()
    pinball_options(pinball_codegen -fno-tree-vectorize -fno-tree-slp-vectorize)
  endif()
endif()

if(PINBALL_SANITIZE)
  # The first finding ends the program, so that a test cannot pass over it.
  pinball_options(pinball_codegen -fsanitize=${PINBALL_SANITIZE} -fno-sanitize-recover=all
                  -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND PINBALL_SANITIZE MATCHES "address")
    # With these checks of the hundreds of temporaries in a kernel over packs GCC 12 needs minutes for one
    # kernel, without them 3 s: scopes of locals, and null, alignment and size at each member access.
    pinball_options(pinball_codegen -fno-sanitize-address-use-after-scope
                    -fno-sanitize=null,alignment,object-size)
  endif()
  target_link_options(pinball_codegen INTERFACE -fsanitize=${PINBALL_SANITIZE})
endif()

if(NOT PINBALL_DEVICE STREQUAL "none")
  string(TOUPPER ${PINBALL_DEVICE} device)
  target_compile_definitions(pinball_codegen INTERFACE PINBALL_WITH_${device})
  # The same loops on the host as elsewhere, so that a function is the same wherever it is compiled (kernels/exec).
  target_compile_options(pinball_codegen INTERFACE
                         "$<$<COMPILE_LANGUAGE:CUDA,HIP>:-std=c++20>"  # CMake 3.25 does not know it of nvcc
                         "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=${OpenMP_CXX_FLAGS};-fmad=$<IF:$<BOOL:${PINBALL_CONTRACT}>,true,false>>"
                         "$<$<COMPILE_LANGUAGE:HIP>:-ffp-contract=$<IF:$<BOOL:${PINBALL_CONTRACT}>,fast,off>>")
  if(PINBALL_WERROR)
    target_compile_options(pinball_warnings INTERFACE "$<$<COMPILE_LANGUAGE:CUDA>:-Werror=all-warnings>"
                                                      "$<$<COMPILE_LANGUAGE:HIP>:-Werror>")
  endif()
endif()
