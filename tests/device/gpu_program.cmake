# The program with kernels for a GPU, by nvcc, of the other objects of this build: it is made by the test that runs it, in
# place of a second build of all (the preset cuda). What the assembler says of each kernel is kept beside its object.
if(NOT PINBALL_DEVICE STREQUAL "none" OR NOT CUDAToolkit_NVCC_EXECUTABLE OR NOT TARGET pinball OR PINBALL_SANITIZE)
  return()
endif()
set(work ${CMAKE_CURRENT_BINARY_DIR}/gpu_program)
file(MAKE_DIRECTORY ${work})
set(objects)
foreach(source IN LISTS gpu_sources)
  get_filename_component(name ${source} NAME_WE)
  add_custom_command(OUTPUT ${work}/${name}.o DEPENDS ${source} DEPFILE ${work}/${name}.d
    COMMAND ${CMAKE_COMMAND} -E rm -f ${work}/${name}.o
    COMMAND ${CUDAToolkit_NVCC_EXECUTABLE} -std=c++20 -O3 -arch=sm_90 -ccbin ${CMAKE_CXX_COMPILER} -Werror all-warnings
            -Xcompiler=-fPIC,-fopenmp -Xptxas -v -I${PROJECT_SOURCE_DIR} -MD -MF ${work}/${name}.d -MT ${work}/${name}.o
            -c ${source} -o ${work}/${name}.o > ${work}/${name}.log 2>&1 || cat ${work}/${name}.log && test -s ${work}/${name}.o
    VERBATIM)
  list(APPEND objects ${work}/${name}.o)
endforeach()
set_source_files_properties(${objects} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
add_executable(pinball_with_gpu EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/solver/program/alone/join_ranks.cpp ${which_devices} ${objects}
                                $<TARGET_OBJECTS:pinball_main>)
target_link_libraries(pinball_with_gpu PRIVATE pinball_program Pinball::kernels pinball_warnings pinball_codegen fmt::fmt CUDA::cudart_static)
add_test(NAME gpu_program COMMAND ${python} ${CMAKE_CURRENT_SOURCE_DIR}/device/gpu_program_test.py ${CMAKE_COMMAND}
                                  ${PROJECT_BINARY_DIR} $<TARGET_FILE:pinball_with_gpu> ${work})
set_tests_properties(gpu_program PROPERTIES LABELS "device;slow" TIMEOUT 1200 COST 100)
