# Every header compiles alone and without a warning (included twice: its guard works).
function(add_header_check target directory)
  set(sources)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/${directory} ${PROJECT_SOURCE_DIR}/${directory}/*.hpp)
  foreach(header ${headers})
    get_filename_component(name ${header} NAME_WE)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/${directory}/${name}.cpp)
    set(line "#include <pinball/${directory}/${header}>\n")
    file(CONFIGURE OUTPUT ${source} CONTENT "${line}${line}" @ONLY)
    list(APPEND sources ${source})
  endforeach()
  add_library(${target} OBJECT ${sources})
  target_link_libraries(${target} PRIVATE ${ARGN} pinball_warnings pinball_codegen)
  target_compile_options(${target} PRIVATE -Werror)
endfunction()

add_header_check(kernel_headers_compile_alone kernels Pinball::kernels)
add_header_check(solver_headers_compile_alone solver
                 Pinball::kernels fmt::fmt PkgConfig::tomlplusplus nlohmann_json::nlohmann_json)
target_include_directories(solver_headers_compile_alone PRIVATE  # not the library: it need not be built first
                           $<TARGET_PROPERTY:pinball_solver,INTERFACE_INCLUDE_DIRECTORIES>)

# Kernels include kernels and a few headers of the language; the second test shows that the first can fail.
set(check ${CMAKE_CURRENT_SOURCE_DIR}/forbidden_includes.cmake)
add_test(NAME forbidden_includes COMMAND ${CMAKE_COMMAND} -D DIRECTORY=${PROJECT_SOURCE_DIR}/kernels -P ${check})
add_test(NAME forbidden_includes_are_found COMMAND ${CMAKE_COMMAND} -D DIRECTORY=${PROJECT_SOURCE_DIR}/solver -P ${check})
set_tests_properties(forbidden_includes_are_found PROPERTIES WILL_FAIL TRUE)

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
