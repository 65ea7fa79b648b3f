# Libraries by which meshes of other programs are read, each if it is there: without it, such a file is an error that says
# what to install.
#   pinball_mesh_modules      names for pkg-config
#   pinball_mesh_libraries    targets
set(pinball_mesh_modules)
set(pinball_mesh_libraries)
foreach(module netcdf pugixml zlib)  # Exodus; VTK's XML; and its compressed data
  pkg_check_modules(${module} QUIET IMPORTED_TARGET ${module})
  if(TARGET PkgConfig::${module})
    list(APPEND pinball_mesh_modules ${module})
    list(APPEND pinball_mesh_libraries PkgConfig::${module})
    # One source alone includes its headers; those of zlib also the one that packs surfaces for pages.
    get_target_property(pinball_${module}_includes PkgConfig::${module} INTERFACE_INCLUDE_DIRECTORIES)
    set_target_properties(PkgConfig::${module} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "")
  else()
    message(STATUS "Without ${module}: some meshes of other programs cannot be read")
  endif()
endforeach()
