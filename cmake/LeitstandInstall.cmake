# What is installed, and the Debian packages that `packaging/leitstand package` makes of it: leitstand, the window, and
# leitstand-tools, all else. Programs look for share/leitstand beside their bin/: folders below the prefix are fixed.
set(doc_tools share/doc/leitstand-tools)
set(doc_window share/doc/leitstand)
set(programs leitstandctl leitstand-robot)
if(TARGET leitstand-guard)
    list(APPEND programs leitstand-guard)
endif()
install(TARGETS ${programs} RUNTIME DESTINATION bin COMPONENT tools)
foreach(folder robots stock control layouts scoring samples)
    install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/${folder} DESTINATION share/leitstand COMPONENT tools
        FILES_MATCHING PATTERN *.yaml PATTERN *.json PATTERN *.db3)
endforeach()
install(FILES ${CMAKE_SOURCE_DIR}/packaging/deb/60-leitstand.conf DESTINATION /etc/sysctl.d COMPONENT tools)
if(TARGET leitstand)
    install(TARGETS leitstand RUNTIME DESTINATION bin COMPONENT window)
    install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/ DESTINATION ${doc_window} COMPONENT window
        FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.svg)
    install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/CHANGELOG.md DESTINATION ${doc_window} COMPONENT window)
    set(desktop ${CMAKE_SOURCE_DIR}/packaging/desktop)
    install(FILES ${desktop}/org.leitstand.leitstand.desktop ${desktop}/org.leitstand.leitstand.robot.desktop
        DESTINATION share/applications COMPONENT window)
    install(FILES ${desktop}/org.leitstand.leitstand.metainfo.xml DESTINATION share/metainfo COMPONENT window)
    install(FILES ${desktop}/leitstand-mime.xml DESTINATION share/mime/packages RENAME leitstand.xml COMPONENT window)
    set(icon ${CMAKE_SOURCE_DIR}/resources/icons/leitstand.svg)
    install(FILES ${icon} DESTINATION share/icons/hicolor/scalable/apps RENAME org.leitstand.leitstand.svg COMPONENT window)
    list(APPEND programs leitstand)
endif()

# What is made of the programs: man pages and completions of their --help, icons of the SVG. Not where a sanitizer slows
# the programs down.
if(LEITSTAND_SANITIZE)
    return()
endif()
set(help ${CMAKE_SOURCE_DIR}/packaging/help)
set(share ${CMAKE_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${share}/man/man1 ${share}/bash-completion/completions ${share}/zsh/vendor-completions)
file(STRINGS ${CMAKE_SOURCE_DIR}/CHANGELOG.md releases REGEX "^## [0-9.]+ \\([0-9-]+\\)")
list(GET releases 0 release)
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" release_date "${release}")
foreach(program ${programs})
    set(component tools)
    if(program STREQUAL "leitstand")
        set(component window)
    endif()
    set(python ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${Python3_EXECUTABLE})
    set(page ${share}/man/man1/${program}.1)
    set(bash ${share}/bash-completion/completions/${program})
    set(zsh ${share}/zsh/vendor-completions/_${program})
    add_custom_command(OUTPUT ${page} ${bash} ${zsh}
        COMMAND ${python} ${help}/man_page.py $<TARGET_FILE:${program}> ${help}/${program}.txt ${PROJECT_VERSION}
            ${release_date} ${page}
        COMMAND ${python} ${help}/completion.py bash ${bash} $<TARGET_FILE:${program}>
        COMMAND ${python} ${help}/completion.py zsh ${zsh} $<TARGET_FILE:${program}>
        DEPENDS ${program} ${help}/man_page.py ${help}/completion.py ${help}/help_text.py ${help}/${program}.txt
        COMMENT "Man page and completions of ${program}" VERBATIM)
    list(APPEND made ${page} ${bash} ${zsh})
    # Debian wants man pages packed, and without a time in them.
    add_custom_command(OUTPUT ${page}.gz COMMAND gzip -9nkf ${page} DEPENDS ${page} VERBATIM)
    list(APPEND made ${page}.gz)
    install(FILES ${page}.gz DESTINATION share/man/man1 COMPONENT ${component})
    install(FILES ${bash} DESTINATION share/bash-completion/completions COMPONENT ${component})
    install(FILES ${zsh} DESTINATION share/zsh/vendor-completions COMPONENT ${component})
endforeach()
if(TARGET leitstand)
    add_executable(leitstand-icons ${desktop}/icons.cpp)
    leitstand_warnings(leitstand-icons)
    target_link_libraries(leitstand-icons PRIVATE Qt6::Svg)
    set(icons ${share}/icons/hicolor)
    foreach(size 16 22 24 32 48 64 128 256 512)
        list(APPEND sizes ${icons}/${size}x${size}/apps/org.leitstand.leitstand.png)
    endforeach()
    add_custom_command(OUTPUT ${sizes} COMMAND leitstand-icons ${icon} ${sizes} DEPENDS leitstand-icons ${icon} VERBATIM)
    list(APPEND made ${sizes})
    install(DIRECTORY ${icons} DESTINATION share/icons COMPONENT window FILES_MATCHING PATTERN *.png)
endif()
# Debian's own changelog is made of CHANGELOG.md.
set(changelog ${CMAKE_BINARY_DIR}/deb/changelog)
add_custom_command(OUTPUT ${changelog}.gz
    COMMAND ${python} ${CMAKE_SOURCE_DIR}/packaging/deb/changelog.py ${CMAKE_SOURCE_DIR}/CHANGELOG.md ${changelog}
    COMMAND gzip -9nkf ${changelog}
    DEPENDS ${CMAKE_SOURCE_DIR}/CHANGELOG.md ${CMAKE_SOURCE_DIR}/packaging/deb/changelog.py VERBATIM)
list(APPEND made ${changelog}.gz)
foreach(component tools window)
    install(FILES ${changelog}.gz DESTINATION ${doc_${component}} COMPONENT ${component})
    install(FILES ${CMAKE_SOURCE_DIR}/packaging/deb/copyright DESTINATION ${doc_${component}} COMPONENT ${component})
endforeach()
add_custom_target(leitstand_desktop_files ALL DEPENDS ${made})

include(LeitstandPackages)
