# cmake -D DIRECTORY=... -P forbidden_includes.cmake
# Fails when a header there includes anything but kernels and the few headers that kernels may use: nothing of the
# solver, no container, no stream, no library.
set(allowed "<pinball/kernels/[a-z_]+\\.hpp>|<cmath>|<cstdint>|<cstddef>|<experimental/simd>|<immintrin\\.h>|<omp\\.h>")

file(GLOB headers ${DIRECTORY}/*)
if(NOT headers)
  message(FATAL_ERROR "no files in ${DIRECTORY}")
endif()
set(found)
foreach(header ${headers})
  file(STRINGS ${header} includes REGEX "^[ \t]*#[ \t]*include")
  foreach(line ${includes})
    if(NOT line MATCHES "^[ \t]*#[ \t]*include[ \t]+(${allowed})")
      list(APPEND found "${header}: ${line}")
    endif()
  endforeach()
endforeach()
if(found)
  list(JOIN found "\n" found)
  message(FATAL_ERROR "forbidden includes:\n${found}")
endif()
