# Every header compiles alone and without a warning (included twice: its guard works).
# folder: where the headers lie; name: in <pinball/name/header.hpp>.
function(add_header_check target folder name_of_includes)
  set(sources)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  foreach(header ${headers})
    get_filename_component(name ${header} NAME_WE)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/${name_of_includes}/${name}.cpp)
    set(line "#include <pinball/${name_of_includes}/${header}>\n")
    file(CONFIGURE OUTPUT ${source} CONTENT "${line}${line}" @ONLY)
    list(APPEND sources ${source})
  endforeach()
  add_library(${target} OBJECT ${sources})
  target_link_libraries(${target} PRIVATE ${ARGN} pinball_warnings pinball_codegen)
  target_compile_options(${target} PRIVATE -Werror)
  # Nearly all headers end up reading this one, which takes four fifths of the time. What it includes itself, <functional>
  # above all, is not missed where a header forgets it; the rest and our own headers are.
  target_precompile_headers(${target} PRIVATE <experimental/simd>)
endfunction()

add_header_check(kernel_headers_compile_alone kernels kernels Pinball::kernels)
add_header_check(contact_headers_compile_alone solver/contact contact Pinball::kernels)
add_header_check(solver_headers_compile_alone solver solver
                 Pinball::kernels fmt::fmt PkgConfig::tomlplusplus nlohmann_json::nlohmann_json)
foreach(library contact solver)  # their folders, not the libraries: these need not be built first
  target_include_directories(${library}_headers_compile_alone PRIVATE
                             $<TARGET_PROPERTY:pinball_${library},INTERFACE_INCLUDE_DIRECTORIES>)
endforeach()
target_include_directories(solver_headers_compile_alone PRIVATE
                           $<TARGET_PROPERTY:pinball_contact,INTERFACE_INCLUDE_DIRECTORIES>)

# The C interface as C, by a compiler that knows no later C.
enable_language(C)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/headers/contact.c CONTENT
     "#include <pinball/contact/contact.h>\n#include <pinball/contact/contact.h>\n" @ONLY)
add_library(contact_header_compiles_as_c OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers/contact.c)
target_include_directories(contact_header_compiles_as_c PRIVATE
                           $<TARGET_PROPERTY:pinball_contact,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_options(contact_header_compiles_as_c PRIVATE -std=c99 -Wall -Wextra -Wpedantic -Werror)

# Kernels include kernels and a few headers of the language, contact those and what moves no file; the tests with
# "found" show that the others can fail.
set(check ${CMAKE_CURRENT_SOURCE_DIR}/forbidden_includes.cmake)
function(add_include_test test folder rules)
  add_test(NAME ${test} COMMAND ${CMAKE_COMMAND} -D DIRECTORY=${PROJECT_SOURCE_DIR}/${folder} -D RULES=${rules} -P ${check})
endfunction()
add_include_test(forbidden_includes kernels kernels)
add_include_test(forbidden_includes_of_contact solver/contact contact)
add_include_test(forbidden_includes_are_found solver/contact kernels)
add_include_test(forbidden_includes_of_contact_are_found solver contact)
set_tests_properties(forbidden_includes_are_found forbidden_includes_of_contact_are_found PROPERTIES WILL_FAIL TRUE)

# The kernels as device code, where a compiler for it is found.
find_package(CUDAToolkit QUIET)
if(CUDAToolkit_NVCC_EXECUTABLE)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/kernels/*.hpp)
  list(TRANSFORM headers PREPEND "#include <pinball/")
  list(JOIN headers ">\n" all_headers)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/device/kernel_headers.hpp CONTENT "${all_headers}>\n" @ONLY)
  add_test(NAME kernels_compile_with_nvcc
    COMMAND ${CUDAToolkit_NVCC_EXECUTABLE} -std=c++20 -ccbin ${CMAKE_CXX_COMPILER} -Werror all-warnings
            -I$<TARGET_PROPERTY:pinball_kernels,INTERFACE_INCLUDE_DIRECTORIES> -I${CMAKE_CURRENT_BINARY_DIR}/device
            -c ${CMAKE_CURRENT_SOURCE_DIR}/kernels_on_device.cu -o ${CMAKE_CURRENT_BINARY_DIR}/device/kernels.o)
endif()
