# Manual page, and completion for bash and zsh. Both completions have their functions in common, and ask the program for its
# verbs, options, scenes and keys.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${PROJECT_SOURCE_DIR}/packaging/completion/bash ${PROJECT_SOURCE_DIR}/packaging/completion/zsh
             ${PROJECT_SOURCE_DIR}/packaging/completion/help.sh)
set(folder ${PROJECT_SOURCE_DIR}/packaging/completion)
set(completions ${PROJECT_BINARY_DIR}/completions)
foreach(part bash zsh help.sh)
  file(READ ${folder}/${part} ${part})
endforeach()
file(WRITE ${completions}/pinball "${help.sh}\n${bash}")
file(WRITE ${completions}/_pinball "#compdef pinball\n${help.sh}\n${zsh}")
set(PINBALL_ZSH_COMPLETIONS share/zsh/site-functions CACHE STRING "Folder of completions for zsh, relative to the prefix")
install(FILES ${completions}/pinball DESTINATION share/bash-completion/completions COMPONENT program)
install(FILES ${completions}/_pinball DESTINATION ${PINBALL_ZSH_COMPLETIONS} COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/docs/pinball.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
