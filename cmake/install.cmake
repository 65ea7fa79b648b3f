# What cmake --install copies. Components: development (headers, package files, Fortran module), archives, libraries
# (shared), program (with its scenes) and python (python/CMakeLists.txt), so that a distribution can make its packages of
# them.
include(CMakePackageConfigHelpers)

set(pinball_libraries contact)
if(PINBALL_SOLVER)
  list(APPEND pinball_libraries solver)
endif()
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/Pinball)
set(with_archives TRUE)
if(BUILD_SHARED_LIBS AND NOT PINBALL_STATIC_AND_SHARED)
  set(with_archives FALSE)
endif()

foreach(name IN LISTS pinball_libraries)
  if(with_archives)
    install(TARGETS pinball_${name} EXPORT PinballArchives ARCHIVE COMPONENT archives)
  endif()
  if(TARGET pinball_${name}_shared)
    install(TARGETS pinball_${name}_shared EXPORT PinballLibraries
            LIBRARY COMPONENT libraries)
  endif()
  foreach(level IN LISTS PINBALL_HWCAPS)
    # Only the loader looks here, by the name with the version of the interface.
    install(TARGETS pinball_${name}_${level}
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/${level} COMPONENT libraries NAMELINK_SKIP)
  endforeach()
endforeach()
install(TARGETS pinball_kernels EXPORT PinballKernels)  # nothing to copy: names the target

# Public headers: public_headers.cmake. No other header is installed: their layouts depend on the instruction set that a
# host would compile them for.
install(FILES ${PROJECT_SOURCE_DIR}/solver/contact/pinball_contact.f90 DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pinball/contact
        COMPONENT development)

# find_package(Pinball)
set(exports Kernels)
if(with_archives)
  list(APPEND exports Archives)
endif()
if(TARGET pinball_contact_shared)
  list(APPEND exports Libraries)
endif()
set(component_of_Kernels development)
set(component_of_Archives archives)
set(component_of_Libraries libraries)
foreach(export IN LISTS exports)
  install(EXPORT Pinball${export} NAMESPACE Pinball:: DESTINATION ${package_directory} COMPONENT ${component_of_${export}})
endforeach()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/PinballConfig.cmake.in ${PROJECT_BINARY_DIR}/PinballConfig.cmake
                              INSTALL_DESTINATION ${package_directory} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PinballConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/PinballConfig.cmake ${PROJECT_BINARY_DIR}/PinballConfigVersion.cmake
        DESTINATION ${package_directory} COMPONENT development)

include(cmake/install_pkg_config.cmake)

if(PINBALL_SOLVER)
  file(RELATIVE_PATH libraries_from_program /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${CMAKE_INSTALL_LIBDIR})
  set_target_properties(pinball PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_program}")
  install(TARGETS pinball RUNTIME COMPONENT program)
  if(BUILD_SHARED_LIBS)
    install(TARGETS pinball_program_shared LIBRARY COMPONENT program NAMELINK_SKIP)
    foreach(level IN LISTS PINBALL_HWCAPS)
      install(TARGETS pinball_program_${level}
              LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/${level} COMPONENT program NAMELINK_SKIP)
    endforeach()
  endif()
  # Where the program looks: ../share/pinball/data from its own folder.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/scenes ${PROJECT_SOURCE_DIR}/data/decks ${PROJECT_SOURCE_DIR}/data/materials
                    ${PROJECT_SOURCE_DIR}/data/reference
          DESTINATION share/pinball/data COMPONENT program)
  include(cmake/install_documents.cmake)
  # ../share/pinball/view: what `pinball view` starts.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/view DESTINATION share/pinball COMPONENT program FILES_MATCHING PATTERN *.py)
endif()
# The licence, and the pages with all that they link.
include(cmake/install_pages.cmake)
pinball_install_pages(README.md CHANGELOG.md docs/embedding.md docs/solver_library.md docs/program.md)

# What has to be built before `cmake --install` finds all that it copies: the program alone does not need the shared
# libraries. ./run builds this, too.
add_custom_target(installable)
if(PINBALL_SOLVER)
  add_dependencies(installable pinball)
endif()
foreach(name IN LISTS pinball_libraries)
  if(with_archives)
    add_dependencies(installable pinball_${name})
  endif()
  if(TARGET pinball_${name}_shared)
    add_dependencies(installable pinball_${name}_shared)
  endif()
endforeach()
foreach(level IN LISTS PINBALL_HWCAPS)
  foreach(name IN LISTS pinball_libraries)
    add_dependencies(installable pinball_${name}_${level})
  endforeach()
  if(PINBALL_SOLVER)
    add_dependencies(installable pinball_program_${level})
  endif()
endforeach()
