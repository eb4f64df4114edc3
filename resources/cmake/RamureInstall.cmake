# What `cmake --install` puts on a system: programs, menu entry, icon, file type, store page.
if(NOT RAMURE_CORE_ONLY)
    set(desktop ${CMAKE_SOURCE_DIR}/resources/desktop)
    install(FILES ${desktop}/org.ramure.Ramure.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install(FILES ${desktop}/org.ramure.Ramure.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
    install(FILES ${desktop}/org.ramure.Ramure-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
        RENAME org.ramure.Ramure.xml)
    install(FILES ${desktop}/org.ramure.Ramure.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
    install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
endif()
