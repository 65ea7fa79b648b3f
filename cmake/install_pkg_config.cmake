# Files for pkg-config. Paths in them count from the file's own folder, so that an installed tree can be moved.
#
# Where archives and shared libraries lie side by side the linker takes the shared one for -lpinball-contact, unless it
# meets a folder before that has the archive alone. So there is one, of links, and pinball-contact.pc names it among the
# private libraries, which are asked for with --static. What it requires comes after it: pinball-contact-library.pc, with
# the folder of both.
set(pkg_config_directory ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pc_prefix /prefix/${pkg_config_directory} /prefix)
set(archives_directory ${CMAKE_INSTALL_LIBDIR}/pinball/archives)
set(pc_contact_requires)
set(pc_solver_requires)
set(pc_runtime)
if(with_archives)
  list(JOIN pinball_mesh_modules ", " pc_solver_requires)
  string(PREPEND pc_solver_requires "pinball-contact, fmt, tomlplusplus, ")
  string(REGEX REPLACE ", $" "" pc_solver_requires "${pc_solver_requires}")
  list(TRANSFORM OpenMP_CXX_LIB_NAMES PREPEND -l OUTPUT_VARIABLE pc_runtime)
  list(APPEND pc_runtime -lstdc++ -lm)
  if(PINBALL_DEVICE STREQUAL "cuda")
    list(APPEND pc_runtime -L${CUDAToolkit_LIBRARY_DIR} -lcudart_static -lrt -ldl -lpthread)
  endif()
  list(JOIN pc_runtime " " pc_runtime)
endif()

#   pinball_pkg_config(FILE [REQUIRES ...] [REQUIRES_PRIVATE ...] [LIBS ...] [LIBS_PRIVATE ...])
function(pinball_pkg_config pc_name)
  cmake_parse_arguments(PARSE_ARGV 1 pc "" "REQUIRES;REQUIRES_PRIVATE;LIBS;LIBS_PRIVATE" "")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/pinball.pc.in ${PROJECT_BINARY_DIR}/${pc_name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc_name}.pc DESTINATION ${pkg_config_directory} COMPONENT development)
endfunction()

foreach(name IN LISTS pinball_libraries)
  set(file pinball-${name})
  if(with_archives AND TARGET pinball_${name}_shared)
    pinball_pkg_config(${file} REQUIRES ${file}-library LIBS_PRIVATE -L\${prefix}/${archives_directory})
    set(archive libpinball-${name}.a)
    file(RELATIVE_PATH target /prefix/${archives_directory} /prefix/${CMAKE_INSTALL_LIBDIR}/${archive})
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/archives)
    file(CREATE_LINK ${target} ${PROJECT_BINARY_DIR}/archives/${archive} SYMBOLIC)
    install(FILES ${PROJECT_BINARY_DIR}/archives/${archive} DESTINATION ${archives_directory} COMPONENT archives)
    string(APPEND file -library)
  endif()
  pinball_pkg_config(${file} REQUIRES_PRIVATE ${pc_${name}_requires} LIBS "-L\${libdir} -lpinball-${name}"
                     LIBS_PRIVATE ${pc_runtime})
endforeach()
