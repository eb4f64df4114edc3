# What `cmake --install` puts on a system: programs, menu entry, icons, file type, store page, manual pages, words for
# the shell. Manual pages and words are what ramure-cli says of itself.
set(desktop ${CMAKE_SOURCE_DIR}/resources/desktop)
set(made ${CMAKE_BINARY_DIR}/installed)
set(share ${CMAKE_INSTALL_DATADIR})
set(doc ${share}/doc/ramure)
set(icons ${share}/icons/hicolor)
file(MAKE_DIRECTORY ${made})

# Called with what the file holds, then its name.
function(ramure_say option file)
    set(text "$<TARGET_FILE:ramure-cli> ${option}")
    if(file MATCHES "gz$")
        string(APPEND text " | gzip -9n")
    endif()
    add_custom_command(OUTPUT ${made}/${file} COMMAND sh -c "${text} >${made}/${file}" VERBATIM DEPENDS ramure-cli)
    set_property(GLOBAL APPEND PROPERTY RAMURE_SAID ${made}/${file})
endfunction()
ramure_say(--manual ramure-cli.1.gz)
ramure_say(--manual-editor ramure.1.gz)
ramure_say(--completion completion)
get_property(said GLOBAL PROPERTY RAMURE_SAID)

# Menus that read no SVG take the sizes of the icon theme.
find_program(RSVG_CONVERT rsvg-convert)
set(drawn)
if(RSVG_CONVERT)
    foreach(size 16 24 32 48 64 128 256 512)
        set(picture ${made}/icon-${size}.png)
        add_custom_command(OUTPUT ${picture} DEPENDS ${desktop}/org.ramure.Ramure.svg VERBATIM
            COMMAND ${RSVG_CONVERT} -w ${size} -h ${size} -o ${picture} ${desktop}/org.ramure.Ramure.svg)
        install(FILES ${picture} DESTINATION ${icons}/${size}x${size}/apps RENAME org.ramure.Ramure.png)
        list(APPEND drawn ${picture})
    endforeach()
endif()
add_custom_target(ramure_installed ALL DEPENDS ${said} ${drawn})

install(FILES ${desktop}/org.ramure.Ramure.desktop DESTINATION ${share}/applications)
install(FILES ${desktop}/org.ramure.Ramure.metainfo.xml DESTINATION ${share}/metainfo)
install(FILES ${desktop}/org.ramure.Ramure-mime.xml DESTINATION ${share}/mime/packages RENAME org.ramure.Ramure.xml)
install(FILES ${desktop}/org.ramure.Ramure.svg DESTINATION ${icons}/scalable/apps)
install(FILES ${made}/ramure-cli.1.gz ${made}/ramure.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
foreach(program ramure ramure-cli)
    install(FILES ${made}/completion DESTINATION ${share}/bash-completion/completions RENAME ${program})
endforeach()

# The licence and the changelog as Debian wants them.
file(READ ${CMAKE_SOURCE_DIR}/LICENSE licence)
string(REGEX REPLACE "^[^\n]*\n\n[^\n]*\n\n" "" licence "${licence}") # title and owners stand in the fields above it
string(STRIP "${licence}" licence)
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")
configure_file(${CMAKE_SOURCE_DIR}/resources/package/copyright.in ${made}/copyright @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/resources/package/changelog)
execute_process(COMMAND gzip -9nc ${CMAKE_SOURCE_DIR}/resources/package/changelog OUTPUT_FILE ${made}/changelog.gz)
install(FILES ${made}/copyright ${made}/changelog.gz DESTINATION ${doc})
install(FILES ${made}/copyright ${made}/changelog.gz DESTINATION ${share}/doc/python3-ramure COMPONENT python3-ramure)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/python/examples DESTINATION ${share}/doc/python3-ramure
    COMPONENT python3-ramure FILES_MATCHING PATTERN "*.py")
