# What cpack makes: a package for Debian (preset `package`) and an archive of the sources, which builds without a network.
# Debian has a game of the name pinball: the package, and with it the folder of its documents, is called otherwise.
set(CPACK_PACKAGE_NAME pinball-solver)
set(CPACK_PACKAGE_VENDOR "The Pinball authors")
set(PINBALL_PACKAGE_CONTACT "The Pinball authors <pinball-solver@packages.invalid>" CACHE STRING
    "Name and address of who answers for a package")
set(CPACK_PACKAGE_CONTACT ${PINBALL_PACKAGE_CONTACT})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "explicit dynamics of solids in contact and impact")
set(CPACK_PACKAGE_DESCRIPTION
"Pinball computes how solids hit, press and break through each other: an
explicit finite-element solver for hexahedra under large deformation, with
plasticity and erosion, around the pinball contact algorithm of Belytschko,
Liu and Neal.
.
It holds the program with its scenes and documents, shared libraries and
headers for codes in C, C++ and Fortran, and a Python module. Of libraries for
several instruction sets the dynamic loader takes the widest that the
processor has.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# What programs and libraries load is found by dpkg-shlibdeps; what a host that is compiled needs has to be named, as has
# what Python loads.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${pinball_library_directory})
set(control ${PROJECT_SOURCE_DIR}/packaging/debian)
set(shlibs ${PROJECT_BINARY_DIR}/debian/shlibs)
file(WRITE ${shlibs} "")
set(declared ${pinball_libraries})
if(TARGET pinball_program_shared)
  list(APPEND declared program)
endif()
foreach(name IN LISTS declared)
  file(APPEND ${shlibs}
       "libpinball-${name} ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${CPACK_PACKAGE_NAME} (>= ${PROJECT_VERSION})\n")
endforeach()
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${shlibs} ${control}/triggers ${control}/postinst ${control}/prerm)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-vtk9 | python3-paraview, python3-matplotlib, xvfb")  # for `pinball view`
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, pkg-config, cmake, paraview, ffmpeg")
if(TARGET pinball_python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
      "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}~), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")
endif()
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian/documents.cmake)

set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME pinball-${PROJECT_VERSION})
string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" tree "${PROJECT_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${tree}/build[^/]*/" "^${tree}/out/" "^${tree}/\\.git(/|$)" "/__pycache__/" "~$")
include(CPack)
