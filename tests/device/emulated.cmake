file(GLOB gpu_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solver/device/gpu/*.cu ${PROJECT_SOURCE_DIR}/solver/boundary/space/*.cu)
# They say which devices there are: a program that has its own takes none of the archive.
set(which_devices ${PROJECT_SOURCE_DIR}/solver/device/devices.cpp ${PROJECT_SOURCE_DIR}/solver/device/device_run.cpp)
set_source_files_properties(${which_devices} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
                            COMPILE_DEFINITIONS "PINBALL_WITH_MOCK;PINBALL_WITH_CUDA")

# The sources for GPUs on a processor (emulated/emulated_device.hpp): what they do is tested where there is no GPU, by the
# program of the tests in device/, which has one device more than others. GCC alone clears what lies between the members of
# parameters, and sanitizers know nothing of stacks that take turns.
if(NOT PINBALL_DEVICE STREQUAL "none" OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR PINBALL_SANITIZE)
  return()
endif()
set(emulated ${CMAKE_CURRENT_SOURCE_DIR}/device/emulated)
set(emulated_sources ${gpu_sources} ${CMAKE_CURRENT_SOURCE_DIR}/device/exec.cu ${emulated}/planted_faults_test.cpp)
set_source_files_properties(${emulated_sources} PROPERTIES
  LANGUAGE CXX SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON
  # Names of their own, as those of the mock's kernels have (solver/CMakeLists.txt).
  COMPILE_DEFINITIONS "__CUDACC__;PINBALL_OUTLINED=[[gnu::noinline,gnu::abi_tag(\"emulated\")]] inline"
  COMPILE_OPTIONS "-include;cuda_runtime.h;-Wno-unknown-pragmas")
add_library(emulated_gpu OBJECT ${gpu_sources} ${emulated}/emulated_device.cpp)
target_include_directories(emulated_gpu PUBLIC ${emulated})
target_link_libraries(emulated_gpu PRIVATE Pinball::kernels pinball_warnings pinball_codegen pinball_test_optimisation)
set_source_files_properties(${emulated}/emulated_device.cpp PROPERTIES COMPILE_OPTIONS -U_FORTIFY_SOURCE)  # it would take a change of stacks for a fault

target_sources(device_tests PRIVATE ${which_devices} ${emulated}/planted_faults_test.cpp ${emulated}/emulated_scenes_test.cpp
                                    ${emulated}/standing_lists_test.cpp ${emulated}/ranks_on_gpus_test.cpp
                                    $<TARGET_OBJECTS:emulated_gpu>)
target_include_directories(device_tests PRIVATE ${emulated})

# The execution layer beside that of the host, in several orders of threads.
add_executable(emulated_exec device/exec.cu ${emulated}/emulated_device.cpp)
target_include_directories(emulated_exec PRIVATE ${emulated})
target_link_libraries(emulated_exec PRIVATE Pinball::kernels pinball_warnings pinball_codegen pinball_test_optimisation)
foreach(order forward reverse 7)
  add_test(NAME emulated_exec_${order} COMMAND emulated_exec)
  set_tests_properties(emulated_exec_${order} PROPERTIES LABELS device ENVIRONMENT PINBALL_EMULATED_ORDER=${order})
endforeach()
