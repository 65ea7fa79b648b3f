# cmake -D DIRECTORY=... -D RULES=kernels|contact -P forbidden_includes.cmake
# Fails when a file there includes what it may not. Kernels: anything but kernels and the few headers that they may use,
# so nothing of contact or solver, no container, no stream, no library. Contact: anything but contact, kernels and the
# headers of the language and the system, less those that open files or write to the terminal.
set(rules_kernels "<pinball/kernels/[a-z_]+\\.hpp>|<cmath>|<cstdint>|<cstddef>|<experimental/simd>|<immintrin\\.h>|<omp\\.h>")
set(rules_contact "<pinball/version\\.h>|<pinball/(kernels|contact)/[a-z_]+\\.h(pp)?>|<sys/mman\\.h>|<std(def|int)\\.h>|<[a-z_]+>")
set(never "<(cstdio|iostream|fstream|filesystem|print)>")
set(allowed "${rules_${RULES}}")
if(NOT allowed)
  message(FATAL_ERROR "no rules named \"${RULES}\"")
endif()

file(GLOB headers ${DIRECTORY}/*.h ${DIRECTORY}/*.hpp ${DIRECTORY}/*.cpp)
if(NOT headers)
  message(FATAL_ERROR "no files in ${DIRECTORY}")
endif()
set(found)
foreach(header ${headers})
  file(STRINGS ${header} includes REGEX "^[ \t]*#[ \t]*include")
  foreach(line ${includes})
    if(NOT line MATCHES "^[ \t]*#[ \t]*include[ \t]+(${allowed})" OR line MATCHES "${never}")
      list(APPEND found "${header}: ${line}")
    endif()
  endforeach()
endforeach()
if(found)
  list(JOIN found "\n" found)
  message(FATAL_ERROR "forbidden includes:\n${found}")
endif()
