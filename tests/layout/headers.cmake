# Every header compiles alone and without a warning, as a source of this target is compiled.
set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/one_header.cpp)
file(CONFIGURE OUTPUT ${source} CONTENT "" @ONLY)
add_library(compiles_one_header OBJECT ${source})
target_link_libraries(compiles_one_header PRIVATE Pinball::kernels fmt::fmt PkgConfig::tomlplusplus nlohmann_json::nlohmann_json Eigen3::Eigen
                      pinball_warnings pinball_codegen)
set_target_properties(compiles_one_header PROPERTIES EXPORT_COMPILE_COMMANDS ON)
set(headers_alone ${python} ${CMAKE_CURRENT_SOURCE_DIR}/layout/headers_alone_test.py ${CMAKE_CURRENT_BINARY_DIR}/headers
                  ${CMAKE_CXX_COMPILER} ${PROJECT_BINARY_DIR})
add_test(NAME headers_compile_alone COMMAND ${headers_alone})
add_test(NAME headers_compile_each_alone COMMAND ${headers_alone} each)
set_tests_properties(headers_compile_alone PROPERTIES LABELS layout)
set_tests_properties(headers_compile_each_alone PROPERTIES LABELS "layout;slow")
set_tests_properties(headers_compile_alone headers_compile_each_alone PROPERTIES
  PROCESSORS 2 TIMEOUT 1800 COST 150 RESOURCE_LOCK headers_alone)

# All public headers by the paths that hosts use, with nothing else of the tree in reach.
get_property(headers GLOBAL PROPERTY pinball_public_headers)
list(TRANSFORM headers REPLACE "^${PROJECT_SOURCE_DIR}/(.*)$" "#include <pinball/\\1>")
list(JOIN headers "\n" lines)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/headers/hosts.cpp CONTENT
     "${lines}\n#include <pinball/contact/contact.h>\n#include <pinball/contact/embedded_contact.hpp>\n#include <pinball/version.h>\n" @ONLY)
add_library(public_headers_compile_for_hosts OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers/hosts.cpp)
target_link_libraries(public_headers_compile_for_hosts PRIVATE Pinball::solver pinball_codegen)

# The C interface as C, by a compiler that knows no later C.
enable_language(C)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/headers/contact.c CONTENT
     "#include <pinball/contact/contact.h>\n#include <pinball/contact/contact.h>\n#include <pinball/version.h>\n" @ONLY)
add_library(contact_header_compiles_as_c OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers/contact.c)
target_include_directories(contact_header_compiles_as_c PRIVATE ${pinball_host_include})
target_compile_options(contact_header_compiles_as_c PRIVATE -std=c99 -Wall -Wextra -Wpedantic -Werror)

# Includes go down from room to room; the test plants others, which have to be found.
add_test(NAME rooms COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/layout/rooms_test.py)
add_test(NAME function_lengths COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/layout/function_lengths_test.py)
add_test(NAME casts COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/layout/casts_test.py)
add_test(NAME standard_names COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/layout/standard_names_test.py)
add_test(NAME test_names COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/layout/test_names_test.py)
set_tests_properties(rooms function_lengths casts standard_names test_names PROPERTIES LABELS layout)

# The kernels as device code, where a compiler for it is found. Threads are of the host alone.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/kernels/*.hpp)
list(REMOVE_ITEM headers kernels/exec/lost_helpers.hpp kernels/exec/region_failure.hpp)
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>")
list(JOIN headers "\n" all_headers)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/device/kernel_headers.hpp CONTENT "${all_headers}\n" @ONLY)
if(CUDAToolkit_NVCC_EXECUTABLE)
  set(test_device_code ${python} ${CMAKE_CURRENT_SOURCE_DIR}/device/device_code_test.py ${CUDAToolkit_NVCC_EXECUTABLE}
                       ${CMAKE_CXX_COMPILER} ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/device)
  add_test(NAME marked_functions_compile_with_nvcc COMMAND ${test_device_code} MarkedFunctions)
  set_tests_properties(marked_functions_compile_with_nvcc PROPERTIES LABELS kernels)
  add_test(NAME kernels_compile_with_nvcc COMMAND ${test_device_code} DeviceCode)
  set_tests_properties(kernels_compile_with_nvcc PROPERTIES LABELS "kernels;slow" TIMEOUT 1500 COST 100)
endif()
find_program(PINBALL_HIPCC hipcc)
mark_as_advanced(PINBALL_HIPCC)
if(PINBALL_HIPCC)
  foreach(source kernels exec)
    add_test(NAME ${source}_compile_with_hipcc
      COMMAND ${PINBALL_HIPCC} -std=c++20 --offload-arch=gfx90a -O3 -Werror -I${PROJECT_SOURCE_DIR}
              -I${CMAKE_CURRENT_BINARY_DIR}/device -x hip -c ${CMAKE_CURRENT_SOURCE_DIR}/device/${source}.cu
              -o ${CMAKE_CURRENT_BINARY_DIR}/device/${source}_hip.o)
    set_tests_properties(${source}_compile_with_hipcc PROPERTIES LABELS kernels)
  endforeach()
endif()

# With another compiler than that of the tests, where it is found.
find_program(PINBALL_CLANG NAMES clang++ clang++-14)
mark_as_advanced(PINBALL_CLANG)
if(PINBALL_CLANG)
  add_test(NAME compiles_with_clang COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/layout/clang_test.py ${CMAKE_COMMAND}
                                            ${PINBALL_CLANG} ${CMAKE_CURRENT_BINARY_DIR}/clang)
  set_tests_properties(compiles_with_clang PROPERTIES LABELS "layout;slow" PROCESSORS 2 TIMEOUT 1800)
endif()
