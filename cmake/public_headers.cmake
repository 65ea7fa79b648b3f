# Paths by which hosts include headers: <pinball/solver/simulation.hpp>, <pinball/contact/contact.h>,
# <pinball/kernels/simd.hpp>. The project's own sources use none of them: "name.hpp" in the same room, <room/name.hpp> from
# the top of the tree elsewhere, and public headers paths from where they lie, so that they hold wherever they are put.
#
# In the build tree such a path is a file of one line that includes the header where it lies, so that a host which takes
# the sources in (add_subdirectory) sees what is public and nothing else. Installed, headers lie as they do here,
# below include/pinball; what hosts include by another path is a file of one line, too.
set(pinball_host_include ${PROJECT_BINARY_DIR}/include)

#   pinball_public_headers(FOLDER [AS FOLDER_OF_HOSTS])
# All headers that lie directly in FOLDER are public, by the path of the same name, and by AS if it is given.
function(pinball_public_headers folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "AS" "")
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  foreach(header IN LISTS headers)
    get_filename_component(name ${header} NAME)
    foreach(place IN ITEMS ${folder} ${arg_AS})
      pinball_forward(${pinball_host_include}/pinball/${place}/${name} ${header})
    endforeach()
    if(arg_AS AND PINBALL_INSTALL)
      pinball_install_forward(${arg_AS}/${name} ${folder}/${name})
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY pinball_public_headers ${headers})
  if(PINBALL_INSTALL)
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pinball/${folder} COMPONENT development)
  endif()
endfunction()

function(pinball_forward file header)
  file(CONFIGURE OUTPUT ${file} CONTENT "#include \"${header}\"\n" @ONLY)
endfunction()

# Installs PATH, below include/pinball, as a file that includes TARGET, another path there.
function(pinball_install_forward path target)
  get_filename_component(folder ${path} DIRECTORY)
  file(RELATIVE_PATH relative /${folder} /${target})
  pinball_forward(${PROJECT_BINARY_DIR}/installed_include/${path} ${relative})
  install(FILES ${PROJECT_BINARY_DIR}/installed_include/${path} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pinball/${folder}
          COMPONENT development)
endfunction()
