# The libraries of the package.
#
#   pinball_library(NAME [SOURCES ...] [TEXT_SOURCES ...] [API_SOURCES ...] [INTERNALS_OF OTHER ...] [LINKS ...]
#                   [COMPILES_WITH ...] [OF_PROGRAM])
#
# compiles the sources once, position independent and with all symbols hidden that are not marked PINBALL_API, and links
# from these objects
#   pinball_NAME           an archive (of use to this tree's tests, too: inside an archive nothing is hidden)
#   pinball_NAME_shared    with BUILD_SHARED_LIBS or PINBALL_STATIC_AND_SHARED
#   pinball_NAME_LEVEL     for each LEVEL of PINBALL_HWCAPS: the shared library again, compiled for that level, in
#                          glibc-hwcaps/LEVEL beside the first, where the dynamic loader finds it
# Pinball::NAME is the archive, or with BUILD_SHARED_LIBS the shared library.
#
# TEXT_SOURCES read and write text, once in a run: they are optimised less, which compiles them in two thirds of the time.
#
# INTERNALS_OF are libraries whose internals this one uses. The archive links them. A shared library cannot, because they
# are hidden there: it takes in the objects of their SOURCES and TEXT_SOURCES. Their API_SOURCES, which define what they
# export, it leaves out, so that a symbol is exported by one library only.
#
# OF_PROGRAM: no library for hosts, so that there is a shared one only with BUILD_SHARED_LIBS.
#
# LINKS are libraries that archives pass on to whoever links them; COMPILES_WITH is of use to the compiler alone.
if(PINBALL_HWCAPS)
  if(NOT BUILD_SHARED_LIBS OR PINBALL_NATIVE OR NOT PINBALL_SIMD STREQUAL "native")
    message(FATAL_ERROR "PINBALL_HWCAPS needs BUILD_SHARED_LIBS=ON, PINBALL_NATIVE=OFF and PINBALL_SIMD=native: the libraries beside those for other levels must run on every machine")
  endif()
  foreach(level IN LISTS PINBALL_HWCAPS)
    if(NOT level MATCHES "^x86-64-v[234]$")
      message(FATAL_ERROR "PINBALL_HWCAPS has \"${level}\"; it may have x86-64-v2, x86-64-v3, x86-64-v4")
    endif()
  endforeach()
endif()

set(PINBALL_SLOW_HEADERS <algorithm> <experimental/simd> <functional> <memory> <string> <vector>)
set(pinball_library_directory ${PROJECT_BINARY_DIR}/lib)

function(pinball_objects target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LEVEL" "SOURCES;COMPILES_WITH")
  add_library(${target} OBJECT ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE Pinball::kernels pinball_warnings pinball_codegen ${arg_COMPILES_WITH})
  if(arg_LEVEL)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-march=${arg_LEVEL}>)
    if(PINBALL_HAS_PREFER_VECTOR_WIDTH AND arg_LEVEL STREQUAL "x86-64-v4")
      target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-mprefer-vector-width=512>)
    endif()
  endif()
  set_target_properties(${target} PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden CUDA_VISIBILITY_PRESET hidden HIP_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
    UNITY_BUILD ${PINBALL_UNITY} UNITY_BUILD_MODE GROUP)  # pinball_unite_rooms says which
  if(PINBALL_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # it takes what the sources of a unit have for themselves for shared
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>)
  endif()
  # To read these takes longer than to compile most of the sources: once for all libraries of a level and an optimisation.
  # What they define keeps theirs (GCC 12): with those of -O3 a source of text takes 3.1 s at -O1, with those of -O1 2.0 s.
  # Text is compiled at -Og, in two thirds of the time of -O1: decks of 200,000 elements are read as fast.
  # JSON is none of them: whatever unit has read it makes a parser at its end, for literals, 0.4 s, and few use it.
  # That each source includes what it needs is not seen to by it: CMAKE_DISABLE_PRECOMPILE_HEADERS=ON does.
  set(first pinball_contact_objects)
  if(target MATCHES "_text_objects")
    target_compile_options(${target} PRIVATE $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CONFIG:Release>>:-Og>)
    set(first pinball_solver_text_objects)
  endif()
  if(arg_LEVEL)
    string(APPEND first _${arg_LEVEL})
  endif()
  if(target STREQUAL first)
    set(headers ${PINBALL_SLOW_HEADERS})
    if(target MATCHES "_text_objects")
      list(APPEND headers <filesystem> <fmt/format.h> <fstream> <map> <optional> <span> <sstream> <unordered_map>)
    endif()
    target_precompile_headers(${target} PRIVATE ${headers})
  else()
    target_precompile_headers(${target} REUSE_FROM ${first})
  endif()
endfunction()

# Two translation units for each room of these sources, one of its folder and one of all folders in that; one for each
# folder of contact, each format of decks, and all formats of meshes; one of what contact has beside its loops, with the
# base: most sources take longer to read what they include than to compile. With PINBALL_CONTRACT what the compiler fuses
# depends on what it sees together, so that a build with PINBALL_UNITY=OFF may have other last digits. A source with flags
# of its own is compiled by itself.
function(pinball_unite_rooms)
  foreach(source IN LISTS ARGN)
    file(RELATIVE_PATH source_in_room ${CMAKE_CURRENT_SOURCE_DIR} ${source})
    if(source_in_room MATCHES "^(base|contact|contact/algorithm|contact/surface)/[^/]+$")
      set(unit contact)
    elseif(source_in_room MATCHES "^contact/([^/]+)/")
      set(unit contact_${CMAKE_MATCH_1})
    elseif(source_in_room MATCHES "^formats/(abaqus|lsdyna|radioss)/")
      set(unit formats_${CMAKE_MATCH_1})
    elseif(source_in_room MATCHES "^formats/")
      set(unit formats)
    else()
      string(REGEX REPLACE "^([^/]+)/.*" "\\1" unit ${source_in_room})
      if(source_in_room MATCHES "/.*/")
        string(APPEND unit "_folders")
      endif()
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
  endforeach()
endfunction()

function(pinball_link_library target name type)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "OBJECTS;LINKS")
  add_library(${target} ${type})
  foreach(objects IN LISTS arg_OBJECTS)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
  endforeach()
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${pinball_host_include}>)
  target_compile_features(${target} INTERFACE cxx_std_20)
  # Once installed: the OpenMP runtime by name, of the compiler that made the objects, whatever the host compiles with.
  target_link_libraries(${target} PRIVATE ${arg_LINKS} $<BUILD_INTERFACE:pinball_codegen>
                        $<BUILD_INTERFACE:OpenMP::OpenMP_CXX> "$<INSTALL_INTERFACE:${OpenMP_CXX_LIB_NAMES}>")
  set_target_properties(${target} PROPERTIES OUTPUT_NAME pinball-${name} EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  if(type STREQUAL "SHARED")
    set_target_properties(${target} PROPERTIES
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
      LIBRARY_OUTPUT_DIRECTORY ${pinball_library_directory})
    target_link_options(${target} PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/exported.map)
    set_target_properties(${target} PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/exported.map)
    if(NOT PINBALL_SANITIZE)
      # A symbol that is missing shows here, and not in the host. The sanitizers' are the program's to bring.
      target_link_options(${target} PRIVATE -Wl,--no-undefined)
    endif()
  endif()
endfunction()

function(pinball_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OF_PROGRAM" "" "SOURCES;TEXT_SOURCES;API_SOURCES;INTERNALS_OF;LINKS;COMPILES_WITH")
  set(levels none ${PINBALL_HWCAPS})
  foreach(level IN LISTS levels)
    set(suffix "_${level}")
    set(level_option LEVEL ${level})
    if(level STREQUAL "none")
      set(suffix "")
      set(level_option)
    endif()
    set(objects)
    set(sources_of_objects ${arg_SOURCES})
    set(sources_of_text_objects ${arg_TEXT_SOURCES})
    set(sources_of_api_objects ${arg_API_SOURCES})
    foreach(part objects text_objects api_objects)
      set(sources ${sources_of_${part}})
      if(sources)
        pinball_objects(pinball_${name}_${part}${suffix} ${level_option} SOURCES ${sources} COMPILES_WITH ${arg_LINKS} ${arg_COMPILES_WITH})
        list(APPEND objects pinball_${name}_${part}${suffix})
      endif()
    endforeach()
    set(shared_objects ${objects})
    foreach(other IN LISTS arg_INTERNALS_OF)
      foreach(part objects text_objects)
        if(TARGET pinball_${other}_${part}${suffix})
          list(APPEND shared_objects pinball_${other}_${part}${suffix})
        endif()
      endforeach()
    endforeach()

    if(level STREQUAL "none")
      list(TRANSFORM arg_INTERNALS_OF PREPEND pinball_ OUTPUT_VARIABLE others)
      pinball_link_library(pinball_${name} ${name} STATIC OBJECTS ${objects} LINKS ${others} ${arg_LINKS})
      if(BUILD_SHARED_LIBS OR (PINBALL_STATIC_AND_SHARED AND NOT arg_OF_PROGRAM))
        pinball_link_library(pinball_${name}_shared ${name} SHARED OBJECTS ${shared_objects} LINKS ${arg_LINKS})
      endif()
    else()
      pinball_link_library(pinball_${name}${suffix} ${name} SHARED OBJECTS ${shared_objects} LINKS ${arg_LINKS})
      set_target_properties(pinball_${name}${suffix} PROPERTIES
        LIBRARY_OUTPUT_DIRECTORY ${pinball_library_directory}/glibc-hwcaps/${level})
    endif()
  endforeach()
  if(BUILD_SHARED_LIBS)
    add_library(Pinball::${name} ALIAS pinball_${name}_shared)
    if(NOT PINBALL_STATIC_AND_SHARED)
      set_target_properties(pinball_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
  else()
    add_library(Pinball::${name} ALIAS pinball_${name})
  endif()
endfunction()
