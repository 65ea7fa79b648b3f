# The files of a page as a source of the library: pinball_page_resources(VARIABLE) sets VARIABLE to its path.
#
# dygraphs draws the curves (https://dygraphs.com, MIT; Debian: libjs-dygraphs): several curves against time, values under
# the pointer, zoom, in 131 kB that a page has in it; Chart.js, which Debian also has, is 200 kB and made for other charts.
# Where it is not found the program is built all the same, and its pages have tables in place of curves.
find_file(PINBALL_DYGRAPHS dygraph.min.js
          PATHS /usr/share/javascript/dygraphs /usr/share/nodejs/dygraphs/dist
          DOC "dygraph.min.js, for the curves of the pages that runs leave")
if(NOT PINBALL_DYGRAPHS)
  message(STATUS "No dygraph.min.js (Debian: libjs-dygraphs): the pages of runs have no curves")
endif()

function(pinball_page_resources variable)
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/*.html ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/*.css
       ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/*.js)
  if(PINBALL_DYGRAPHS)
    get_filename_component(folder ${PINBALL_DYGRAPHS} DIRECTORY)
    list(APPEND files ${PINBALL_DYGRAPHS} ${folder}/dygraph.min.css)
  endif()
  set(PINBALL_PAGE_RESOURCES)
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    if(file MATCHES "\\.js$" AND text MATCHES "</script|<!--" OR text MATCHES "\\)---page\"")
      message(FATAL_ERROR "${file}: cannot stand in a page")
    endif()
    string(REGEX REPLACE "(/\\*|//)# sourceMappingURL=[^\n]*" "" text "${text}")
    get_filename_component(name ${file} NAME)
    string(APPEND PINBALL_PAGE_RESOURCES "\n      {\"${name}\", R\"---page(${text})---page\"},")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/page_resources.cpp)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/resources.cpp.in ${source} @ONLY)
  set(${variable} ${source} PARENT_SCOPE)
endfunction()
