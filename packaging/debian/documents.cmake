# Run by cpack on what it is about to pack: documents as Debian wants them. Manual pages are compressed; copyright and
# changelog have their names, and the changelog its form.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
set(tree ${CMAKE_CURRENT_LIST_DIR}/../..)
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
set(documents ${root}${CPACK_PACKAGING_INSTALL_PREFIX}/share/doc/${CPACK_PACKAGE_NAME})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The latest version of CHANGELOG.md and its date.
file(READ ${tree}/CHANGELOG.md text)
if(NOT text MATCHES "\n## \\[([0-9.]+)\\] - ([0-9-]+)")
  message(FATAL_ERROR "CHANGELOG.md has no section of a version with its date")
endif()
set(version ${CMAKE_MATCH_1})
if(NOT version STREQUAL CPACK_PACKAGE_VERSION)
  message(FATAL_ERROR "The latest version in CHANGELOG.md is ${version}, and not ${CPACK_PACKAGE_VERSION}")
endif()
execute_process(COMMAND date --utc --rfc-email --date ${CMAKE_MATCH_2} OUTPUT_VARIABLE date
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${documents}/changelog
"${CPACK_PACKAGE_NAME} (${version}) bookworm; urgency=medium

  * What is new: /usr/share/doc/${CPACK_PACKAGE_NAME}/CHANGELOG.md

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")

file(READ ${tree}/LICENSE licence)
file(WRITE ${documents}/copyright
"${CPACK_PACKAGE_DESCRIPTION_SUMMARY}: Pinball, by the Pinball authors.

${licence}")
file(REMOVE ${documents}/LICENSE)
file(CREATE_LINK copyright ${documents}/LICENSE SYMBOLIC)  # pages link it

file(GLOB pages ${root}${CPACK_PACKAGING_INSTALL_PREFIX}/share/man/man*/*.[1-9])
run(gzip -9n ${documents}/changelog ${pages})
run(chmod -R u=rwX,go=rX ${root})
